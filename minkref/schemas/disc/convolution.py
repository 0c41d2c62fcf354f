"""The document of `convolution` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import RadiusOrRoot, RoundedPoint, ShapeFeature
from minkref.schemas.values import Amount, Count, Fraction, LastingHead, Operands, Point, Written
from msgspec import Meta


class CurveEnd(TypedDict):
    """The point of P that is moved by the radius along the normal."""

    point: Point
    normal: Annotated[Point, Meta(description="Outwards, in coprime integers.")]
    near: Annotated[RoundedPoint, Meta(description="The end itself, rounded; null beyond doubles.")]


CurveEnds = TypedDict("CurveEnds", {"from": CurveEnd, "to": CurveEnd})


class ConvolutionCurve(CurveEnds):
    """A segment, or the arc counter-clockwise about a vertex; P is on the left."""

    kind: Literal["segment", "arc"]
    parent: Annotated[
        ShapeFeature, Meta(description="The edge, by ring and first vertex, or the convex vertex.")
    ]


class DiscConvolutionDocument(LastingHead, Operands, Written):
    """The document of `minkref convolution --json` with a disc: the reduced convolution."""

    command: Literal["convolution"]
    scale: Fraction
    radius: RadiusOrRoot
    squared_radius: Fraction
    compute_seconds: Amount | None
    count: Annotated[Count, Meta(description="All curves, also those that --limit leaves out.")]
    segments: Count
    arcs: Count
    curves: Annotated[
        list[ConvolutionCurve] | None,
        Meta(description="Segments first; null where they were written to another place."),
    ]
