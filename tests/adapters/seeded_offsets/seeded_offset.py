"""`python seeded_offset.py NAME`: a seeded fault of the verb `offset` (offset_faults.py, there also
by number, 0 for none; sharp_faults.py) or a right one (right_offsets.py), as a program that speaks
the adapter protocol."""

from __future__ import annotations

import json
import sys
from typing import Any

from offset_faults import FAULTS
from right_offsets import RIGHT, Inside
from sharp_faults import SHARP_FAULTS

HELLO = {
    "protocol": "adapter-v1",
    "version": "1",
    "language": "Python",
    "arithmetic": "float64",
    "numbers": "double",
    "sum": "none",
}
ABLE = (
    "plane", "non-convex", "holes", "components", "touching", "empty", "point", "segment",
    "offset", "inset", "line-offset", "join-mitre", "join-bevel", "join-square", "cap-flat",
    "cap-square",
)  # fmt: skip


def made(name: str) -> Any:
    """The implementation of this name or number."""
    named: dict[str, type[Any]] = {**RIGHT, **SHARP_FAULTS}
    named |= {fault.__name__: fault for fault in FAULTS}
    return named[name]() if name in named else FAULTS[int(name)]()


def answer(target: Any, name: str, request: dict[str, Any]) -> dict[str, Any]:
    if request["verb"] == "hello":
        lacks = getattr(target, "lacks", ())
        return {
            "status": "result",
            "name": f"offset-{name}",
            "tolerance": getattr(target, "tolerance", Inside.tolerance),
            **HELLO,
            "capabilities": [w for w in getattr(target, "able", ABLE) if w not in lacks],
        }
    if request["verb"] != "offset":
        return {"status": "skipped", "reason": "no such verb"}
    how = {word: request[word] for word in ("join", "limit", "cap") if word in request}
    return {"status": "result", **target.answer(request["P"], request["radius"], how)}


def main(name: str) -> None:
    target = made(name)
    for line in sys.stdin:
        request = json.loads(line)
        try:
            told = answer(target, name, request)
        except Exception as error:  # noqa: BLE001 a fault of the seeded kind
            told = {"status": "errored", "reason": repr(error)}
        sys.stdout.write(json.dumps({"seq": request["seq"], **told}) + "\n")
        sys.stdout.flush()
        if request["verb"] == "stop":
            return


if __name__ == "__main__":
    main(sys.argv[1])
