"""Sums in space with the empty set, a point or a segment."""

from __future__ import annotations

import time

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.space.operand import SpaceOperand, solid
from minkref.space.scaling import Scaling
from minkref.space.space_sum import Face, SpaceSum

ONCE: Scaling = ("1", "1", "1")


def degenerate_sum(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling) -> SpaceSum:
    """Compute the sum exactly. Refuses a point or a segment unless the other operand is a
    polyhedron."""
    start = time.perf_counter()
    if 0 in (P.surface.vertices, Q.surface.vertices):
        empty = _core.Polyhedron([], [])
        return SpaceSum(empty, [], [], time.perf_counter() - start)
    if P.body is None:
        _only_one(P, Q)
        corners = P.surface.scaled(scaling).written_points()
        swapped = _with_corners(Q, ONCE, corners)
        pairs = [(q, p) for p, q in swapped.vertex_parents]
        faces = [(q, p) for p, q in swapped.facet_parents]
        return SpaceSum(swapped.surface, pairs, faces, time.perf_counter() - start)
    found = _with_corners(P, scaling, Q.surface.written_points())
    return SpaceSum(
        found.surface, found.vertex_parents, found.facet_parents, time.perf_counter() - start
    )


def _only_one(P: SpaceOperand, Q: SpaceOperand) -> None:
    if Q.body is None:
        raise Refusal(
            "neither operand has volume",
            f"{P.name} and {Q.name}",
            "with a point or a segment, give a polyhedron",
            "not-solid",
        )


def _with_corners(body: SpaceOperand, scaling: Scaling, corners: list[Scaling]) -> SpaceSum:
    """Add a point or a segment to the scaled body."""
    if len(corners) == 2:
        first, last = corners
        made = refusing(
            body.name, lambda: _core.convex_sum_with_segment(solid(body), scaling, first, last)
        )
        return SpaceSum(made.surface, made.vertex_parents, made.facet_parents, 0)
    surface = solid(body).surface()
    pairs = [(k, 0) for k in range(surface.vertices)]
    faces: list[Face] = [(sorted(ring), [0]) for ring in surface.rings()]
    return SpaceSum(surface.scaled(scaling).translated(corners[0]), pairs, faces, 0)
