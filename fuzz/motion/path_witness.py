"""Finds by definition a place on a path where a part collides, or that none exists; code that
shares nothing with the search checks the result again."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from minkref import _core
from minkref.fuzz.geometry.plane import Point, Shape, contains, crossing, in_box, read_shape, turn
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_collisions import (
    Collisions,
    Decide,
    Located,
    by_slow_engine,
    by_triangles,
)
from minkref.fuzz.plane.comparison import WitnessRefuted
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.witness import on_boundary
from minkref.fuzz.verdicts.verdict import Witness

ALLOWED = "allowed"
BAD = {ALLOWED: ("overlapping",), "forbidden": ("overlapping", "touching")}


class Asked(NamedTuple):
    """The question to decide: a case, with obstacles that may be smaller or larger than its own by
    a tolerance, and the rule that the tolerance leaves."""

    case: AskedPath
    obstacles: _core.PolygonSet
    contact: str
    tolerance: Fraction = Fraction(0)


def path_witness(asked: Asked, scale: Fraction) -> Witness:
    """Finds at this scale a place that collides, with p and q; or that none does, with the number
    of places decided: places where the part starts or stops touching, and one between any two.
    Exact: by pairs of triangles, and again in plain fractions. Raises WitnessRefuted."""
    case = asked.case
    collisions = Collisions(case.part, asked.obstacles, case.path)
    found, count = _first(collisions, scale, by_triangles(case.part, asked.obstacles), asked)
    given: dict[str, str] = {"scale": str(scale), "contact": asked.contact}
    if asked.tolerance:
        given["tolerance"] = str(asked.tolerance)
    if found is None:
        again, _ = _first(collisions, scale, by_slow_engine(case.part, asked.obstacles), asked)
        if again is not None:
            raise WitnessRefuted(f"the scale {scale} on {case.name.text}")
        start = case.path[0]
        return Witness(_texts(start), False, places=count, **given)  # type: ignore[arg-type]
    p, q = _shared(asked, scale, found.point)
    place = (str(found.segment), str(found.t))
    witness = Witness(
        _texts(found.point),
        True,
        _texts(p),
        _texts(q),
        on_path=place,
        **given,  # type: ignore[arg-type]
    )
    if not holds(asked, witness):
        raise WitnessRefuted(f"the place {witness.point} at {scale} on {case.name.text}")
    return witness


def _first(
    collisions: Collisions, scale: Fraction, decide: Decide, asked: Asked
) -> tuple[Located | None, int]:
    count = 0
    for place in collisions.located(scale):
        count += 1
        if decide(scale, place.point) in BAD[asked.contact]:
            return place, count
    return None, count


def _texts(point: Point) -> tuple[str, str]:
    return (str(point[0]), str(point[1]))


def _shared(asked: Asked, scale: Fraction, x: Point) -> tuple[Point, Point]:
    """Returns p in the part and q in the obstacles, in both interiors if contact is allowed, with x
    + s p = q."""
    case = asked.case
    if asked.contact != ALLOWED:
        turned = case.part.scaled("-1")
        answer = _core.decide(turned, asked.obstacles, str(scale), str(x[0]), str(x[1]))
        p = (-Fraction(answer["p"][0]), -Fraction(answer["p"][1]))
        return p, (Fraction(answer["q"][0]), Fraction(answer["q"][1]))
    placed = case.part.scaled(str(scale)).translated(str(x[0]), str(x[1]))
    if placed.is_region and asked.obstacles.is_region:
        common = _core.minus(placed, _core.minus(placed, asked.obstacles))
        point = _core.inner_point(common)
        if point is None:
            raise WitnessRefuted(f"the place ({x[0]}, {x[1]}) on {case.name.text}")
        q: Point = (Fraction(point[0]), Fraction(point[1]))
    else:
        thin, wide = (asked.obstacles, placed) if placed.is_region else (placed, asked.obstacles)
        q = _inside(shape_of(thin)[0][0], shape_of(wide), case)
    return ((q[0] - x[0]) / scale, (q[1] - x[1]) / scale), q


def _inside(ends: list[Point], wide: Shape, case: AskedPath) -> Point:
    """Returns a point of the thin operand, without a segment's ends, that lies inside a set."""
    if len(ends) == 1:
        return ends[0]
    a, b = ends
    cuts = [a, b]
    for polygon in wide:
        for ring in polygon:
            for c, d in zip(ring, ring[1:] + ring[:1], strict=True):
                sides = turn(a, b, c), turn(a, b, d)
                cuts += [p for p, side in zip((c, d), sides, strict=True) if side == 0]
                if sides[0] * sides[1] < 0:
                    cuts.append(crossing(a, b, c, d))
    cuts = sorted(p for p in cuts if in_box(a, b, p))
    for first, second in pairwise(cuts):
        half = Fraction(1, 2)
        middle = (half * (first[0] + second[0]), half * (first[1] + second[1]))
        if contains(wide, middle) and not on_boundary(wide, middle):
            return middle
    raise WitnessRefuted(f"no point of a segment is inside on {case.name.text}")


def holds(asked: Asked, witness: Witness) -> bool:
    """Checks a collision in plain fractions: the place lies on the path, x + s p equals q, and p
    and q belong to their sets, or to their interiors with contact allowed."""
    case = asked.case
    if witness.on_path is None or witness.p is None or witness.q is None or witness.scale is None:
        return False
    segment, t, s = int(witness.on_path[0]), Fraction(witness.on_path[1]), Fraction(witness.scale)
    x, p, q = (
        (Fraction(point[0]), Fraction(point[1])) for point in (witness.point, witness.p, witness.q)
    )
    if not (0 <= segment < max(len(case.path) - 1, 1) and 0 <= t <= 1):
        return False
    a, b = case.path[segment], case.path[min(segment + 1, len(case.path) - 1)]
    if x != (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])):
        return False
    if q != (x[0] + s * p[0], x[1] + s * p[1]):
        return False
    shapes = (read_shape(case.P_json), read_shape(asked.obstacles.to_json()))
    if asked.contact != ALLOWED:
        return contains(shapes[0], p) and contains(shapes[1], q)
    return _is_inside(shapes[0], p) and _is_inside(shapes[1], q)


def _is_inside(shape: Shape, point: Point) -> bool:
    """Whether a point lies in the interior; a point is its own interior, a segment's interior
    excludes its ends."""
    ring = shape[0][0]
    if len(ring) == 1:
        return point == ring[0]
    if len(ring) == 2:
        a, b = ring
        return turn(a, b, point) == 0 and in_box(a, b, point) and point not in (a, b)
    return contains(shape, point) and not on_boundary(shape, point)
