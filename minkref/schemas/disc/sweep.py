"""The document of `sweep` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import Enclosure, PartsOfTheDiagram, ShapeAndDisc
from minkref.schemas.values import Amount, AnySweep, Count, Digest
from msgspec import Meta

DiscSweepFormat = Literal["json", "svg"]


class SweepStatistics(TypedDict):
    radii_of_events: Annotated[Count, Meta(description="Radii at which something changes.")]
    parts_of_the_diagram: PartsOfTheDiagram
    exact_signs: Annotated[Count, Meta(description="Decisions that roots had to make.")]


class DiscSweepRow(TypedDict):
    radius: Annotated[str, Meta(pattern="^[0-9]+(/[1-9][0-9]*)?$")]
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical form.")]
    components: Annotated[Count, Meta(description="Of the interior.")]
    holes: Annotated[Count, Meta(description="Bounded components of the complement.")]
    curves: Annotated[Count, Meta(description="Of all rings.")]
    at_event: Annotated[
        bool,
        Meta(
            description="Whether the boundary changes at the radius: then the sum is computed, not "
            "read off."
        ),
    ]
    sum_seconds: Annotated[
        Amount | None, Meta(description="Of reading the sum off, with its form.")
    ]
    file: str | None
    file_exact: bool | None
    area: Annotated[Enclosure, Meta(description="Between two doubles; null beyond these.")]
    length: Annotated[Enclosure, Meta(description="Of the boundary.")]


class DiscSweepDocument(AnySweep, ShapeAndDisc):
    """The document of `minkref sweep --json` with a disc."""

    command: Literal["sweep"]
    format: DiscSweepFormat | None
    preprocessing_seconds: Annotated[
        Amount | None, Meta(description="Of all events and the index.")
    ]
    statistics: SweepStatistics
    rows: Annotated[list[DiscSweepRow], Meta(min_length=1)]
