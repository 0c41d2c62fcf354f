"""The document of `sweep` in the plane."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypedDict

from minkref.schemas.grammar import Either
from minkref.schemas.plane.values import (
    AreaApproximate,
    BesideExact,
    PaperRun,
    PlaneScale,
    SweepRoute,
)
from minkref.schemas.values import (
    Amount,
    AnySweep,
    Count,
    Digest,
    FileIsExact,
    MaybeEroded,
    Number,
    Operands,
)
from msgspec import Meta

SweepFormat = Literal["json", "wkt", "geojson", "poly", "svg"]


class SweepRow(TypedDict):
    scale: Number
    digest: Annotated[
        Digest,
        Meta(description="SHA-256 of the canonical JSON of the sum, as `minkref sum` has it."),
    ]
    area: Annotated[Number, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    components: Annotated[Count, Meta(description="Connected components of the interior.")]
    holes: Annotated[Count, Meta(description="Bounded connected components of the complement.")]
    vertices: Annotated[Count, Meta(description="Of the canonical form, over all rings.")]
    insertions: Annotated[
        Count | None,
        Meta(
            description="Of nodes along edges of the convolution, since the scale before (the "
            "first row: since the beginning of the window). An intersection is a node of each of "
            "its two edges. This and the next five are null on the route `index`, which takes no "
            "steps."
        ),
    ]
    deletions: Count | None
    swaps: Annotated[Count | None, Meta(description="Of neighbours along an edge.")]
    updated: Annotated[Count | None, Meta(description="Nodes that stayed and have moved.")]
    event_scales: Annotated[
        Count | None, Meta(description="Scales of events crossed, entered or left.")
    ]
    update_seconds: Annotated[Amount | None, Meta(description="Of the step.")]
    sum_seconds: Annotated[
        Amount | None, Meta(description="Of the sum in canonical form, after the step.")
    ]
    file: Annotated[str | None, Meta(description="In the folder `output`; null without one.")]
    file_exact: FileIsExact
    exact: BesideExact


class AxesSweepRow(TypedDict):
    """The sum of convex operands at a scale with a factor for each axis, after an update."""

    scale: PlaneScale
    digest: Digest
    area: Annotated[Number, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    components: Count
    holes: Count
    vertices: Count
    ev_errors: Annotated[Count, Meta(description="Edges of P whose vertex of Q changed.")]
    ve_errors: Annotated[Count, Meta(description="Edges of Q whose vertex of P changed.")]
    descent_steps: Annotated[
        Count, Meta(description="Edges walked from the old vertices to the new ones.")
    ]
    update_seconds: Annotated[Amount | None, Meta(description="Of the step.")]
    sum_seconds: Annotated[
        Amount | None, Meta(description="Of the sum in canonical form, after the step.")
    ]
    file: str | None
    file_exact: bool | None


class SweepDocument(AnySweep, Operands, PaperRun, MaybeEroded):
    """The document of `minkref sweep --json`, and index.json of its folder."""

    command: Literal["sweep"]
    format: Annotated[SweepFormat | None, Meta(description="Of the files in it.")]
    preprocessing_seconds: Annotated[
        Amount | None,
        Meta(description="Of finding all events from the least to the greatest scale, once."),
    ]
    statistics: Annotated[
        dict[str, Any],
        Meta(
            description="Counts of the dynamic sum: edges of the convolution, events, changes of "
            "nodes."
        ),
    ]
    rows: Annotated[
        list[Either[SweepRow, AxesSweepRow]],
        Meta(
            description="One for each scale, in the order in which they were visited.", min_length=1
        ),
    ]
    route: Annotated[
        SweepRoute,
        Meta(
            description="How the sums were got: `index`, read off the boundary of the swept sum; "
            "`dynamic`, by dynamic update; `winding`, by dynamic update of the full convolution "
            "and its winding numbers; `paper-update`, by the paper's own program, formula by "
            "formula."
        ),
    ]
    first_wrong: Annotated[
        Number | None,
        Meta(
            description="Of the route `paper-update`: the first scale, in the order of the rows, "
            "at which the structure is another one; null where there is none."
        ),
    ]
