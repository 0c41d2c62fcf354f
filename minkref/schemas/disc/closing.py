"""Documents: `opening` and `closing` by a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.erode import InwardSet
from minkref.schemas.disc.sum import CurvedSet
from minkref.schemas.disc.values import Enclosure, ExactPoint, Radius, RadiusOrRoot, RoundedPoint
from minkref.schemas.values import Amount, Count, Digest, Fraction, Head, Operands, Written
from msgspec import Meta

ClosingStep = TypedDict(
    "ClosingStep",
    {
        "kind": Literal["line", "arc"],
        "from": RoundedPoint,
        "to": RoundedPoint,
        "centre": Annotated[RoundedPoint | None, Meta(description="Of an arc.")],
    },
)


class ClosingArc(TypedDict):
    centre: ExactPoint
    ends: Annotated[
        list[ExactPoint],
        Meta(
            description="Two points of the circle: the ends of the arc, or of a longer arc of "
            "which it is a part.",
            min_length=2,
            max_length=2,
        ),
    ]


class MorphologyWithDisc(Head, Operands, Written):
    """What both documents have."""

    scale: Fraction
    output_exact: Annotated[
        bool | None,
        Meta(description="The file holds the very set; false where it is a picture or a polygon."),
    ]
    tolerance: Annotated[
        Radius | None, Meta(description="How far the discs of the polygon written may be off.")
    ]
    radius: Annotated[RadiusOrRoot, Meta(description="Of the disc: a number, or the root of one.")]
    squared_radius: Fraction
    compute_seconds: Amount
    digest: Annotated[
        Digest | None,
        Meta(
            description="SHA-256 of the canonical text; null for an opening through places at "
            "which the disc just fits."
        ),
    ]
    components: Annotated[Count, Meta(description="Of the interior.")]
    holes: Annotated[Count, Meta(description="Bounded components of the complement.")]
    area: Annotated[Enclosure, Meta(description="Between two doubles; null beyond these.")]
    rings: Annotated[
        list[list[ClosingStep]],
        Meta(
            description="The boundary in nearest doubles. Arcs run counter-clockwise; a closing "
            "lies on the right, an opening on the left."
        ),
    ]
    arcs: Annotated[
        list[ClosingArc], Meta(description="All arcs, exactly, in the order of the rings.")
    ]


class ClosingForm(TypedDict):
    """The canonical form: the sum with the disc, which tells the closing."""

    closing: CurvedSet


class OpeningForm(TypedDict):
    """The canonical form: the erosion by the disc, which tells the opening."""

    opening: InwardSet


class DiscClosingDocument(MorphologyWithDisc):
    """The document of `minkref closing --json` with a disc."""

    command: Literal["closing"]
    result: ClosingForm


class DiscOpeningDocument(MorphologyWithDisc):
    """The document of `minkref opening --json` with a disc."""

    command: Literal["opening"]
    result: OpeningForm | None
