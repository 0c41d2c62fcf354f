"""The boundary of a sum in space, as commands pass it on."""

from __future__ import annotations

from dataclasses import dataclass

from minkref import _core
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling
from minkref.space.space_sum import Face


@dataclass(frozen=True)
class SumFacet:
    """A connected part of the boundary within the plane numbered `plane` in the canonical form.
    `rings`: the outer ring first, then holes, then rings that run there and back along inner edges;
    `tips`: vertices that touch the inside; `parents`: faces of P and Q by their vertices."""

    plane: int
    rings: list[list[int]]
    tips: list[int]
    parents: list[Face]


@dataclass(frozen=True)
class SumSurface:
    """An exact surface. Has vertices also where an edge goes straight on and another begins."""

    boundary: _core.SumSurface
    facets: list[SumFacet]

    def counts(self) -> dict[str, int]:
        names = ("components", "cavities", "tunnels")
        return {
            "vertices": self.boundary.vertices,
            "edges": self.boundary.edges,
            "facets": self.boundary.facets,
            **dict(zip(names, self.boundary.topology(), strict=True)),
        }


def sum_surface(
    found: _core.PolyhedralSet, P: SpaceOperand, Q: SpaceOperand, scaling: Scaling
) -> SumSurface:
    """Compute the surface of S P ⊕ Q. Parents have the numbers of the operands' canonical form."""
    boundary = found.surface()
    parents = boundary.parents(P.canonical(), Q.canonical(), scaling)
    facets = [
        SumFacet(*row, [(list(p), list(q)) for p, q in pairs])
        for row, pairs in zip(boundary.rings(), parents, strict=True)
    ]
    return SumSurface(boundary, facets)
