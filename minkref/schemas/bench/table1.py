"""The paper's Table 1: polygons under uniform scaling."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.bench.spread import Spread
from minkref.schemas.values import Amount, Count
from msgspec import Meta

Baseline = Literal["pairwise", "contacts", "static", "cgal-reduced"]


MeanRatios = Annotated[
    dict[str, float | None],
    Meta(
        description="Of each baseline, over the small pairs; null where not all of them were timed."
    ),
]


class Table1Pair(TypedDict):
    name: str
    small: Annotated[bool, Meta(description="One of the 25 pairs of the paper's table.")]
    edges: Annotated[Count, Meta(description="Of the reduced convolution.")]
    events: Annotated[Count, Meta(description="Pair, parallel and triple events from 1/10 to 10.")]
    preprocessing_seconds: Annotated[Amount, Meta(description="Of finding all events, once.")]
    event_scales_per_step: Annotated[
        Amount, Meta(description="Scales of events crossed by a re-scaling; the mean.")
    ]
    changes_per_step: Annotated[
        Amount, Meta(description="Nodes inserted, deleted and swapped by a re-scaling; the mean.")
    ]
    update: Annotated[Spread, Meta(description="Seconds of the step and of placing all nodes.")]
    update_and_sum: Annotated[
        Spread,
        Meta(
            description="Seconds of the step, of placing all nodes, and of the sum in canonical "
            "form."
        ),
    ]


class Table1Row(TypedDict):
    name: Annotated[str, Meta(description="The pair.")]
    small: bool
    measure: Annotated[
        Literal["intersections", "sum"],
        Meta(description="intersections: ours is the update. sum: ours is the update and the sum."),
    ]
    ours_s: Annotated[Amount, Meta(description="Median.")]
    baseline: Annotated[
        Baseline,
        Meta(
            description="pairwise: all pairs of convolution edges in plain doubles, boxes first "
            "(the paper's: all pairs, in MPFR). contacts: our exact static search. static: our "
            "static sum, route paper. cgal-reduced: CGAL's reduced convolution."
        ),
    ]
    baseline_s: Annotated[Amount, Meta(description="Median.")]
    ratio: Annotated[Amount, Meta(description="Of the means, theirs to ours.")]
    ratios: Annotated[Spread, Meta(description="Of the single re-scalings.")]
    ours: Spread
    theirs: Spread
    rescalings_timed: Annotated[
        Count,
        Meta(description="Both at the same ones: all, or every tenth where the baseline is slow."),
    ]
    rescalings: Count
    preprocessing_seconds: Amount
    break_even: Annotated[
        Count | None,
        Meta(
            description="From how many re-scalings on it pays to have found all events; null: "
            "never."
        ),
    ]


class Table1(TypedDict):
    rescalings: Annotated[Count, Meta(description="Of each pair, out of 0.1, 0.2, ..., 10.")]
    pairs: list[Table1Pair]
    rows: list[Table1Row]
    mean_ratios: MeanRatios
    means_of_ratios: MeanRatios
    median_ratio: Annotated[float | None, Meta(description="Of pairwise, over the small pairs.")]
    paper_mean_ratio: Annotated[
        float, Meta(description="Of the paper's Table 1, over 25 pairs of other polygons.")
    ]
    notes: Annotated[list[str], Meta(description="What was left out, and what stands for what.")]
    wrong: Annotated[
        list[str],
        Meta(description="Sums after an update that differ from the static ones: exit code 1."),
    ]
