"""Fields common to all documents about sums in space."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from minkref import _core
from minkref.errors import refusing
from minkref.exact import digest, in_double_range
from minkref.space.degenerate_sum import degenerate_sum
from minkref.space.operand import SpaceOperand, solid
from minkref.space.scaling import Scaling
from minkref.space.space_sum import SpaceSum

ROUTES = ("traversal", "brute-force", "dynamic")


def compute(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str) -> SpaceSum:
    """Compute S P ⊕ Q, exactly. One operand may be the empty set, a point or a segment, whatever
    the route."""
    if P.body is None or Q.body is None:
        return degenerate_sum(P, Q, scaling)
    first, second = P.body, Q.body

    def call() -> _core.ConvexSum:
        if route == "dynamic":
            return _core.DynamicConvexSum(first, second, scaling).sum()
        return _core.convex_sum(first, second, scaling, route)

    return timed(f"{P.name} and {Q.name}", call)


def timed(where: str, call: Callable[[], _core.ConvexSum]) -> SpaceSum:
    start = time.perf_counter()
    answer = refusing(where, call)
    seconds = time.perf_counter() - start
    return SpaceSum(answer.surface, answer.vertex_parents, answer.facet_parents, seconds)


def sum_fields(answer: SpaceSum) -> dict[str, Any]:
    """Return the fields, exact except `volume_approximate`."""
    volume = str(answer.surface.sextuple_volume() / 6)
    rings = answer.surface.rings()
    return {
        "digest": digest(answer.surface.canonical_json()),
        "volume": volume,
        "volume_approximate": in_double_range(volume),
        "vertices": answer.surface.vertices,
        "edges": sum(map(len, rings)) // 2,
        "facets": answer.surface.faces,
    }


def bodies(
    P: SpaceOperand, Q: SpaceOperand
) -> tuple[_core.ConvexPolyhedron, _core.ConvexPolyhedron]:
    return solid(P), solid(Q)
