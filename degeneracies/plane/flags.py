"""Flags for cases in the plane: a case's facts decide each flag. flags.json says the meaning of
each flag, the methods that it breaks, and known victims."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.case_text import ring_numbers
from minkref.certify.plane.predicate import Place
from minkref.degeneracies.plane.draft import Facts
from minkref.fuzz.geometry.plane import in_box, turn

CLOSE = 60  # another critical scale is within 2^-60
FAR = 10**6  # times the operands' extent
APART = 10**6  # the least and the greatest number of a case
MANY = 2  # times the vertices of both operands
LIMITS = {n for bits in (31, 32, 53, 62, 63, 64) for n in (2**bits - 1, 2**bits)}
LARGE, SMALL = Fraction(2) ** 1020, Fraction(1, 2**1020)
ORIGIN = '{"polygons":[{"outer":[["0","0"]]}]}'


def explained() -> dict[str, dict[str, Any]]:
    """Explanations of all flags, in the plane and in space."""
    text = Path(__file__).with_name("flags.json").read_text(encoding="utf-8")
    value: dict[str, dict[str, Any]] = json.loads(text)
    return value


def flags_of(facts: Facts) -> list[str]:
    """All flags that hold, in alphabetical order. Exact."""
    return sorted(name for name, holds in FLAGS.items() if holds(facts))


def _of_holes(*changes: str) -> Callable[[Facts], bool]:
    return lambda facts: any(
        row["feature"] == "hole" and row["change"] in changes for row in facts.topology
    )


def _more_holes_above(facts: Facts) -> bool:
    (_, below), _, (_, above) = facts.counts
    return above > below or _of_holes("birth")(facts)


def _components(facts: Facts) -> bool:
    return any(row["feature"] == "component" for row in facts.topology)


def _collinear(facts: Facts) -> bool:
    for vertices, operand in ((facts.vertices.P, facts.P), (facts.vertices.Q, facts.Q)):
        for ring in ring_numbers(operand):
            at = [vertices[i] for i in ring]
            if len(at) > 2 and any(turn(at[k - 2], at[k - 1], at[k]) == 0 for k in range(len(at))):
                return True
    return False


def three_lines_meet(facts: Facts, row: dict[str, Any]) -> bool:
    """Whether no two lines through the edges of a triple event are parallel."""
    spans = [facts.convolution.ends(edge) for edge in row["edges"]]
    directions = [(b[0] - a[0], b[1] - a[1]) for a, b in spans]
    return all(u[0] * v[1] != u[1] * v[0] for u, v in combinations(directions, 2))


def _concurrent(facts: Facts) -> bool:
    return any(
        row["kind"] == "triple" and three_lines_meet(facts, row) for row in facts.arrangement
    )


def _parallel(facts: Facts) -> bool:
    return bool(_directions(facts, 0) & _directions(facts, 1))


def _directions(facts: Facts, side: int) -> set[Fraction | None]:
    """Slopes of an operand's edges, None for upright edges."""
    vertices, operand = ((facts.vertices.P, facts.P), (facts.vertices.Q, facts.Q))[side]
    found: set[Fraction | None] = set()
    for ring in ring_numbers(operand):
        for k in range(len(ring)):
            (x, y), (u, v) = vertices[ring[k - 1]], vertices[ring[k]]
            if (x, y) != (u, v):
                found.add((v - y) / (u - x) if u != x else None)
    return found


def at_limits(numbers: Iterable[Fraction]) -> bool:
    sizes = {abs(c) for c in numbers} - {0}
    return bool(sizes & LIMITS) or max(sizes) > LARGE or min(sizes) < SMALL


def far_apart(numbers: Iterable[Fraction]) -> bool:
    sizes = {abs(c) for c in numbers} - {0}
    return max(sizes) > APART * min(sizes)


def far_out(vertices: Iterable[tuple[Fraction, ...]]) -> bool:
    """Whether the vertices lie farther from the origin than their extent, by a factor."""
    columns = list(zip(*vertices, strict=True))
    extent = max(max(c) - min(c) for c in columns)
    away = max(min(map(abs, c)) for c in columns)
    return bool(away > FAR * extent > 0)


def _origin_outside(facts: Facts) -> bool:
    origin = _core.PolygonSet.from_json(ORIGIN)
    return bool(_core.decide(facts.P, origin, "1", "0", "0")["contact"] == "empty")


def _touching(facts: Facts) -> bool:
    """Whether a vertex lies on another part of its operand's boundary."""
    for vertices, operand in ((facts.vertices.P, facts.P), (facts.vertices.Q, facts.Q)):
        if len(set(vertices)) < len(vertices):
            return True
        edges = [
            (vertices[ring[k - 1]], vertices[ring[k]])
            for ring in ring_numbers(operand)
            for k in range(len(ring))
        ]
        if any(v not in edge and _is_on(v, *edge) for v in vertices for edge in edges):
            return True
    return False


def _is_on(p: Place, a: Place, b: Place) -> bool:
    return in_box(a, b, p) and turn(a, b, p) == 0


def _vanishing(facts: Facts) -> bool:
    return _holes(facts.P) + _holes(facts.Q) > facts.at.holes


def _holes(operand: _core.PolygonSet) -> int:
    polygons = json.loads(operand.to_json())["polygons"]
    return sum(len(polygon["holes"]) for polygon in polygons)


def _large_sum(facts: Facts) -> bool:
    return facts.at.region.vertices > MANY * (facts.P.vertices + facts.Q.vertices)


def is_no_double(number: Fraction) -> bool:
    try:
        return Fraction(float(number)) != number
    except OverflowError:
        return True


FLAGS: dict[str, Callable[[Facts], bool]] = {
    "antenna": lambda facts: facts.convolution.runs_back(),
    "close-scales": lambda facts: facts.gap > CLOSE,
    "collinear-vertices": _collinear,
    "components": _components,
    "concurrent": _concurrent,
    "event": lambda facts: bool(facts.arrangement),
    "hole-closes": _of_holes("death"),
    "hole-opens": _more_holes_above,
    "holes-merge": _of_holes("merge"),
    "large-sum": _large_sum,
    "large-translation": lambda facts: far_out(facts.vertices.P) or far_out(facts.vertices.Q),
    "limits": lambda facts: at_limits(facts.coordinates),
    "magnitudes": lambda facts: far_apart((*facts.coordinates, facts.scale)),
    "origin-outside": _origin_outside,
    "overlap": lambda facts: facts.convolution.overlaps(),
    "parallel-edges": _parallel,
    "scale-is-no-float": lambda facts: is_no_double(facts.scale),
    "several-events": lambda facts: len({row["at"] for row in facts.arrangement}) > 1,
    "tight-passage": lambda facts: bool(facts.passages),
    "touching-rings": _touching,
    "vanishing-holes": _vanishing,
    "winding-zero": lambda facts: facts.wound_zero_times is not None,
}
