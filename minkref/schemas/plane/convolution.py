"""The document of `convolution` in the plane."""

from __future__ import annotations

from typing import Annotated, Literal

from minkref.schemas.plane.values import Parent, PlaneScale, Segments
from minkref.schemas.values import Amount, Count, LastingHead, Operands, Point, Written
from msgspec import Meta

Compatible = Literal["half-open", "open", "closed"]


class ConvolutionEdge(Parent):
    sign: Annotated[Literal[1, -1], Meta(description="-1 at reflex vertices.")]
    start: Point
    end: Point
    direction: Annotated[Point, Meta(description="From start to end; exact.")]


class ConvolutionDocument(LastingHead, Operands, Written):
    """The document of `minkref convolution --json`."""

    command: Literal["convolution"]
    scale: PlaneScale
    full: Annotated[bool, Meta(description="Whether edges at reflex vertices belong to it.")]
    compatible: Annotated[
        Compatible, Meta(description="Which ends of the turn at a vertex belong to it.")
    ]
    output_exact: Annotated[
        bool | None,
        Meta(
            description="The coordinates in the file are exact; false where its format knows "
            "decimals only, or is a picture."
        ),
    ]
    compute_seconds: Annotated[
        Amount | None, Meta(description="Of finding the edges, without reading and writing.")
    ]
    count: Annotated[Count, Meta(description="All edges, also those that --limit leaves out.")]
    segments: Annotated[Segments, Meta(description="S- and T-edges among them.")]
    negative: Annotated[Count, Meta(description="Edges of the sign -1 among them.")]
    edges: Annotated[
        list[ConvolutionEdge] | None,
        Meta(description="S-edges first; null where they were written to another place."),
    ]
