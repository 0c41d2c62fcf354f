"""The document of `convolution` in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.space.values import Face, Polyhedron, SpaceScale
from minkref.schemas.values import (
    Amount,
    Count,
    FileIsExact,
    InSpace,
    LastingHead,
    Operands,
    Pair,
    SpacePoint,
    Written,
)
from msgspec import Meta

ConvolutionFacetKind = Literal["fv", "vf", "ee", "fe", "ef", "ff"]


ConvexPolyhedron = Annotated[Polyhedron, Meta(description="A polyhedron in canonical form.")]


class FacetKinds(TypedDict):
    """How many facets there are of each kind; the first letter is of the face of P, the second of
    that of Q."""

    fv: Count
    vf: Count
    ee: Count
    fe: Count
    ef: Count
    ff: Count


class ConvolutionOperands(TypedDict):
    """P, not scaled, and Q in canonical form: coplanar faces merged, flat vertices dropped. The
    empty set, points and segments have no faces."""

    P: ConvexPolyhedron
    Q: ConvexPolyhedron


class ConvolutionFacet(TypedDict):
    kind: Annotated[
        ConvolutionFacetKind,
        Meta(description="Of the parents: facet, edge or vertex of P, then of Q."),
    ]
    P: Annotated[
        list[Count],
        Meta(description="The face of P by its vertices, numbered as in `operands`.", min_length=1),
    ]
    Q: Annotated[list[Count], Meta(description="The face of Q by its vertices.", min_length=1)]
    ring: Annotated[
        Face, Meta(description="Its vertices in `vertices`, counter-clockwise seen from outside.")
    ]


class SpaceConvolutionDocument(LastingHead, InSpace, Operands, Written):
    """The document of `minkref convolution --json` for convex polyhedra."""

    command: Literal["convolution"]
    scale: SpaceScale
    output_exact: FileIsExact
    compute_seconds: Annotated[
        Amount | None, Meta(description="Of the sum and the proof that it is closed and convex.")
    ]
    count: Annotated[Count, Meta(description="All facets.")]
    kinds: FacetKinds
    vertices: Annotated[
        list[SpacePoint], Meta(description="Of the sum, in canonical order; exact.")
    ]
    vertex_parents: Annotated[
        list[Pair],
        Meta(
            description="For each vertex the one vertex of P and the one of Q whose sum it is, "
            "numbered as in `operands`."
        ),
    ]
    operands: ConvolutionOperands
    facets: Annotated[
        list[ConvolutionFacet] | None,
        Meta(description="In canonical order; null where they were written to another place."),
    ]
