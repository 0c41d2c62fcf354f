"""Hostile functions, for `py:functions:NAME`, which spoil the program around them."""

from __future__ import annotations

import builtins
import json
import os
import sys
import threading
import time
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NoReturn

from bounds import bind, fork

Set = dict[str, Any]
SQUARE: Set = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["1", "1"]], "holes": []}]}


def exits(sP: Set, Q: Set) -> NoReturn:
    sys.exit(70)


def exits_hard(sP: Set, Q: Set) -> NoReturn:
    os._exit(0)


def interrupts(sP: Set, Q: Set) -> NoReturn:
    raise KeyboardInterrupt


def runs_out_of_memory(sP: Set, Q: Set) -> NoReturn:
    raise MemoryError


def closes_everything(sP: Set, Q: Set) -> Set:
    os.closerange(0, 256)
    return SQUARE


def prints_answers(sP: Set, Q: Set) -> Set:
    """On both streams, as lines of a protocol and as noise."""
    for seq in range(40):
        line = json.dumps({"seq": seq, "status": "result", "polygons": [], "ok": True})
        print(line, flush=True)
        os.write(1, line.encode() + b"\n")
    os.write(2, b"\xff\x00" * 100_000)
    return SQUARE


def spoils_builtins(sP: Set, Q: Set) -> Set:
    builtins.len = lambda *_: 0  # type: ignore[assignment]
    builtins.isinstance = lambda *_: True  # type: ignore[assignment]
    json.dumps = lambda *_, **__: '{"seq": 1, "status": "result", "polygons": []}'
    json.loads = lambda *_, **__: {}
    return SQUARE


def spoils_the_reference(sP: Set, Q: Set) -> Set:
    """Replaces all members of every loaded reference module."""
    for name, module in list(sys.modules.items()):
        if name.startswith("minkref"):
            for member in list(vars(module)):
                if not member.startswith("__"):
                    setattr(module, member, lambda *_, **__: SQUARE)
    return SQUARE


def traces(sP: Set, Q: Set) -> Set:
    sys.settrace(lambda *_: None)
    sys.setrecursionlimit(50)
    sys.excepthook = lambda *_: os._exit(0)
    threading.Thread(target=time.sleep, args=(30,)).start()
    return SQUARE


class Evil(dict[str, Any]):
    """A dictionary that changes at each look."""

    def __getitem__(self, key: str) -> Any:
        os._exit(0)

    def items(self) -> Any:
        raise RuntimeError("no items")

    def __len__(self) -> int:
        return -1


def returns_evil(sP: Set, Q: Set) -> Any:
    return Evil(SQUARE)


def returns_itself(sP: Set, Q: Set) -> Any:
    """A list that contains itself."""
    ring: list[Any] = []
    ring.append(ring)
    return {"polygons": [{"outer": ring, "holes": ring}]}


def returns_without_end(sP: Set, Q: Set) -> Any:
    def points() -> Iterator[list[str]]:
        while True:
            yield ["0", "1"]

    return {"polygons": [{"outer": points(), "holes": []}]}


def returns_objects(sP: Set, Q: Set) -> Any:
    values = [object(), Fraction(1, 3), b"1", 1j, float("nan"), 10**5000, {1, 2}, "\udc80"]
    return {"polygons": [{"outer": [[value, value] for value in values], "holes": []}]}


def changes_its_operands(sP: Set, Q: Set) -> Set:
    sP["polygons"] = Q["polygons"] = []
    return {"polygons": []}


def forks(sP: Set, Q: Set) -> Set:
    """Both go on, and both answer."""
    bind()
    fork()
    return SQUARE


def deep(sP: Set, Q: Set) -> Any:
    value: Any = []
    for _ in range(200_000):
        value = [value]
    return {"polygons": value}


FUNCTIONS = (
    *(exits, exits_hard, interrupts, runs_out_of_memory, closes_everything, prints_answers),
    *(spoils_builtins, spoils_the_reference, traces, returns_evil, returns_itself),
    *(returns_without_end, returns_objects, changes_its_operands, forks, deep),
)
for _function in FUNCTIONS:
    _function.minkref = {  # type: ignore[attr-defined]
        "arithmetic": "exact",
        "capabilities": ["plane", "rational"],
    }
