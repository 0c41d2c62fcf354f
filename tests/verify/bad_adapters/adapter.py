"""A right adapter; deliberately bad adapters replace single steps."""

from __future__ import annotations

import json
import os
import sys
from typing import Any

Set = dict[str, Any]
CAPABILITIES = "plane non-convex holes components touching empty point segment rational"


class Adapter:
    """A right, exact adapter for the plane, with `at` and `update`."""

    argument = ""
    arithmetic: Any = "exact"

    def __init__(self) -> None:
        self.Q: Set = {}
        self.calls = 0

    def hello(self) -> Set:
        return {
            "protocol": "adapter-v1",
            "name": "bad",
            "version": "1",
            "language": "Python",
            "arithmetic": self.arithmetic,
            "numbers": "text",
            "sum": "region",
            "capabilities": CAPABILITIES.split(),
        }

    def sum_of(self, sP: Set, Q: Set) -> Any:
        from minkref import _core  # the answer to `hello` does not wait for it

        first, second = (_core.PolygonSet.from_json(json.dumps(operand)) for operand in (sP, Q))
        return json.loads(_core.minkowski_sum(first, second, "1").region.canonical_json())

    def at(self, request: Set) -> Set:
        return {"status": "result", **self.sum_of(request["sP"], self.Q)}

    def update(self, request: Set) -> Set:
        return self.at(request)

    def load(self, request: Set) -> Set:
        self.Q = request["Q"]
        return {"status": "result"}

    def answer(self, request: Set) -> Set:
        verb = request["verb"]
        if verb == "hello":
            return {"status": "result", **self.hello()}
        if verb == "load":
            return self.load(request)
        if verb == "at":
            self.calls += 1
            return self.at(request)
        if verb == "update":
            return self.update(request)
        if verb == "stop":
            return {"status": "result"}
        return {"status": "skipped", "reason": "no such verb here"}

    def line(self, request: Set) -> str:
        return json.dumps({"seq": request["seq"], **self.answer(request)})

    def write(self, text: str | bytes) -> None:
        left = text if isinstance(text, bytes) else text.encode()
        while left:
            left = left[os.write(1, left) :]

    def handle(self, request: Set) -> None:
        self.write(self.line(request) + "\n")

    def serve(self) -> None:
        for line in sys.stdin.buffer:
            request = json.loads(line)
            self.handle(request)
            if request["verb"] == "stop":
                return
