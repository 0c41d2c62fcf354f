"""Union certificates' claims, by reference and plain fractions, without the checkers' code."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from minkref import _core
from minkref.fuzz.geometry.plane import Edge, Point, crossing, in_box, read_shape, turn
from minkref.fuzz.unions.union_witness import POINT


class UnionConfirmation:
    """Confirms the claims about one case. Raises BadInput if the case has invalid sets."""

    def __init__(self, case: str) -> None:
        texts = [json.dumps(_with_holes(one)) for one in json.loads(case)["sets"]]
        self.sets = [_core.PolygonSet.from_json(text) for text in texts]
        for k, one in enumerate(self.sets):
            one.validate(f"set {k}")
        self.rings = [[ring for polygon in read_shape(text) for ring in polygon] for text in texts]

    def all_hold(self, claims: Sequence[dict[str, Any]]) -> bool:
        return all(self.holds(claim) for claim in claims)

    def holds(self, claim: dict[str, Any]) -> bool:
        """Decides exactly."""
        return bool(getattr(self, f"_{claim['claim']}")(claim))

    def _union(self, claim: dict[str, Any]) -> bool:
        """Whether valid polygons hold the same points."""
        told = {"polygons": claim["polygons"]}
        region = _core.PolygonSet.from_json(json.dumps(_with_holes(told)))
        region.validate("the union")
        ours, _, _ = _core.combined("union", self.sets)
        theirs, _, _ = _core.combined("union", [region])
        return ours.canonical_json() == theirs.canonical_json()

    def _point(self, claim: dict[str, Any]) -> bool:
        x, y = map(str, claim["point"])
        contacts = [
            _core.decide(one, POINT, "1", x, y)["contact"] if one.rings() else "empty"
            for one in self.sets
        ]
        told = {"overlapping": claim["inside"], "touching": claim["on"]}
        return all(
            [k for k, contact in enumerate(contacts) if contact == word] == numbers
            for word, numbers in told.items()
        )

    def _meet(self, claim: dict[str, Any]) -> bool:
        (point,) = read_shape(json.dumps(_one_point(claim["point"])))[0][0]
        named = [*claim["vertices"], *claim["edges"]]
        edges = map(self._edge, claim["edges"])
        return (
            len({k for k, _ in named}) > 1
            and all(self._vertex(v) == point for v in claim["vertices"])
            and all(point not in edge and _is_on(edge, point) for edge in edges)
        )

    def _overlap(self, claim: dict[str, Any]) -> bool:
        one, other = map(self._edge, claim["edges"])
        common = {p for p in one if _is_on(other, p)} | {p for p in other if _is_on(one, p)}
        same = (one[0] < one[1]) == (other[0] < other[1])
        on_one_line = turn(*one, other[0]) == 0 == turn(*one, other[1])
        return on_one_line and len(common) > 1 and bool(claim["way"] == (1 if same else -1))

    def _sign(self, claim: dict[str, Any]) -> bool:
        kind, named = claim["of"]
        if kind == "orientation":
            p, q, r = map(self._vertex, named)
            return bool(turn(p, q, r) == claim["sign"])
        (a, b), (c, d), last = ([self._vertex(v) for v in line] for line in named)
        if claim["sign"] != 0 or (b[0] - a[0]) * (d[1] - c[1]) == (b[1] - a[1]) * (d[0] - c[0]):
            return False  # ours are of lines that meet in a point
        return turn(last[0], last[1], crossing(a, b, c, d)) == 0

    def _vertex(self, name: Sequence[int]) -> Point:
        k, i = name
        return [p for ring in self.rings[k] for p in ring][i]

    def _edge(self, name: Sequence[int]) -> Edge:
        k, i = name
        for ring in self.rings[k]:
            if i < len(ring):
                return ring[i], ring[(i + 1) % len(ring)]
            i -= len(ring)
        raise IndexError(name)


def _is_on(edge: Edge, p: Point) -> bool:
    return turn(*edge, p) == 0 and in_box(*edge, p)


def _one_point(point: Any) -> dict[str, Any]:
    return {"polygons": [{"outer": [list(map(str, point))], "holes": []}]}


def _with_holes(value: dict[str, Any]) -> dict[str, Any]:
    return {"polygons": [{"holes": [], **polygon} for polygon in value["polygons"]]}
