"""A set grown by a disc as rings of circles and lines: the canonical form (docs/disc.md)."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import MOST_VERTICES, Unreadable, received

Curve = tuple[Any, ...]  # "arc" x y; "line" dx dy c; numbers are fractions
Ring = tuple[Curve, ...]
Component = tuple[Ring, tuple[Ring, ...]]  # the outer ring, and the holes
NOTHING = '{"components":[]}'
LENGTHS = {"arc": 3, "line": 4}


def read_curves(value: Any, declaration: Declaration) -> str:
    """Returns the canonical text of components: rings begin anywhere, and come in any order. Raises
    Unreadable."""
    if not isinstance(value, list):
        raise Unreadable("components is not a list")
    found: list[Component] = []
    count = 0
    for each in value:
        if not isinstance(each, dict) or not isinstance(each.get("holes", []), list):
            raise Unreadable("a component has no outer ring, or holes that are no list")
        rings = [_ring(ring, declaration) for ring in (each.get("outer"), *each.get("holes", []))]
        count += sum(map(len, rings))
        if count > MOST_VERTICES:
            raise Unreadable(f"more than {MOST_VERTICES:,} curves")
        found.append((rings[0], tuple(sorted(rings[1:]))))
    return written(sorted(found))


def _ring(value: Any, declaration: Declaration) -> Ring:
    if not isinstance(value, list) or not value:
        raise Unreadable("a ring is not a list of curves")
    curves = [_curve(each, declaration) for each in value]
    kept = [curve for k, curve in enumerate(curves) if curve != curves[k - 1]]
    return least(kept or curves[:1])


def _curve(value: Any, declaration: Declaration) -> Curve:
    kind = value[0] if isinstance(value, list) and value else None
    if not isinstance(kind, str) or LENGTHS.get(kind) != len(value):
        raise Unreadable('a curve is neither ["arc", x, y] nor ["line", dx, dy, c]')
    numbers = [Fraction(received(number, declaration)) for number in value[1:]]
    if kind == "line":
        if not (numbers[0] or numbers[1]):
            raise Unreadable("a line has no direction")
        numbers = _primitive(numbers)
    return (kind, *numbers)


def _primitive(numbers: Sequence[Fraction]) -> list[Fraction]:
    """The same line with coprime whole numbers as its direction."""
    common = lcm(numbers[0].denominator, numbers[1].denominator)
    divisor = gcd(int(numbers[0] * common), int(numbers[1] * common))
    return [number * common / divisor for number in numbers]


def least(ring: Sequence[Curve]) -> Ring:
    """Begins the ring so that its list of curves becomes least: `arc` comes before `line`."""
    start = min(range(len(ring)), key=lambda k: (*ring[k:], *ring[:k]))
    return (*ring[start:], *ring[:start])


def written(components: Sequence[Component]) -> str:
    def ring(curves: Ring) -> list[list[str]]:
        return [[str(part) for part in curve] for curve in curves]

    value = [
        {"holes": [ring(hole) for hole in holes], "outer": ring(outer)}
        for outer, holes in components
    ]
    return json.dumps({"components": value}, separators=(",", ":"))


def form_of(canonical: str) -> str:
    """A canonical form's components, written like `read_curves` does."""
    return read_curves(json.loads(canonical)["components"], Declaration("minkref"))


def components_of(text: str) -> list[Component]:
    """Reads what `read_curves` wrote."""

    def ring(curves: list[list[str]]) -> Ring:
        return tuple((kind, *map(Fraction, numbers)) for kind, *numbers in curves)

    return [
        (ring(each["outer"]), tuple(ring(hole) for hole in each["holes"]))
        for each in json.loads(text)["components"]
    ]


def rings_in(text: str) -> list[Ring]:
    return [ring for outer, holes in components_of(text) for ring in (outer, *holes)]


def counts_of(text: str) -> tuple[int, int]:
    """Components and holes."""
    found = json.loads(text)["components"]
    return len(found), sum(len(each["holes"]) for each in found)
