"""Faces of a result that lie inside its other shells: where convex bodies overlap or abut, as when
sums of convex pieces make up a sum."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Whole, cross, dot, normal, primitive
from minkref.fuzz.space.boxes import Box, BoxTree, box_of
from minkref.fuzz.space.face_pieces import (
    Plane,
    Polygon,
    Triangle,
    halves,
    heights,
    inside,
    pieces,
    polygon_of,
)
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.shells import shells_of
from minkref.fuzz.space.sides import both_sides

MOST_OTHERS = 1000  # triangles on shells that are not convex
Triple = tuple[int, int, int]


@dataclass(frozen=True)
class Shell:
    """A convex shell whose faces run counter-clockwise around its inside."""

    planes: list[Plane]
    corners: list[Whole]
    box: Box

    @property
    def size(self) -> int:
        a, b, c, d, e, f = self.box
        return (b - a) * (d - c) * (f - e)


class CoveredFaces:
    """`left` returns the parts of a triangle that the result's convex shells leave as a face
    between winding number 0 and 1: polygons. If the winding number of the other shells is somewhere
    negative, or they have too many triangles to tell, the whole triangle is left."""

    def __init__(self, result: Polyhedron) -> None:
        groups = shells_of(result)
        self._points = result.wholes
        self._convex: dict[int, Shell] = {}
        triples = [[t for face in faces for t in result.triangles_of(face)] for faces in groups]
        if len(groups) > 1:
            for name, own in enumerate(triples):
                shell = _convex_shell(own, self._points)
                if shell is not None:
                    self._convex[name] = shell
        others = [own for name, own in enumerate(triples) if name not in self._convex]
        self._convex = self._beside(result, triples, others)
        self._order = sorted(self._convex, key=lambda name: -self._convex[name].size)
        self._tree = BoxTree([self._convex[name].box for name in self._order])
        self._own = {t: name for name in self._convex for t in triples[name]}

    def _beside(
        self, result: Polyhedron, triples: list[list[Triple]], others: list[list[Triple]]
    ) -> dict[int, Shell]:
        """Convex shells such that the winding number of the rest is nowhere negative: the other
        shells may be cavities, in one convex shell or in several, which then belong to the rest."""
        together = [[t for own in others for t in own]] if others else []
        for cavities in (together, others) if self._convex else ():
            around = self._around(cavities)
            rest = [*others, *(triples[name] for name in around)]
            if _never_negative(result, [t for own in rest for t in own]):
                return {name: own for name, own in self._convex.items() if name not in around}
        return {}

    def _around(self, groups: Sequence[Sequence[Triple]]) -> list[int]:
        """For each group of triangles, the largest convex shell around it, used only once."""
        found: list[int] = []
        for triples in groups:
            points = {self._points[k] for triple in triples for k in triple}
            around = [
                name
                for name, shell in self._convex.items()
                if name not in found
                and all(dot(n, point) <= d for n, d in shell.planes for point in points)
            ]
            found += sorted(around, key=lambda name: -self._convex[name].size)[:1]
        return found

    def left(self, triple: Triple) -> list[Polygon]:
        """Returns the parts of a triangle, given by vertex numbers; coordinates count parts of the
        unit, as many as the result's denominator."""
        i, j, k = triple
        triangle = (self._points[i], self._points[j], self._points[k])
        n, own = normal(*triangle), self._own.get(triple)
        parts = [polygon_of(triangle)]
        for number in self._tree.meeting(box_of(triangle)):
            name = self._order[number]
            shell = self._convex[name]
            if name == own or _is_beside(shell, triangle, n):
                continue
            parts = [piece for part in parts for piece in _less(part, shell, n, own is not None)]
            if not parts:
                break
        return parts


def _is_beside(shell: Shell, triangle: Triangle, n: Whole) -> bool:
    """Whether a plane of the shell, or the triangle's plane with normal `n`, shows that the shell
    holds no inside point of the triangle, nor its inside from above."""
    for m, d in shell.planes:
        if all(dot(m, corner) >= d for corner in triangle):
            return any(dot(m, corner) > d for corner in triangle) or dot(m, n) > 0
    levels = [dot(n, corner) for corner in shell.corners]
    level = dot(n, triangle[0])
    if min(levels) >= level:
        return levels.count(level) < 3
    return max(levels) <= level


def _less(part: Polygon, shell: Shell, n: Whole, covered_below: bool) -> list[Polygon]:
    """The part of a face with normal `n` outside of the shell. A part in the surface of the shell
    counts as inside if the shell is on the outer side, and another shell is below."""
    whole, gone = part, []
    for m, d in shell.planes:
        sides = heights(part, (m, d))
        if max(sides) <= 0:
            if any(sides) or (covered_below and dot(m, n) < 0):
                continue
            return [whole]
        if min(sides) >= 0:
            return [whole]
        part, outside = halves(part, sides)
        gone.append(outside)
    return gone


def _convex_shell(triples: Sequence[Triple], points: Sequence[Whole]) -> Shell | None:
    """Returns the shell of a closed surface; None if flat, not convex, or with faces that run the
    other way."""
    planes: set[Plane] = set()
    corners: set[Whole] = set()
    for i, j, k in triples:
        n = primitive(normal(points[i], points[j], points[k]))
        planes.add((n, dot(n, points[i])))
        corners |= {points[i], points[j], points[k]}
    if not planes or any(dot(n, corner) > d for n, d in planes for corner in corners):
        return None
    if _is_flat(planes):
        return None
    return Shell(sorted(planes), sorted(corners), box_of(corners))


def _is_flat(planes: set[Plane]) -> bool:
    """Whether all planes are two sides of the same plane."""
    (first, _), *rest = planes
    return all(cross(first, n) == (0, 0, 0) for n, _ in rest)


def _never_negative(result: Polyhedron, triples: Sequence[Triple]) -> bool:
    """Whether the winding number of these triangles is nowhere less than 0: on neither side of any
    piece."""
    if len(triples) > MOST_OTHERS:
        return False
    if not triples:
        return True
    surface = Surface(Polyhedron(result.vertices, tuple(triples)))
    for number, triangle in enumerate(surface.triangles):
        near = [surface.triangles[k] for k in surface.near(number)]
        for piece in pieces([polygon_of(triangle)], surface.normals[number], near):
            place = inside(piece, surface.denominator)
            for point in both_sides(surface, place, surface.normals[number]):
                if (surface.winding(point) or 0) < 0:
                    return False
    return True
