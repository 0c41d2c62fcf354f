"""`python seeded_adapter.py NAME`: a seeded fault, or `sound`, as a program that speaks the adapter
protocol. Answers `at` and `update`; the faults about the scale need it."""

from __future__ import annotations

import json
import sys
from typing import Any

from faults_of_scale import ScaledSum
from seeded_sums import FAULTS

HELLO = {
    "protocol": "adapter-v1",
    "version": "1",
    "language": "Python",
    "arithmetic": "exact",
    "numbers": "text",
    "sum": "region",
    "capabilities": [
        "plane", "non-convex", "holes", "components", "touching", "empty", "point", "segment",
        "rational", "update",
    ],
}  # fmt: skip


def made(name: str) -> ScaledSum:
    """The sum of this name with `load`, `at` and `update`."""
    kind = ScaledSum if name == "sound" else FAULTS[name].make
    if issubclass(kind, ScaledSum):
        return kind()
    return type(kind.__name__, (ScaledSum, kind), {"__init__": kind.__init__})()


def answer(target: ScaledSum, name: str, request: dict[str, Any]) -> dict[str, Any]:
    verb = request["verb"]
    if verb == "hello":
        return {"status": "result", "name": name, **HELLO}
    if verb == "load":
        target.load(request["P"], request["Q"])
        return {"status": "result"}
    if verb in ("at", "update"):
        found = getattr(target, verb)(request["scale"], request["sP"])
        if found is None:
            return {"status": "skipped", "reason": "the sum is no region"}
        return {"status": "result", **found}
    return {"status": "skipped", "reason": f"no verb {verb}"}


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
