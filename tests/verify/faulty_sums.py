"""Sums with one deliberate fault each, as targets `py:faulty_sums:NAME` of the tests."""

from __future__ import annotations

import json
import os
import signal
import time
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core

Set = dict[str, Any]


def right(P: Set, Q: Set) -> Set:
    first, second = (_core.PolygonSet.from_json(json.dumps(operand)) for operand in (P, Q))
    value: Set = json.loads(_core.minkowski_sum(first, second, "1").region.canonical_json())
    return value


def loses_holes(P: Set, Q: Set) -> Set:
    result = right(P, Q)
    for polygon in result["polygons"]:
        polygon["holes"] = []
    return result


def shifted(P: Set, Q: Set) -> Set:
    result = right(P, Q)
    for polygon in result["polygons"]:
        for ring in (polygon["outer"], *polygon["holes"]):
            for point in ring:
                point[0] = str(Fraction(point[0]) + Fraction(1, 1000))
    return result


def with_another(P: Set, Q: Set, outer: list[list[str]]) -> Set:
    result = right(P, Q)
    result["polygons"].append({"outer": outer, "holes": []})
    return result


def invents_a_component(P: Set, Q: Set) -> Set:
    return with_another(P, Q, [["1000", "0"], ["1001", "0"], ["1000", "1"]])


def nothing(P: Set, Q: Set) -> Set:
    return {"polygons": []}


def covers_twice(P: Set, Q: Set) -> Set:
    result = right(P, Q)
    result["polygons"] *= 2
    return result


def leaves_a_stub(P: Set, Q: Set) -> Set:
    result = right(P, Q)
    start = result["polygons"][0]["outer"][0]
    result["polygons"].append({"outer": [start, start], "holes": []})
    return result


def dies(P: Set, Q: Set) -> Set:
    os.kill(os.getpid(), signal.SIGSEGV)
    return right(P, Q)


def leaves(P: Set, Q: Set) -> Set:
    os._exit(3)


def hangs(P: Set, Q: Set) -> Set:
    time.sleep(3600)
    return right(P, Q)


def slow_if_small(P: Set, Q: Set) -> Set:
    """Hangs on the first case of the family `random`, and is slow on smaller cases."""
    vertices = sum(len(polygon["outer"]) for each in (P, Q) for polygon in each["polygons"])
    time.sleep(3600 if vertices > 7 else 1)
    return right(P, Q)


def hangs_once(P: Set, Q: Set) -> Set:
    """Runs out of time at the first call only, as on a stalled machine."""
    mark = Path(os.environ["MINKREF_TEST_MARK"])
    if not mark.exists():
        mark.touch()
        time.sleep(3600)
    return right(P, Q)


def raises(P: Set, Q: Set) -> Set:
    raise RuntimeError("this never works")


def exhausts_memory(P: Set, Q: Set) -> Set:
    raise MemoryError


def speaks_nonsense(P: Set, Q: Set) -> Any:
    return {"polygons": [{"outer": "a square"}]}


def answers_in_floats(P: Set, Q: Set) -> Any:
    return {"polygons": [{"outer": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], "holes": []}]}


def declines(P: Set, Q: Set) -> None:
    return None


class Mute(Exception):
    def __str__(self) -> str:
        raise ValueError("no text")


def raises_what_has_no_text(P: Set, Q: Set) -> Set:
    raise Mute


class Spiteful(dict[str, Any]):
    def __getitem__(self, key: str) -> Any:
        raise AttributeError(key)


def answers_with_a_spiteful_object(P: Set, Q: Set) -> Set:
    return Spiteful()


def exits(P: Set, Q: Set) -> Set:
    raise SystemExit(0)


def raises_control_characters(P: Set, Q: Set) -> Set:
    raise RuntimeError("\x1b[31m\x00" + "x" * 100_000)


def prints(P: Set, Q: Set) -> Set:
    print("printed by the target", flush=True)
    os.write(1, b"written by the target\n")
    return right(P, Q)


def runs_the_other_way(P: Set, Q: Set) -> Set:
    result = right(P, Q)
    for polygon in result["polygons"]:
        polygon["outer"].reverse()
        polygon["holes"] = [hole[::-1] for hole in polygon["holes"]]
    return result


def adds_a_flat_ring(P: Set, Q: Set) -> Set:
    return with_another(P, Q, [["0", "0"], ["1", "1"], ["2", "2"]])


def answers_in_long_numbers(P: Set, Q: Set) -> Set:
    long = 10**5000
    return {"polygons": [{"outer": [[long, 0], [long + 1, 0], [long, 1]], "holes": []}]}


not_callable = 3
