"""A right adapter with a choice of forms: `right_adapter.py FORM`."""

from __future__ import annotations

import json
import random
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

from adapter import CAPABILITIES, Adapter, Set

Ring = list[list[Any]]
FORMS: dict[str, type[Adapter]] = {}
WITHOUT_RATIONAL = [word for word in CAPABILITIES.split() if word != "rational"]


def form(name: str, change: Callable[[Set], Any], **members: Any) -> None:
    class Form(Adapter):
        def hello(self) -> Set:
            return {**super().hello(), "name": name, **members}

        def sum_of(self, sP: Set, Q: Set) -> Any:
            return change(super().sum_of(sP, Q))

    FORMS[name] = Form


def each_ring(value: Set, change: Callable[[Ring], Any]) -> Set:
    return {
        "polygons": [
            {"outer": change(each["outer"]), "holes": [change(hole) for hole in each["holes"]]}
            for each in value["polygons"]
        ]
    }


def flat(value: Set) -> Set:
    return {"rings": [ring for p in value["polygons"] for ring in (p["outer"], *p["holes"])]}


def rotated(ring: Ring) -> Ring:
    at = random.randrange(len(ring))
    return ring[at:] + ring[:at]


def with_middles(ring: Ring) -> Ring:
    points = []
    for a, b in pairwise([*ring, ring[0]]):
        middle = [str((Fraction(x) + Fraction(y)) / 2) for x, y in zip(a, b, strict=True)]
        points += [a, middle]
    return points


def shuffled(value: Set) -> Set:
    for polygon in value["polygons"]:
        random.shuffle(polygon["holes"])
    random.shuffle(value["polygons"])
    return value


def triangles(value: Set) -> list[Ring]:
    from minkref import _core

    # Slabs between the heights of all vertices and crossings, each cut into triangles.
    text = json.dumps(value)
    if not _core.PolygonSet.from_json(text).is_region:
        return []
    rings = flat(value)["rings"]
    edges = [
        tuple(sorted(((Fraction(y), Fraction(x)) for x, y in pair)))
        for ring in rings
        for pair in pairwise([*ring, ring[0]])
    ]
    heights = sorted({point[0] for edge in edges for point in edge})
    found: list[Ring] = []
    for low, high in pairwise(heights):
        across = sorted(
            (at(edge, low), at(edge, high))
            for edge in edges
            if edge[0][0] <= low < edge[1][0] and edge[1][0] >= high
        )
        for (a, d), (b, c) in zip(across[::2], across[1::2], strict=True):
            corners = [(a, low), (b, low), (c, high), (d, high)]
            for one, two, three in ((0, 1, 2), (0, 2, 3)):
                triangle = [corners[one], corners[two], corners[three]]
                if len(set(triangle)) == 3:
                    found.append([[str(x), str(y)] for x, y in triangle])
    return found


def at(edge: Any, y: Fraction) -> Fraction:
    (y0, x0), (y1, x1) = edge
    return x0 + (x1 - x0) * (y - y0) / (y1 - y0)


def double(ring: Ring) -> Ring:
    return [[float(Fraction(x)), float(Fraction(y))] for x, y in ring]


def on_grid(ring: Ring) -> Ring:
    return [[str(Fraction(round(Fraction(x) * 8), 8)) for x in point] for point in ring]


DOUBLE = {
    "arithmetic": "float64",
    "numbers": "double",
    "tolerance": {"absolute": "0", "relative": "1e-15"},
    "capabilities": WITHOUT_RATIONAL,
}
GRID = {"arithmetic": "integer-grid", "tolerance": {"absolute": "1/16", "relative": "0"}}

form("as-it-is", lambda value: value)
form("other-way", lambda value: each_ring(value, lambda ring: ring[::-1]))
form("rotated", lambda value: each_ring(value, rotated))
form("with-middles", lambda value: each_ring(value, with_middles))
form("with-duplicates", lambda value: each_ring(value, lambda r: [p for p in r for _ in (0, 1)]))
form("shuffled", shuffled)
form("flat-rings", flat)
form("flat-rings-shuffled", lambda v: {"rings": random.sample(r := flat(v)["rings"], len(r))})
form("triangles", lambda value: {"rings": triangles(value)})
form(
    "triangle-polygons",
    lambda value: {"polygons": [{"outer": ring, "holes": []} for ring in triangles(value)]},
)
form("rings-twice", lambda value: {"rings": flat(value)["rings"] * 2})
form("double", lambda value: each_ring(value, double), **DOUBLE)
form("double-rings", lambda value: {"rings": [double(r) for r in flat(value)["rings"]]}, **DOUBLE)
form("grid", lambda value: each_ring(value, on_grid), **GRID)
form("grid-rings", lambda value: {"rings": [on_grid(r) for r in flat(value)["rings"]]}, **GRID)


class Boundary(Adapter):
    """The sum of the boundaries: the parallelograms of all edge pairs."""

    def hello(self) -> Set:
        return {**super().hello(), "name": "boundary", "sum": "boundary"}

    def sum_of(self, sP: Set, Q: Set) -> Any:
        rings = []
        for a, u in edges_of(sP):
            for b, v in edges_of(Q):
                turn = u[0] * v[1] - u[1] * v[0]
                if turn:
                    start = (a[0] + b[0], a[1] + b[1])
                    corners = [(0, 0), u, (u[0] + v[0], u[1] + v[1]), v][:: 1 if turn > 0 else -1]
                    rings.append([[str(start[0] + x), str(start[1] + y)] for x, y in corners])
        return {"rings": rings}


def edges_of(value: Set) -> Iterator[tuple[Any, Any]]:
    for ring in flat(value)["rings"]:
        points = [(Fraction(x), Fraction(y)) for x, y in ring]
        for a, b in pairwise([*points, points[0]]):
            yield a, (b[0] - a[0], b[1] - a[1])


class Everything(Adapter):
    """All capabilities of the plane, told from the reference."""

    def hello(self) -> Set:
        words = [*CAPABILITIES.split(), "rejects-invalid", "update", "events"]
        return {**super().hello(), "name": "everything", "capabilities": words}

    def load(self, request: Set) -> Set:
        from minkref import _core

        self.P = request["P"]
        self.why = ""
        for name in "PQ":
            try:
                _core.PolygonSet.from_json(json.dumps(request[name])).validate(name)
            except Exception as error:  # noqa: BLE001 a refusal
                self.why = str(error)
                return {"status": "rejected", "reason": self.why}
        return super().load(request)

    def at(self, request: Set) -> Set:
        if self.why:
            return {"status": "rejected", "reason": self.why}
        return super().at(request)

    def answer(self, request: Set) -> Set:
        if request["verb"] == "events":
            from minkref import _core

            first, second = (
                _core.PolygonSet.from_json(json.dumps(operand)) for operand in (self.P, self.Q)
            )
            walk = _core.DynamicSum(first, second, request["from"], request["to"])
            scales = {Fraction(row[0]) for row in walk.topology_events()}
            return {"status": "result", "scales": [str(s) for s in sorted(scales)]}
        return super().answer(request)


FORMS |= {"boundary": Boundary, "everything": Everything}

if __name__ == "__main__":
    FORMS[sys.argv[1]]().serve()
