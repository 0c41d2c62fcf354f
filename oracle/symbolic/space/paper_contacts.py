"""Formulas from Behar & Lien 2012, Section 5, by computer algebra: the contacts between two convex
facets and their scales. Each sentence as printed and in its right form."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ..paper_formulas import EVERY, NONE, Edge, S, region, scale_of_contact

Readings = Mapping[str, str]
Corner = tuple[Sequence[object], Sequence[object]]  # p and q of s p + q
Scale = Any  # a rational of sympy, or None


@dataclass(frozen=True)
class Facet:
    """Corners s p + q, linear in S, in order; names: each corner's p and q."""

    corners: tuple[sympy.Matrix, ...]
    names: tuple[tuple[tuple[object, ...], tuple[object, ...]], ...]

    def corner(self, k: int) -> sympy.Matrix:
        return self.corners[k % len(self.corners)]

    def side(self, k: int) -> Edge:
        return Edge(self.corner(k), self.corner(k + 1))

    def along(self, k: int) -> sympy.Matrix:
        """The direction of a side, the same at all scales s > 0."""
        side = self.side(k).at(1)
        return side.end - side.start

    def normal(self) -> sympy.Matrix:
        a, b, c = (corner.subs(S, 1) for corner in self.corners[:3])
        return (b - a).cross(c - a)

    def contains(self, point: sympy.Matrix, scale: object) -> bool:
        """Whether the facet contains a point of its plane."""
        normal = self.normal()
        return all(
            normal.cross(self.along(k)).dot(point - self.corner(k).subs(S, scale)) >= 0
            for k in range(len(self.corners))
        )


def facet(corners: Sequence[Corner]) -> Facet:
    matrices = tuple(S * _vector(p) + _vector(q) for p, q in corners)
    return Facet(matrices, tuple((tuple(p), tuple(q)) for p, q in corners))


class FacetPair:
    """Two facets; where sides' lines meet the other plane is found once for all readings."""

    def __init__(self, first: Facet, second: Facet) -> None:
        self._facets = first, second
        self._readings: Readings = {}
        self._tracks: dict[tuple[int, int], sympy.Matrix | None] = {}
        self._corners = [(which, k) for which in (0, 1) for k in range(len(self._of(which)))]
        self._sides = [(k, j) for k in range(len(self._of(0))) for j in range(len(self._of(1)))]

    def _of(self, which: int) -> tuple[sympy.Matrix, ...]:
        return self._facets[which].corners

    def contacts(self, readings: Readings) -> list[Scale]:
        """List the scale of each contact, None without one: each corner of the first, then of the
        second; each side of the first with each of the second; these pairs again, for the second
        scale of coplanar sides. `readings`: a value for each of Section 5's sentences, `plane-`
        before those of Section 4. Raises ValueError for parallel sides of coplanar facets."""
        self._readings = readings
        first, second = self._facets
        nothing: list[Scale] = [None] * len(self._sides)
        none_at_all = [None] * len(self._corners) + nothing + nothing
        if _is_zero(first.normal().cross(second.normal())):
            if _is_zero_always(second.normal().dot(first.corner(0) - second.corner(0))):
                return [None] * len(self._corners) + self._in_plane()
            if self._readings["parallel"] == "left-out":
                return none_at_all
            corners = [self._corner(which, k) for which, k in self._corners]
            return corners + self._at_one_scale(corners) + nothing
        ask = self._points_meet if self._readings["crossing"] == "points" else self._lines_meet
        corners = [self._corner(which, k) for which, k in self._corners]
        return corners + [ask(k, j) for k, j in self._sides] + nothing

    def _track(self, which: int, k: int) -> sympy.Matrix | None:
        """x(s) = x(1) + (s - 1) (x(2) - x(1)), where a side's line meets the other plane."""
        if (which, k) not in self._tracks:
            one, two = (self._point(which, k, scale) for scale in (1, 2))
            known = None if one is None or two is None else one + (S - 1) * (two - one)
            self._tracks[which, k] = known
        return self._tracks[which, k]

    def _point(self, which: int, k: int, scale: int) -> sympy.Matrix | None:
        """By e_a - t_a = t (e_a - e_b) + u (t_b - t_a) + v (t_c - t_a) (Section 5.2)."""
        side = self._facets[which].side(k).at(scale)
        ta, tb, tc = (corner.subs(S, scale) for corner in self._of(1 - which)[:3])
        columns = sympy.Matrix.hstack(side.start - side.end, tb - ta, tc - ta)
        if columns.det() == 0:
            return None
        t, _, _ = columns.LUsolve(side.start - ta)
        return side.start + t * (side.end - side.start)

    def _corner(self, which: int, k: int) -> Scale:
        own, other = self._facets[which], self._facets[1 - which]
        if self._readings["corner"] == "itself":
            scale = _root(other.normal().dot(own.corner(k) - other.corner(0)))
            there = scale is not None and other.contains(own.corner(k).subs(S, scale), scale)
            return scale if there else None
        for side in (k - 1, k):
            x = self._track(which, side % len(own.corners))
            if x is None:
                continue
            scale = self._solved(x, own.corner(k), own.along(side))
            if scale is not None and other.contains(x.subs(S, scale), scale):
                return scale
        return None

    def _points_meet(self, k: int, j: int) -> Scale:
        x1, x2 = self._track(0, k), self._track(1, j)
        if x1 is None or x2 is None:
            return None
        first, second = self._facets
        scale = self._solved(x1, x2, first.normal().cross(second.normal()))
        return self._within(k, j, scale, lambda s: x1.subs(S, s))

    def _lines_meet(self, k: int, j: int) -> Scale:
        first, second = self._facets
        u, v, way = first.along(k), second.along(j), second.corner(j) - first.corner(k)
        scale = _root(sympy.Matrix.hstack(u, v, way).det())
        if scale is None or _is_zero(u.cross(v)):
            return None

        def point(s: object) -> sympy.Matrix:
            r, t = sympy.symbols("r t")
            (found,) = sympy.linsolve(list(way.subs(S, s) + t * v - r * u), [r, t])
            return first.corner(k).subs(S, s) + found[0] * u

        return self._within(k, j, scale, point)

    def _within(
        self, k: int, j: int, scale: Scale, point: Callable[[object], sympy.Matrix]
    ) -> Scale:
        if scale is None or self._readings["ends"] == "lines":
            return scale
        x = point(scale)
        sides = self._facets[0].side(k).at(scale), self._facets[1].side(j).at(scale)
        return scale if all(_is_between(side, x) for side in sides) else None

    def _at_one_scale(self, corners: list[Scale]) -> list[Scale]:
        """Sides of parallel faces, "if there are no vertex events"."""
        nothing: list[Scale] = [None] * len(self._sides)
        if any(scale is not None for scale in corners) or self._readings["corner"] == "lines":
            return nothing  # by lines no scale is known: each matrix is singular
        first, second = self._facets
        scale = _root(second.normal().dot(first.corner(0) - second.corner(0)))
        if scale is None:
            return nothing
        return [scale if self._cross(k, j, scale) else None for k, j in self._sides]

    def _cross(self, k: int, j: int, scale: sympy.Rational) -> bool:
        sides = self._facets[0].side(k).at(scale), self._facets[1].side(j).at(scale)
        normal = self._facets[0].normal()
        if _is_zero(self._facets[0].along(k).cross(self._facets[1].along(j))):
            return False

        def parts(own: Edge, other: Edge) -> bool:
            across = normal.cross(own.end - own.start)
            from_start = across.dot(other.start - own.start)
            return bool(from_start * across.dot(other.end - own.start) <= 0)

        return parts(*sides) and parts(*sides[::-1])

    def _in_plane(self) -> list[Scale]:
        """Sides of coplanar faces, as edges of Section 4: the first scale of each two, then the
        last."""
        nothing: list[Scale] = [None] * len(self._sides)
        if self._readings["coplanar"] == "left-out":
            return nothing + nothing
        axes = self._axes()
        bounds = [self._region(k, j, axes) for k, j in self._sides]
        return [each[0] for each in bounds] + [each[1] for each in bounds]

    def _axes(self) -> tuple[sympy.Matrix, sympy.Matrix]:
        normal = self._facets[1].normal()
        if self._readings["coplanar"] == "turned":
            along = self._facets[1].along(0)
            return along, normal.cross(along)
        longest = max(range(3), key=lambda k: (abs(normal[k]), -k))
        return _unit((longest + 1) % 3), _unit((longest + 2) % 3)

    def _region(
        self, k: int, j: int, axes: tuple[sympy.Matrix, sympy.Matrix]
    ) -> tuple[Scale, Scale]:
        if self._share_corner(k, j):
            return None, None
        flat = sympy.Matrix([list(axes[0]), list(axes[1])])
        a, b = (
            Edge(flat * side.start, flat * side.end)
            for side in (self._facets[0].side(k), self._facets[1].side(j))
        )
        if _is_zero(self._facets[0].along(k).cross(self._facets[1].along(j))):
            raise ValueError("parallel sides of coplanar facets are not spoken of here")
        ways = (self._readings[f"plane-{name}"] for name in ("observation", "solve", "interval"))
        found = region(a, b, *ways)
        return (None, None) if found is None else found

    def _share_corner(self, k: int, j: int) -> bool:
        ends = [
            {facet.names[end % len(facet.names)] for end in (side, side + 1)}
            for facet, side in zip(self._facets, (k, j), strict=True)
        ]
        return bool(ends[0] & ends[1])

    def _solved(self, x: sympy.Matrix, end: sympy.Matrix, along: sympy.Matrix) -> Scale:
        scale: Scale = scale_of_contact(x, end, self._readings["solve"], along)
        return scale if scale not in (EVERY, NONE) and scale > 0 else None


def _root(condition: sympy.Expr) -> Scale:
    """The positive root of a condition that is linear in S."""
    condition = sympy.expand(condition)
    slope = sympy.diff(condition, S)
    if slope == 0:
        return None
    root = -condition.subs(S, 0) / slope
    return root if root > 0 else None


def _is_between(side: Edge, x: sympy.Matrix) -> bool:
    along = side.end - side.start
    return bool(along.dot(x - side.start) >= 0 and along.dot(side.end - x) >= 0)


def _is_zero(vector: sympy.Matrix) -> bool:
    return all(entry == 0 for entry in vector)


def _is_zero_always(condition: sympy.Expr) -> bool:
    return bool(sympy.expand(condition) == 0)


def _unit(k: int) -> sympy.Matrix:
    return sympy.Matrix([int(k == axis) for axis in range(3)])


def _vector(point: Sequence[object]) -> sympy.Matrix:
    return sympy.Matrix([sympy.Rational(str(number)) for number in point])
