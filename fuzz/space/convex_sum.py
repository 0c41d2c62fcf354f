"""Sums of convex polyhedra by the reference, in this room's types."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Scale, factors
from minkref.fuzz.space.hull import sum_of_convex

MOST_BY_HULL = 400  # vertex sums, up to which the hull in plain fractions is quick


def true_sum(P: Polyhedron, Q: Polyhedron, scale: Scale) -> Polyhedron:
    """Returns sP + Q for convex operands: for small operands the hull of all vertex sums, which
    shares nothing with the reference, for larger operands the reference's sum."""
    if len(P.vertices) * len(Q.vertices) <= MOST_BY_HULL:
        return sum_of_convex(P, Q, scale)
    return reference_sum(P, Q, scale)


def reference_sum(P: Polyhedron, Q: Polyhedron, scale: Scale) -> Polyhedron:
    """Sums by the reference. One operand may be a point or a segment."""
    if P.is_thin:
        return reference_sum(Q, P.scaled(scale), Fraction(1))
    scaling = scaling_of(scale)
    if not Q.is_thin:
        return polyhedron_of(_core.convex_sum(body_of(P), body_of(Q), scaling).surface)
    ends = [(str(x), str(y), str(z)) for x, y, z in Q.vertices]
    if len(ends) == 1:
        body = polyhedron_of(body_of(P).surface())
        return body.scaled(scale).translated(Q.vertices[0])
    return polyhedron_of(_core.convex_sum_with_segment(body_of(P), scaling, *ends).surface)


def body_of(polyhedron: Polyhedron) -> _core.ConvexPolyhedron:
    """Converts a polyhedron. Raises _core.BadInput if not convex."""
    points = [(str(x), str(y), str(z)) for x, y, z in polyhedron.vertices]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, [list(f) for f in polyhedron.faces]))


def polyhedron_of(surface: _core.Polyhedron) -> Polyhedron:
    vertices = tuple(surface.points())
    return Polyhedron(vertices, tuple(tuple(ring) for ring in surface.rings()))


def scaling_of(scale: Scale) -> tuple[str, str, str]:
    x, y, z = (str(factor) for factor in factors(scale))
    return (x, y, z)
