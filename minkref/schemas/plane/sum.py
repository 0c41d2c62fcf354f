"""The document of `sum` in the plane."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypedDict

from minkref.schemas.plane.erode import ExactFit
from minkref.schemas.plane.values import (
    AreaApproximate,
    BesideExact,
    PlaneScale,
    PolygonSet,
    Readings,
    TightPassage,
)
from minkref.schemas.values import (
    Amount,
    AskedPlace,
    Count,
    Digest,
    FileIsExact,
    Head,
    Number,
    Operands,
    Written,
)
from msgspec import Meta

SumRoute = Literal["paper", "winding", "definition", "dynamic", "index", "proved", "paper-update"]


class SignShares(TypedDict):
    by_float: Amount
    by_integer: Amount
    by_rational: Amount


class SumSigns(TypedDict):
    by_float: Count
    by_integer: Count
    by_rational: Count
    total: Count
    shares: SignShares


class ExactSum(TypedDict):
    digest: Digest
    area: Number
    area_approximate: float | None
    components: Count
    holes: Count
    vertices: Count
    equal: Annotated[
        bool | None,
        Meta(description="The digests are equal; null where there is no result to compare."),
    ]


class SumStep(TypedDict):
    """The work of the step from scale to scale, as in the rows of `minkref sweep`."""

    insertions: Count
    deletions: Count
    swaps: Count
    updated: Count
    groups: Annotated[Count, Meta(description="Scales of events that were crossed.")]
    seconds: Amount


SumStart = TypedDict(
    "SumStart",
    {
        "from": Annotated[
            Number | None,
            Meta(description="The scale at which the update began; null: there was none."),
        ]
    },
)


class SumDocument(Head, Operands, Written, SumStart):
    """The document of `minkref sum --json`."""

    command: Literal["sum"]
    scale: PlaneScale
    output_exact: FileIsExact
    at: AskedPlace
    route: SumRoute
    step: SumStep | None
    arithmetic: Annotated[str, Meta(pattern="^(rational|interval|double|mpfr:[0-9]+)$")]
    undecided: Annotated[
        bool,
        Meta(
            description="The arithmetic could not decide a sign (intervals that hold zero, an "
            "overflow that is no number): there is no result."
        ),
    ]
    compute_seconds: Annotated[
        Amount | None,
        Meta(
            description="Of the sum and, where the arithmetic is rational, its tight passages, "
            "without reading, area and digest."
        ),
    ]
    digest: Annotated[
        Digest | None, Meta(description="SHA-256 of the canonical JSON; null where undecided.")
    ]
    area: Annotated[Number | None, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    components: Annotated[Count | None, Meta(description="Connected components of the interior.")]
    holes: Annotated[
        Count | None, Meta(description="Bounded connected components of the complement.")
    ]
    vertices: Annotated[Count | None, Meta(description="Of the canonical form, over all rings.")]
    result: Annotated[PolygonSet | None, Meta(description="The sum in canonical form.")]
    tight_passages: Annotated[
        list[TightPassage] | None,
        Meta(
            description="The points and polylines inside of the sum that the sum of the interiors "
            "misses, in canonical order; null for another arithmetic than rational, since only "
            "exact ones mean anything, and for two operands without area."
        ),
    ]
    remnants: Annotated[
        list[ExactFit] | None,
        Meta(
            description="For two operands of points and segments: the points and polylines of the "
            "sum beside its region, in canonical order, without contacts. Else null."
        ),
    ]
    signs: Annotated[
        SumSigns | None,
        Meta(
            description="How many signs the float filter, integers of fixed width and rationals "
            "decided. For another arithmetic than rational by_float counts all of them: that "
            "arithmetic decided them. Null for the route dynamic, which does not count them."
        ),
    ]
    statistics: Annotated[
        dict[str, Any] | None,
        Meta(
            description="Counts of the computation: kernel, edges of the convolution, nodes and "
            "faces of its arrangement."
        ),
    ]
    exact: Annotated[
        ExactSum | None,
        Meta(
            description="For another arithmetic than rational, and for the route `paper-update`: "
            "what is true."
        ),
    ]
    readings: Readings
    comparison: BesideExact
