"""Laws for sums in space, on one route: how the sum changes with its operands. Exact."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.judges.space.space_routes import Route
from minkref.fuzz.judges.space.space_sums import moved
from minkref.fuzz.space.convex_sum import true_sum
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.fuzz.space.generators.mapped import IDENTITY, Matrix, mapped, unimodular
from minkref.fuzz.space.hull import convex_hull
from minkref.fuzz.space.laws import refined
from minkref.oracle.slow import Exposed, exposed_from_json
from minkref.oracle.slow.space.exposed import lifted, rings_of
from minkref.oracle.slow.space.solid_claim import inner_point, winding

ORIGIN: Point = (Fraction(0), Fraction(0), Fraction(0))
ONE = Fraction(1)
Law = Callable[[GeneralPair, Route, str, random.Random], Iterator[bool]]


def translation(pair: GeneralPair, route: Route, text: str, dice: random.Random) -> Iterator[bool]:
    """s(P + t) + (Q + u) is sP + Q moved by s t + u."""
    t, u = _vector(dice), _vector(dice)
    found = route(pair.P.translated(t), pair.Q.translated(u), pair.scale)
    x, y, z = (pair.scale * a + b for a, b in zip(t, u, strict=True))
    yield found == moved(text, IDENTITY, (x, y, z))


def unimodular_map(
    pair: GeneralPair, route: Route, text: str, dice: random.Random
) -> Iterator[bool]:
    """Under a signed permutation, and under another matrix of GL(3, Z)."""
    for steps in (0, 2):
        matrix: Matrix = unimodular(dice, steps)
        found = route(mapped(matrix, pair.P), mapped(matrix, pair.Q), pair.scale)
        yield found == moved(text, matrix, ORIGIN)


def commutativity(
    pair: GeneralPair, route: Route, text: str, dice: random.Random
) -> Iterator[bool]:
    """sP + Q is 1 Q + sP, and s(P + Q/s)."""
    yield route(pair.Q, pair.P.scaled(pair.scale), ONE) == text
    yield route(pair.P.scaled(pair.scale), pair.Q, ONE) == text


def refinement(pair: GeneralPair, route: Route, text: str, dice: random.Random) -> Iterator[bool]:
    """Cutting faces into triangles, and every edge and triangle into parts, keeps the sets."""
    for cut in (_in_triangles, refined):
        P, Q = (solid if solid.is_thin else cut(solid) for solid in (pair.P, pair.Q))
        if P.fault() is None and Q.fault() is None:
            yield route(P, Q, pair.scale) == text


def hull(pair: GeneralPair, route: Route, text: str, dice: random.Random) -> Iterator[bool]:
    """The hull of the sum equals the sum of the hulls, and contains the sum."""
    corners = _corners(exposed_from_json(json.loads(text)))
    P, Q = (solid if solid.is_thin else convex_hull(solid.vertices) for solid in (pair.P, pair.Q))
    whole = true_sum(P, Q, pair.scale)
    yield convex_hull(corners).volume == whole.volume
    convex = exposed_from_json(json.loads(route(P, Q, pair.scale)))
    yield convex.volume() == whole.volume
    yield set(_corners(convex)) <= set(corners)


def distributivity(
    pair: GeneralPair, route: Route, text: str, dice: random.Random
) -> Iterator[bool]:
    """The sum with two components equals the union of the sums with each, and contains both: tested
    next to faces of all three."""
    if not pair.parts:
        return
    whole = exposed_from_json(json.loads(text))
    parts = [exposed_from_json(json.loads(route(part, pair.Q, pair.scale))) for part in pair.parts]
    for x in (point for each in (whole, *parts) for point in _beside(each, dice)):
        found = [winding(each, x, dice) for each in (whole, *parts)]
        if None not in found:
            yield found[0] == max(found[1:], key=int)  # type: ignore[arg-type]


def point_operand(
    pair: GeneralPair, route: Route, text: str, dice: random.Random
) -> Iterator[bool]:
    """The sum with a point is a translate, for sP and for Q."""
    t = _vector(dice)
    point = Polyhedron((t,), ())
    for solid, first in ((pair.P, True), (pair.Q, False)):
        if solid.is_thin:
            continue
        found = route(solid, point, pair.scale) if first else route(point, solid, pair.scale)
        x, y, z = (number if first else pair.scale * number for number in t)
        origin = Polyhedron((ORIGIN,), ())
        plain = route(origin, solid.scaled(pair.scale) if first else solid, ONE)
        yield found == moved(plain, IDENTITY, (x, y, z))


LAWS: dict[str, Law] = {
    "translation": translation,
    "GL(3, Z)": unimodular_map,
    "commutativity": commutativity,
    "refinement": refinement,
    "hulls": hull,
    "distributivity": distributivity,
    "points": point_operand,
}


def _vector(dice: random.Random) -> Point:
    x, y, z = (Fraction(dice.randint(-9, 9), dice.randint(1, 3)) for _ in range(3))
    return x, y, z


def _in_triangles(solid: Polyhedron) -> Polyhedron:
    return Polyhedron(solid.vertices, solid.triangles)


def _corners(claim: Exposed) -> list[Point]:
    return [
        lifted(point, plane)
        for plane, polygons in claim.planes.items()
        for ring in rings_of(polygons)
        for point in ring
    ]


def _beside(claim: Exposed, dice: random.Random, most: int = 8) -> Iterator[Point]:
    """Points very near to some faces, on both sides."""
    parts = [(plane, part) for plane, polygons in claim.planes.items() for part in polygons]
    for plane, part in dice.sample(parts, min(most, len(parts))):
        place = lifted(inner_point(part, dice), plane)
        for sign in (-1, 1):
            x, y, z = (
                p + Fraction(sign * n, 1 << 30) for p, n in zip(place, plane[0], strict=True)
            )
            yield x, y, z
