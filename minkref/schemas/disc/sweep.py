"""The document of `sweep` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import Enclosure, PartsOfTheDiagram, Radius, RadiusOrRoot
from minkref.schemas.grammar import Either
from minkref.schemas.plane.values import BesideExact, Readings
from minkref.schemas.values import Amount, AnySweep, Count, Digest, MaybeEroded
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


class DiscProgramCounts(TypedDict):
    """Counts on the route `paper-update`, as in `minkref sum`."""

    segments: Count
    arcs: Count
    pairs: Count
    meetings: Count
    undecided: Count


class DiscProgramRow(TypedDict):
    """An answer of the route `paper-update`."""

    scale: Annotated[Radius, Meta(description="Of the disc.")]
    radius: RadiusOrRoot
    digest: Annotated[Digest, Meta(description="SHA-256 of the answer's canonical form.")]
    components: Count
    holes: Count
    curves: Count
    insertions: Annotated[Count, Meta(description="Of intersections, since the scale before.")]
    deletions: Count
    updated: Annotated[Count, Meta(description="Intersections at this scale.")]
    update_seconds: Amount
    sum_seconds: Amount
    exact: BesideExact
    file: str | None
    file_exact: bool | None


class DiscProgramEvents(TypedDict):
    """The array of events beside the exact one, by features and branch; right: with half of the
    digits, and in exact numbers all."""

    right: Count
    misplaced: Count
    missed: Count
    invented: Count


class DiscSweepDocument(AnySweep, MaybeEroded):
    """The document of `minkref sweep --json` with a disc."""

    command: Literal["sweep"]
    P: Annotated[str, Meta(description="The operand as named.")]
    Q: Annotated[
        str,
        Meta(
            description="The disc; on the route `paper-update` it may have a radius, that at the "
            "scale 1.",
            pattern="^disc(:.*)?$",
        ),
    ]
    route: Literal["index", "paper-update"]
    arithmetic: Annotated[
        str, Meta(description="Of the route `paper-update`; the other one is exact.")
    ]
    readings: Readings
    events: DiscProgramEvents | None
    first_wrong: Annotated[
        Radius | None,
        Meta(description="Of the route `paper-update`: the first scale with another set."),
    ]
    format: DiscSweepFormat | None
    preprocessing_seconds: Annotated[
        Amount | None, Meta(description="Of all events and the index.")
    ]
    statistics: Either[SweepStatistics, DiscProgramCounts]
    rows: Annotated[list[Either[DiscSweepRow, DiscProgramRow]], Meta(min_length=1)]
