"""The index of all scales beside CGAL."""

from __future__ import annotations

from typing import Annotated, TypedDict

from minkref.schemas.values import Amount, Count
from msgspec import Meta


class QuerySpread(TypedDict):
    count: int
    mean: float
    lower: float
    median: float
    upper: float


class LazyIndex(TypedDict):
    """An index that is built when single sums have cost as much, asked for doubles."""

    single_sums: Annotated[Count, Meta(description="Queries answered before it was built.")]
    first_seconds: Annotated[Amount, Meta(description="Of making it and the first query.")]
    seconds_when_built: Annotated[
        Amount, Meta(description="Of all queries up to the one that built it.")
    ]
    pays_from: Annotated[
        int | None,
        Meta(
            description="From how many queries on all of them together, the build included, take "
            "no longer than as many sums of CGAL."
        ),
    ]


class IndexForm(TypedDict):
    query: Annotated[
        QuerySpread, Meta(description="Seconds of a query, the least of some passes at each scale.")
    ]
    floor_ratio: Annotated[
        float | None,
        Meta(
            description="Over evaluating the same vertices in this form and nothing else; null "
            "where there are none."
        ),
    ]
    cgal_ratio: Annotated[
        float | None, Meta(description="CGAL's reduced convolution over a query, in means.")
    ]
    break_even: Annotated[
        int | None,
        Meta(description="From how many queries on it pays to have built the index, against CGAL."),
    ]


class IndexForms(TypedDict):
    double: IndexForm
    homogeneous: IndexForm
    rational: IndexForm
    track: IndexForm
    area: IndexForm


class IndexRow(TypedDict):
    name: str
    small: Annotated[bool, Meta(description="One of the 25 pairs of the paper's table.")]
    edges: Annotated[Count, Meta(description="Of the reduced convolution.")]
    boundary_events: Count
    build_seconds: Annotated[Amount, Meta(description="The least of `builds`.")]
    builds: Count
    bytes: Annotated[Count, Meta(description="Of the file.")]
    vertices: Annotated[Amount, Meta(description="Of the sums, in the mean.")]
    cgal: Annotated[
        QuerySpread | None,
        Meta(
            description="Seconds of CGAL's reduced convolution at some of the scales; null where "
            "it gave no answer."
        ),
    ]
    build_in_cgal_calls: float | None
    lazy: LazyIndex
    forms: IndexForms


class IndexRatios(TypedDict):
    """Of cgal_ratio over the 25 small pairs; null where not all were timed."""

    double: float | None
    homogeneous: float | None
    rational: float | None
    track: float | None
    area: float | None


class IndexBench(TypedDict):
    queries: Annotated[Count, Meta(description="Scales at which each pair was asked.")]
    rows: list[IndexRow]
    mean_ratios: IndexRatios
    notes: list[str]
    wrong: Annotated[list[str], Meta(description="Sums that differ from the static ones.")]
