"""Functions that tell in an exception's text their observations, or the outcome of a try of
`isolated_adapter.py`; as targets `py:isolated_functions:NAME`."""

from __future__ import annotations

import json
import os
import sys
from typing import Any, NoReturn

from isolated_adapter import TRIES

Set = dict[str, Any]


class Told(Exception):
    pass


def tries(P: Set, Q: Set) -> NoReturn:
    """Tries the thing that the variable MINKREF_TRY names, at the first call."""
    what, _, argument = os.environ["MINKREF_TRY"].partition(" ")
    try:
        said = TRIES[what](argument)
    except OSError as error:
        said = f"not: {error.strerror or error}"
    raise Told(said)


def operands(P: Set, Q: Set) -> NoReturn:
    seen = json.dumps([P, Q])
    P.clear()
    Q.clear()
    raise Told(seen)


def doubles(P: Set, Q: Set) -> NoReturn:
    points = [point for each in (P, Q) for point in each["polygons"][0]["outer"]]
    raise Told(" ".join(float.hex(number) for point in points for number in point))


doubles.minkref = {"numbers": "double"}  # type: ignore[attr-defined]


def modules(P: Set, Q: Set) -> NoReturn:
    """Names the process's minkref modules."""
    raise Told(" ".join(name for name in sys.modules if name.startswith("minkref")) or "none")


def input_there(P: Set, Q: Set) -> NoReturn:
    raise Told(repr(sys.stdin.read() + os.read(0, 100).decode()))


def two_answers(P: Set, Q: Set) -> NoReturn:
    os.write(1, b'{"seq": 3, "status": "result", "polygons": []}\n')
    print('{"seq": 3, "status": "result", "polygons": []}', flush=True)
    raise Told("printed")


def long_integer(P: Set, Q: Set) -> Set:
    """A square, spelled with more digits than Python writes unless it is told to."""
    far = 10**9_000
    ring = [[0, 0], [far, 0], [far, far], [0, far]]
    return {"polygons": [{"outer": ring, "holes": []}]}


def raises_value_error(P: Set, Q: Set) -> NoReturn:
    raise ValueError("never valid")


raises_value_error.minkref = {  # type: ignore[attr-defined]
    "capabilities": ["plane", "rejects-invalid", "non-convex", "holes", "components", "touching"]
}
