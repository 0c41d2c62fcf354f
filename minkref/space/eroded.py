"""Erosions in space: cavities left by the outside plus -Q (docs/erosion.md)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

Point = tuple[Fraction, ...]
BOX = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
WIDTHS = 3  # of P between P and the box around it


@dataclass(frozen=True)
class Room:
    """Least and greatest place for Q, by both boxes."""

    low: Point
    high: Point

    @property
    def is_empty(self) -> bool:
        return any(low > high for low, high in zip(self.low, self.high, strict=True))

    def holds(self, x: Sequence[Fraction]) -> bool:
        return all(a <= c <= b for a, c, b in zip(self.low, x, self.high, strict=True))


def points_of(surface: _core.Polyhedron) -> list[Point]:
    return list(surface.points())


def box_of(points: list[Point]) -> tuple[Point, Point]:
    columns = list(zip(*points, strict=True))
    return tuple(map(min, columns)), tuple(map(max, columns))


def room(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling) -> Room:
    """Find the places where the scaled P's box holds Q's box."""
    (low, high), (least, greatest) = box_of(points_of(P.surface)), box_of(points_of(Q.surface))
    by = tuple(map(Fraction, scaling))
    return Room(
        tuple(s * a - b for s, a, b in zip(by, low, least, strict=True)),
        tuple(s * a - b for s, a, b in zip(by, high, greatest, strict=True)),
    )


def outside_of(P: SpaceOperand) -> SpaceOperand:
    """Make a box around P, three widths away in each direction, and turn P's faces over. Refuses a
    P without volume."""
    if not P.is_solid:
        what = "the first operand has no volume, so that it leaves nothing with one"
        raise Refusal(what, P.name, "give a polyhedron", "not-solid")
    points = points_of(P.surface)
    low, high = box_of(points)
    wide = [WIDTHS * (b - a) for a, b in zip(low, high, strict=True)]
    ends = [(a - w, b + w) for a, b, w in zip(low, high, wide, strict=True)]
    corners = [tuple(pair[k] for pair, k in zip(ends, corner, strict=True)) for corner in CORNERS]
    faces = [list(ring)[::-1] for ring in P.surface.rings()]
    faces += [[len(points) + k for k in face] for face in BOX]
    surface = _core.Polyhedron(_texts([*points, *corners]), faces)
    return replace(P, name=f"the outside of {P.name}", surface=surface, body=None)


def negated(Q: SpaceOperand) -> SpaceOperand:
    """Make -Q; faces turn over."""
    points = [tuple(-c for c in point) for point in points_of(Q.surface)]
    faces = [list(ring)[::-1] for ring in Q.surface.rings()]
    return replace(Q, name=f"-{Q.name}", surface=_core.Polyhedron(_texts(points), faces), body=None)


def cavities(found: _core.PolyhedralSet, within: Room) -> _core.PolyhedralSet:
    """Turn a set's cavities into a set: keep faces within the room, turned over; all other faces
    lie outside."""
    planes = []
    for normal, offset, polygons in found.__getstate__():
        kept = [rings for rings in polygons if within.holds(_corner(normal, offset, rings[0][0]))]
        if kept:
            x, y, z = (str(-Fraction(c)) for c in normal)
            planes.append(((x, y, z), str(-Fraction(offset)), kept))
    planes.sort(key=lambda plane: (*map(Fraction, plane[0]), Fraction(plane[1])))
    made = _core.PolyhedralSet.__new__(_core.PolyhedralSet)
    made.__setstate__(planes)
    return made


def _corner(normal: Sequence[str], offset: str, corner: Sequence[str]) -> list[Fraction]:
    """Complete two coordinates to a point in an oriented plane; the missing axis is the normal's
    first nonzero one."""
    n = [Fraction(c) for c in normal]
    axis = next(k for k in range(3) if n[k])
    x = [Fraction(c) for c in corner]
    x.insert(axis, Fraction(0))
    x[axis] = (Fraction(offset) - sum(a * b for a, b in zip(n, x, strict=True))) / n[axis]
    return x


def _texts(points: list[Point]) -> list[Any]:
    return [tuple(str(c) for c in point) for point in points]
