"""An adapter in space for tests: sums of convex polyhedra, in a way that the argument names.

right             the sum; a scale has to be as the page of the protocol says
unused-vertices   with vertices that no face names
update-cube       `update` answers a unit cube
update-stale      `update` answers the sum at the scale of the last `at`
fickle            every third answer is a unit cube
"""

from __future__ import annotations

import json
import sys
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.convex_sum import true_sum

CUBE = {
    "vertices": [["0", "0", "0"], ["1", "0", "0"], ["1", "1", "0"], ["0", "1", "0"],
                 ["0", "0", "1"], ["1", "0", "1"], ["1", "1", "1"], ["0", "1", "1"]],
    "faces": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
}  # fmt: skip
HELLO = {
    "protocol": "adapter-v1",
    "name": "in space",
    "capabilities": ["space", "rational", "non-uniform", "update"],
}


def check_scale(scale: Any) -> None:
    if isinstance(scale, list):
        assert len(scale) == 3
    for factor in scale if isinstance(scale, list) else [scale]:
        assert isinstance(factor, str) and "," not in factor, scale


class Adapter:
    def __init__(self, way: str) -> None:
        self.way = way
        self.answers = 0
        self.last: dict[str, Any] = {}
        self.Q = Polyhedron((), ())

    def answer(self, request: dict[str, Any]) -> dict[str, Any]:
        verb = request["verb"]
        if verb == "hello":
            return HELLO
        if verb == "load":
            self.Q = Polyhedron.from_document(request["Q"])
        if verb not in ("at", "update"):
            return {}
        check_scale(request["scale"])
        self.answers += 1
        if self.way == "update-stale" and verb == "update":
            return self.last
        result = true_sum(Polyhedron.from_document(request["sP"]), self.Q, 1).document()
        self.last = result
        if (self.way == "update-cube" and verb == "update") or (
            self.way == "fickle" and self.answers % 3 == 0
        ):
            return CUBE
        if self.way == "unused-vertices":
            result["vertices"] += [["1000", "0", "1/3"], ["-1000", "7", "5"]]
        return result


def main(way: str) -> None:
    adapter = Adapter(way)
    for line in sys.stdin:
        request = json.loads(line)
        answer = {"seq": request["seq"], "status": "result", **adapter.answer(request)}
        print(json.dumps(answer), flush=True)
        if request["verb"] == "stop":
            return


main(sys.argv[1])
