"""Two solids in one mesh: legal iff they are apart, touch without a common area, or one forms a
cavity inside the other.

Judged by convex pieces, whose pairs are separated or not, with integers and without the reference.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, product
from random import Random

import pytest
from minkref import _core
from minkref.fuzz.geometry.space import Whole, cross, dot, minus, normal
from thoroughness import draws

SEED = 20
REFUSED = {"self-intersection", "overlapping-faces", "shell-nesting", "wrong-orientation"}


@dataclass(frozen=True)
class Solid:
    """A solid; `pieces`: corners of convex parts; `walls`: boundary triangles."""

    vertices: tuple[Whole, ...]
    faces: tuple[tuple[int, ...], ...]
    pieces: tuple[tuple[int, ...], ...]
    walls: tuple[tuple[int, int, int], ...]

    def inside_out(self) -> Solid:
        return Solid(self.vertices, tuple(f[::-1] for f in self.faces), self.pieces, self.walls)


def prism(base: Sequence[tuple[int, int]], parts: Sequence[tuple[int, ...]], low: int, high: int,
          turn: int) -> Solid:  # fmt: skip
    """Over a counter-clockwise polygon, cut into triangles `parts`; the axes are turned round."""
    n = len(base)
    points = [(x, y, z) for z in (low, high) for x, y in base]
    sides = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    faces = [tuple(range(n))[::-1], tuple(range(n, 2 * n)), *sides]
    walls = [(a, b, c) for a, b, c, d in sides] + [(a, c, d) for a, b, c, d in sides]
    walls += [(a, b, c) for a, b, c in parts] + [(a + n, b + n, c + n) for a, b, c in parts]
    turned = [(p[turn], p[(turn + 1) % 3], p[(turn + 2) % 3]) for p in points]
    pieces = [(*part, *(k + n for k in part)) for part in parts]
    return Solid(tuple(turned), tuple(faces), tuple(pieces), tuple(walls))


def _point(dice: Random, size: int) -> Whole:
    return (dice.randint(0, size), dice.randint(0, size), dice.randint(0, size))


TETRAHEDRON, BOX, NON_CONVEX = range(3)


def random_solid(dice: Random, size: int, kind: int) -> Solid:
    def cuts(count: int) -> list[int]:
        return sorted(dice.sample(range(size + 1), count))

    if kind == TETRAHEDRON:
        while True:
            p = [_point(dice, size) for _ in range(4)]
            volume = dot(normal(*p[:3]), minus(p[3], p[0]))
            if volume < 0:
                p[0], p[1] = p[1], p[0]
            if volume != 0:
                walls = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
                return Solid(tuple(p), walls, ((0, 1, 2, 3),), walls)
    low, high = cuts(2)
    if kind == BOX:
        (a, c), (b, d) = cuts(2), cuts(2)
        return prism([(a, b), (c, b), (c, d), (a, d)], [(0, 1, 2), (0, 2, 3)], low, high,
                     dice.randrange(3))  # fmt: skip
    (a, b, c), (d, e, f) = cuts(3), cuts(3)
    if dice.random() < 0.5:
        base = [(a, d), (c, d), (c, e), (b, e), (b, f), (a, f)]  # an L
        parts = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    else:
        base, parts = [(a, d), (b, e), (c, d), (b, f)], [(0, 1, 3), (1, 2, 3)]  # an arrow
    return prism(base, parts, low, high, dice.randrange(3))


def apart(one: Sequence[Whole], other: Sequence[Whole], axes: Iterable[Whole]) -> bool:
    """Whether an axis separates two convex bodies, weakly."""
    for axis in axes:
        first, second = ([dot(axis, p) for p in points] for points in (one, other))
        if any(axis) and (max(first) <= min(second) or max(second) <= min(first)):
            return True
    return False


def directions(points: Sequence[Whole]) -> list[Whole]:
    """The directions of all edges and diagonals."""
    return [minus(b, a) for a, b in combinations(points, 2)]


def interiors_meet(one: Sequence[Whole], other: Sequence[Whole]) -> bool:
    first, second = directions(one), directions(other)
    pairs = [*combinations(first, 2), *combinations(second, 2), *product(first, second)]
    return not apart(one, other, (cross(a, b) for a, b in pairs))


def share_an_area(one: Sequence[Whole], other: Sequence[Whole]) -> bool:
    up = normal(*one)
    if any(dot(up, minus(p, one[0])) for p in other):
        return False
    return not apart(one, other, (cross(up, e) for e in directions(one) + directions(other)))


def corners(solid: Solid, numbers: Sequence[int]) -> list[Whole]:
    return [solid.vertices[k] for k in numbers]


def walls_share_an_area(one: Solid, other: Solid) -> bool:
    pairs = product(one.walls, other.walls)
    return any(share_an_area(corners(one, a), corners(other, b)) for a, b in pairs)


FACTORS = (Fraction(1), Fraction(1, 3), Fraction(2**70 + 1, 3), Fraction(10**400))


def in_one_mesh(one: Solid, other: Solid, scale: Fraction) -> _core.Polyhedron:
    n = len(one.vertices)
    faces = [*one.faces, *(tuple(k + n for k in face) for face in other.faces)]
    points = [tuple(scale * c for c in p) for p in (*one.vertices, *other.vertices)]
    return _core.Polyhedron(points, [list(face) for face in faces])


def place(fault: _core.BadInput, name: str) -> int:
    number = getattr(fault, name)
    assert isinstance(number, int), fault
    return number


def refusal(surface: _core.Polyhedron) -> _core.BadInput | None:
    try:
        surface.validate("a.off")
    except _core.BadInput as fault:
        assert fault.code in REFUSED, fault
        return fault
    return None


@pytest.mark.parametrize("size", (2, 3, 5))
def test_two_solids_are_one_mesh_iff_their_interiors_and_faces_share_nothing(size: int) -> None:
    dice = Random(f"two solids {SEED} {size}")
    seen = {True: 0, False: 0}
    for k in range(count := draws(80, 250)):
        one, other = (random_solid(dice, size, dice.randrange(3)) for _ in range(2))
        meet = any(
            interiors_meet(corners(one, a), corners(other, b))
            for a, b in product(one.pieces, other.pieces)
        )
        bad = meet or walls_share_an_area(one, other)
        fault = refusal(in_one_mesh(one, other, dice.choice(FACTORS)))
        assert (fault is not None) == bad, f"{SEED}:{size}:{k} {fault} {one} {other}"
        if fault and not meet:
            assert fault.code == "overlapping-faces", f"{SEED}:{size}:{k} {fault}"
        if fault and fault.code != "wrong-orientation":
            faces = sorted((place(fault, "face"), place(fault, "other_face")))
            assert faces[0] < len(one.faces) <= faces[1], f"{SEED}:{size}:{k} {fault}"
        seen[bad] += 1
    assert min(seen.values()) >= 0.08 * count, seen


def lies_in(one: Solid, point: Whole) -> bool:
    """Whether a point lies in a convex solid, boundary included."""
    for a, b, c in (corners(one, face[:3]) for face in one.faces):
        if dot(normal(a, b, c), minus(point, a)) > 0:
            return False
    return True


@pytest.mark.parametrize("size", (2, 3, 5))
def test_a_cavity_of_a_convex_solid_is_legal_iff_it_lies_in_it(size: int) -> None:
    dice = Random(f"cavity {SEED} {size}")
    seen = {True: 0, False: 0}
    for k in range(count := draws(80, 200)):
        one = random_solid(dice, size, dice.choice((TETRAHEDRON, BOX)))
        if dice.random() < 0.6:
            square = [(0, 0), (size, 0), (size, size), (0, size)]
            one = prism(square, [(0, 1, 2), (0, 2, 3)], 0, size, 0)
        other = random_solid(dice, size, dice.randrange(3))
        inside = all(lies_in(one, p) for p in other.vertices)
        good = inside and not walls_share_an_area(one, other)
        fault = refusal(in_one_mesh(one, other.inside_out(), dice.choice(FACTORS)))
        assert (fault is None) == good, f"{SEED}:{size}:{k} {fault} {one} {other}"
        seen[good] += 1
    assert min(seen.values()) >= 0.04 * count, seen
