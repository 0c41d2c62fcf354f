"""Sums in space, right and with one deliberate fault each, as targets `py:faulty_solids:NAME`."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.exact_sum import EDGES, exposed_sum, polyhedron_of_planes
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from minkref.fuzz.space.smaller_solids import fewer_shells

Solid = dict[str, Any]
TAKES = ["space", "non-convex", "holes", "components", "touching", "point", "segment", "rational"]
EXACT = {"capabilities": [*TAKES, "non-uniform"]}


def _sum(P: Solid, Q: Solid) -> Polyhedron:
    operands = Polyhedron.from_document(P), Polyhedron.from_document(Q)
    return polyhedron_of_planes(exposed_sum(*operands, Fraction(1), EDGES))


def right(P: Solid, Q: Solid) -> Solid:
    """In triangles."""
    solid = _sum(P, Q)
    return Polyhedron(solid.vertices, solid.triangles).document()


def fills_all(P: Solid, Q: Solid) -> Solid:
    """The hull: no cavity, tunnel or dent is left."""
    return convex_hull(_sum(P, Q).vertices).document()


def moves_a_vertex(P: Solid, Q: Solid) -> Solid:
    solid = _sum(P, Q)
    top = max(solid.vertices)
    moved = (top[0] + Fraction(1, 10**6), top[1], top[2])
    vertices = tuple(moved if vertex == top else vertex for vertex in solid.vertices)
    return Polyhedron(vertices, solid.triangles).document()


def by_shells(P: Solid, Q: Solid) -> Solid:
    """Adds a convex Q to each of the two convex shells of P: two shells that overlap."""
    first = Polyhedron.from_document(P)
    result = Polyhedron((), ())
    for part in fewer_shells(first):
        result = result.with_faces_of(sum_of_convex(part, Polyhedron.from_document(Q), Fraction(1)))
    return result.document()


for function in (right, by_shells, fills_all, moves_a_vertex):
    function.minkref = EXACT  # type: ignore[attr-defined]
