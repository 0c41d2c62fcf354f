"""Around an accepted surface every winding number is 0 or 1; a surface refused for self-crossing
has another winding number somewhere.

Winding numbers come from rays, in fractions, at points near the surface, without the reference.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from random import Random

from minkref import _core
from minkref.fuzz.geometry.space import Point, cross, dot, middle, minus, normal
from thoroughness import draws

SEED = 20
Triangle = tuple[Point, Point, Point]
OCTAHEDRON = (
    (0, 2, 4),
    (2, 1, 4),
    (1, 3, 4),
    (3, 0, 4),
    (2, 0, 5),
    (1, 2, 5),
    (3, 1, 5),
    (0, 3, 5),
)


def random_point(dice: Random, bound: int) -> Point:
    x, y, z = (Fraction(dice.randint(-bound, bound)) for _ in range(3))
    return (x, y, z)


def determinant(a: Point, b: Point, c: Point) -> Fraction:
    return dot(cross(a, b), c)


def winding(triangles: Sequence[Triangle], x: Point, dice: Random) -> int | None:
    """A closed surface's winding number around a point off the surface, by a ray that meets no
    edge; None in the plane of a triangle."""
    if any(dot(normal(a, b, c), minus(x, a)) == 0 for a, b, c in triangles):
        return None
    while True:
        ray = random_point(dice, 999)
        times = 0
        for a, b, c in triangles:
            p, q, r = minus(a, x), minus(b, x), minus(c, x)
            around = [determinant(ray, u, v) for u, v in ((p, q), (q, r), (r, p))]
            if 0 in around:
                break
            out = 1 if determinant(p, q, r) > 0 else -1  # x is on the inner side of the triangle
            if all(d * out > 0 for d in around):
                times += out
        else:
            return times


def windings_near(
    triangles: Sequence[Triangle], point: Point, far: int, count: int, dice: Random
) -> set[int]:
    """At random points less than 1/far away along each axis, until one is neither 0 nor 1."""
    found: set[int] = set()
    for _ in range(count):
        (x, y, z), (a, b, c) = point, random_point(dice, 999)
        unit = 1000 * far
        times = winding(triangles, (x + a / unit, y + b / unit, z + c / unit), dice)
        if times is not None:
            found.add(times)
        if not found <= {0, 1}:
            break
    return found


def named_point(fault: _core.BadInput) -> Point:
    found = re.search(r" at \(([^)]*)\)", fault.problem)
    assert found, fault
    x, y, z = (Fraction(c) for c in found.group(1).split(", "))
    return (x, y, z)


def test_the_winding_number_is_0_or_1_around_what_is_taken_and_not_where_it_crosses() -> None:
    dice = Random(f"octahedra {SEED}")
    seen: Counter[str] = Counter()
    count = draws(40, 150)
    for k in range(count):
        points = [random_point(dice, 2) for _ in range(6)]
        triangles = [(points[a], points[b], points[c]) for a, b, c in OCTAHEDRON]
        if not all(any(normal(*t)) for t in triangles):
            continue
        where = f"{SEED}:{k} {points}"
        try:
            _core.Polyhedron(points, [list(face) for face in OCTAHEDRON]).validate("a.off")
        except _core.BadInput as fault:
            seen[fault.code] += 1
            check_refusal(fault, triangles, dice, where)
            continue
        seen["taken"] += 1
        near = (*points, *(middle(t) for t in triangles))
        found = [windings_near(triangles, x, 5, 10, dice) for x in near]
        assert set().union(*found) == {0, 1}, where
    assert seen["taken"] >= count / 30 and seen["self-intersection"] >= 4 * count / 15, seen


def check_refusal(
    fault: _core.BadInput, triangles: Sequence[Triangle], dice: Random, where: str
) -> None:
    if fault.code == "wrong-orientation":
        assert sum(determinant(*t) for t in triangles) < 0, where
        return
    x = named_point(fault)
    one, other = (normal(*triangles[getattr(fault, name)]) for name in ("face", "other_face"))
    through = [normal(*t) for t in triangles if dot(normal(*t), minus(x, t[0])) == 0]
    assert one in through and other in through, where
    if fault.code == "overlapping-faces":
        assert not any(cross(one, other)), where
        return
    assert fault.code == "self-intersection", where
    if len(through) == 2:  # where a sheet lies twofold, it may be crossed unseen
        assert not windings_near(triangles, x, 10**6, 400, dice) <= {0, 1}, where
