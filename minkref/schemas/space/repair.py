"""Rows of `sweep` in space with the paper's own repair."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.space.values import FacetKind, SpaceScale, VolumeApproximate
from minkref.schemas.values import Amount, Count, Number, Pair
from msgspec import Meta

Fault = Literal["not-supporting", "overlapping", "missing"]


VertexPair = Annotated[Pair, Meta(description="A vertex of P and one of Q, or two of one body.")]


class ClaimedFacet(TypedDict):
    kind: FacetKind | None
    ring: Annotated[list[VertexPair], Meta(min_length=3)]


class RepairFaults(TypedDict):
    """Beside the exact sum."""

    same_facets: bool
    ulps: Annotated[
        Amount | None,
        Meta(
            description="The largest distance of a coordinate from the right one, in units in the "
            "last place of the largest; null where facets differ or it is beyond the range of "
            "doubles."
        ),
    ]
    fault: Annotated[
        Fault | None,
        Meta(
            description="not-supporting: a vertex of the sum is above the claimed facet. "
            "overlapping: it shares an area with another. missing: a part of this facet of the sum "
            "is in none."
        ),
    ]
    facet: ClaimedFacet | None
    vertex: Annotated[VertexPair | None, Meta(description="That is above the facet.")]


class DescentStep(TypedDict):
    vertex: Count
    witness: Annotated[Count, Meta(description="The other end of the edge.")]
    squared_degree: Annotated[Number, Meta(description="IC squared, as the arithmetic has it.")]


class RepairedError(TypedDict):
    kind: Literal["fv", "vf"]
    facet: Count
    vertex: Annotated[Count, Meta(description="Of the other body, before.")]
    end: Annotated[
        Count | None, Meta(description="The vertex found; null: the descent never ends.")
    ]
    steps: list[DescentStep]


class RepairedChain(TypedDict):
    edge: VertexPair
    before: list[VertexPair]
    after: list[VertexPair]
    stuck: bool


class RepairTrace(TypedDict):
    errors: list[RepairedError]
    chains: Annotated[
        list[RepairedChain], Meta(description="Edges of P whose compatible edges of Q changed.")
    ]


class RepairRow(TypedDict):
    scale: SpaceScale
    volume: Annotated[
        Number,
        Meta(
            description="What the claimed facets enclose, in the coordinates of the arithmetic; "
            "exact."
        ),
    ]
    volume_approximate: VolumeApproximate
    vertices: Annotated[
        Count, Meta(description="Pairs of vertices that are corners of claimed facets.")
    ]
    facets: Annotated[Count, Meta(description="Claimed fv-, vf- and ee-facets, each by itself.")]
    fv_errors: Annotated[
        Count, Meta(description="Facets of P whose vertex of Q is not compatible.")
    ]
    vf_errors: Annotated[
        Count, Meta(description="Facets of Q whose vertex of P is not compatible.")
    ]
    ee_errors: Annotated[Count, Meta(description="Pairs of edges that were found to be no more.")]
    descent_steps: Annotated[Count, Meta(description="Edges walked along witnesses.")]
    chains_walked: Annotated[
        Count, Meta(description="Edges of P whose compatible edges were looked for again.")
    ]
    without_end: Annotated[
        Count, Meta(description="Descents that come to a vertex again, and so never end.")
    ]
    chains_stuck: Annotated[
        Count, Meta(description="Edges of P along which no compatible edge led on.")
    ]
    update_seconds: Amount | None
    sum_seconds: Annotated[
        Amount | None, Meta(description="Of the list of claimed facets and their coordinates.")
    ]
    exact: RepairFaults
    trace: Annotated[RepairTrace | None, Meta(description="With --trace.")]
    file: str | None
    file_exact: bool | None
