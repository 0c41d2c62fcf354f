"""Smaller candidates from a draft: parts left out, and simpler numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import gcd, lcm
from typing import Any, Literal

from minkref.certify.plane.predicate import Predicate
from minkref.degeneracies.plane.draft import Draft
from minkref.fuzz.geometry.plane import Shape, extent, mapped, moved, scaled
from minkref.strategies.values import points_of

Operand = Literal["P", "Q"]
Place = tuple[int, ...]  # polygon; its ring, the outer ring being 0; vertex
KINDS = ("polygon", "hole", "vertex")


def places(draft: Draft, kind: str) -> list[tuple[Operand, Place]]:
    """List places that can be left out, the last first: dropping one moves no place that
    follows."""
    found: list[tuple[Operand, Place]] = []
    for name, shape in _operands(draft):
        for i, polygon in enumerate(shape):
            if kind == "polygon":
                found += [(name, (i,))] if len(shape) > 1 else []
                continue
            for j, ring in enumerate(polygon):
                if kind == "hole":
                    found += [(name, (i, j))] if j else []
                elif len(ring) > 3:
                    found += [(name, (i, j, k)) for k in range(len(ring))]
    return found[::-1]


def without(draft: Draft, name: Operand, place: Place) -> Draft | None:
    """Drop a polygon, hole or vertex; None if a ring would keep two vertices, or if the degeneracy
    depends on the vertex."""
    shape = draft.P if name == "P" else draft.Q
    numbers = _numbers(shape)
    gone = {number for number, where in enumerate(numbers) if where[: len(place)] == place}
    if len(place) == 3 and len(shape[place[0]][place[1]]) == 3:
        return None
    left = [n for n in range(len(numbers)) if n not in gone]
    try:
        zeros = tuple(_renumbered(zero, name, left) for zero in draft.zeros)
    except ValueError:  # a dropped vertex
        return None
    rest = _left_out(shape, place)
    P, Q = (rest, draft.Q) if name == "P" else (draft.P, rest)
    return replace(draft, P=P, Q=Q, zeros=zeros)


def simpler() -> tuple[Callable[[Draft], Draft], ...]:
    """List changes to all numbers, applied one after another: P as large as at the scale; both at
    the origin; whole, without a common divisor; few distances between levels, which often loses the
    degeneracy."""
    return (
        lambda d: replace(d, P=scaled(d.P, d.scale), scale=Fraction(1)),
        lambda d: replace(d, P=_at_origin(d.P)),
        lambda d: replace(d, Q=_at_origin(d.Q)),
        _whole,
        lambda d: replace(d, P=_ranked(d.P)),
        lambda d: replace(d, Q=_ranked(d.Q)),
    )


def _operands(draft: Draft) -> tuple[tuple[Operand, Shape], tuple[Operand, Shape]]:
    return ("P", draft.P), ("Q", draft.Q)


def _numbers(shape: Shape) -> list[Place]:
    """List each vertex's place by number."""
    return [
        (i, j, k)
        for i, polygon in enumerate(shape)
        for j, ring in enumerate(polygon)
        for k in range(len(ring))
    ]


def _left_out(shape: Shape, place: Place) -> Shape:
    def keeps(*where: int) -> bool:
        return where != place

    return [
        [
            [point for k, point in enumerate(ring) if keeps(i, j, k)]
            for j, ring in enumerate(polygon)
            if keeps(i, j)
        ]
        for i, polygon in enumerate(shape)
        if keeps(i)
    ]


def _renumbered(zero: Predicate, name: Operand, left: list[int]) -> Predicate:
    """Renumber a predicate's vertices. Raises ValueError for a dropped vertex."""
    operand = ("P", "Q").index(name)

    def entries(value: Any) -> Any:
        if isinstance(value[0], tuple):
            return tuple(entries(entry) for entry in value)
        number = value[operand]
        if number is None:
            return value
        return (*value[:operand], left.index(number), *value[operand + 1 :])

    return zero[0], entries(zero[1])


def _at_origin(shape: Shape) -> Shape:
    x, y, _, _ = extent(points_of(shape))
    return moved(shape, -x, -y)


def _whole(draft: Draft) -> Draft:
    """Scale both operands by the same factor to whole numbers."""
    numbers = [Fraction(c) for shape in (draft.P, draft.Q) for p in points_of(shape) for c in p]
    denominator = lcm(*(number.denominator for number in numbers))
    divisor = gcd(*(int(number * denominator) for number in numbers))
    factor = Fraction(denominator, divisor or 1)
    return replace(draft, P=scaled(draft.P, factor), Q=scaled(draft.Q, factor))


def _ranked(shape: Shape) -> Shape:
    """Replace each coordinate by its rank."""
    xs, ys = (sorted(set(values)) for values in zip(*points_of(shape), strict=True))
    return mapped(shape, lambda p: (xs.index(p[0]), ys.index(p[1])))
