"""Documents: `erode` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.sum import CurvedPolygon, DiscPassage, PairStatistics
from minkref.schemas.disc.values import Enclosure, Radius, RadiusOrRoot
from minkref.schemas.values import Amount, Count, Digest, Fraction, Head, Operands, Written
from msgspec import Meta

DiscErodeRoute = Literal["definition", "paper"]


class InwardSet(TypedDict):
    """The canonical form (docs/erosion.md): rings have the set on their right."""

    components: list[CurvedPolygon]
    inward: Literal[True]
    squared_radius: Fraction


class DiscErodeDocument(Head, Operands, Written):
    """The document of `minkref erode --json` with a disc."""

    command: Literal["erode"]
    scale: Fraction
    output_exact: Annotated[
        bool | None,
        Meta(description="The file holds the very set; false where it is a picture or a polygon."),
    ]
    tolerance: Annotated[
        Radius | None, Meta(description="How far the disc of the polygon written may be off.")
    ]
    radius: Annotated[RadiusOrRoot, Meta(description="Of the disc: a number, or the root of one.")]
    squared_radius: Fraction
    route: DiscErodeRoute
    compute_seconds: Amount
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical text.")]
    components: Count
    holes: Count
    curves: Annotated[
        Count,
        Meta(
            description="Of all rings; parts of one circle or line that follow each other are one."
        ),
    ]
    area: Annotated[Enclosure, Meta(description="Between two doubles; null beyond these.")]
    length: Annotated[Enclosure, Meta(description="Of the boundary.")]
    remnants: Annotated[
        list[DiscPassage],
        Meta(
            description="Points and segments beside the region: there the disc just fits between."
        ),
    ]
    result: InwardSet
    statistics: PairStatistics
