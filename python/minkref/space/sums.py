"""What every document says of a sum in space."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.exact import digest, in_double_range
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

ROUTES = ("traversal", "brute-force", "dynamic")
Face = tuple[list[int], list[int]]


@dataclass(frozen=True)
class SpaceSum:
    """In canonical form; `facet_parents` are faces of P and Q by their vertices."""

    surface: _core.Polyhedron
    vertex_parents: list[tuple[int, int]]
    facet_parents: list[Face]
    seconds: float


def compute(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str) -> SpaceSum:
    """S P ⊕ Q, exact. Refuses operands without volume."""
    first, second = _solid(P), _solid(Q)

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
    """Exact, but for `volume_approximate`."""
    volume = str(Fraction(answer.surface.sextuple_volume()) / 6)
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
    return _solid(P), _solid(Q)


def _solid(operand: SpaceOperand) -> _core.ConvexPolyhedron:
    if operand.body is None:
        raise Refusal(
            "the operand has no volume",
            operand.name,
            "give a convex polyhedron by its faces",
            "not-solid",
        )
    return operand.body
