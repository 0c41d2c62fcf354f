"""The document of `events` in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.space.values import FacetKind
from minkref.schemas.values import (
    Amount,
    Count,
    Form,
    Fraction,
    InSpace,
    LastingHead,
    Operands,
    Written,
)
from msgspec import Meta

SpaceEventsKind = Literal["pair", "triple", "arrangement"]
SpaceEventKind = Literal["vertex", "edge", "parallel", "triple", "four"]


SpaceEventsWindow = TypedDict(
    "SpaceEventsWindow",
    {
        "from": Annotated[Fraction, Meta(description="Smallest scale, included.")],
        "to": Annotated[Fraction, Meta(description="Largest scale, included.")],
    },
)


class SpaceEventKinds(TypedDict, total=False):
    vertex: Annotated[Count, Meta(description="A corner of one facet touches the other.")]
    edge: Annotated[Count, Meta(description="Sides of both touch.")]
    parallel: Annotated[
        Count, Meta(description="Parallel facets come to lie in one plane and share an area.")
    ]
    triple: Annotated[Count, Meta(description="Three facets start or stop to share a point.")]
    four: Annotated[Count, Meta(description="Four facets share a point.")]


class SpaceEventSigns(TypedDict):
    by_float: Count
    by_integer: Count


class SpaceEventTrial(TypedDict):
    pairs: Annotated[Count, Meta(description="All pairs of facets.")]
    parallel_pairs: Annotated[Count, Meta(description="Parallel, and not always coplanar.")]
    coplanar_pairs: Annotated[Count, Meta(description="Coplanar at all scales.")]
    undecided_pairs: Annotated[
        Count, Meta(description="The arithmetic could not tell a sign; left out below.")
    ]
    roots: Count
    false_inconsistent: Count
    false_identity: Count
    invented_roots: Count
    events: Count
    missed: Count
    invented: Count
    misplaced: Count
    parallel_faces: Annotated[
        Count, Meta(description="Missed: the matrix is singular, for the faces are parallel.")
    ]
    parallel_sides: Annotated[
        Count, Meta(description="Missed: the matrix is singular, for the sides are parallel.")
    ]
    side_along_plane: Annotated[
        Count, Meta(description="Missed: the matrix is singular, for a side is along the plane.")
    ]


class EventFacet(TypedDict):
    facet: Annotated[
        FacetKind,
        Meta(
            description="fv: a face of P at a vertex of Q; vf: a vertex of P at a face of Q; ee: "
            "two edges."
        ),
    ]
    P: Annotated[
        list[Count],
        Meta(
            description="The vertex of P in each corner, counter-clockwise seen from outside.",
            min_length=3,
            max_length=4,
        ),
    ]
    Q: Annotated[
        list[Count], Meta(description="The vertex of Q in each corner.", min_length=3, max_length=4)
    ]
    corner: Annotated[
        Count | None, Meta(description="The corner that touches; null where there is none.")
    ]
    side: Annotated[
        Count | None,
        Meta(description="The side that touches, by its first corner; null where there is none."),
    ]


class SpaceEvent(TypedDict):
    s: Fraction
    kind: SpaceEventKind
    change: Annotated[
        Literal["birth", "death", "touch", "pass"],
        Meta(
            description="As s grows the facets start to meet, stop, meet at this scale only, or "
            "where they meet passes on to other sides."
        ),
    ]
    facets: Annotated[
        list[EventFacet],
        Meta(description="The two, three or four facets.", min_length=2, max_length=4),
    ]
    place: Annotated[
        Annotated[list[Fraction], Meta(min_length=3, max_length=3)] | None,
        Meta(
            description="Where they touch; null of parallel facets without a corner in the other."
        ),
    ]


class SpaceEventsDocument(LastingHead, InSpace, Operands, Written, SpaceEventsWindow):
    """The document of `minkref events --json` in space."""

    command: Literal["events"]
    kind: Annotated[
        SpaceEventsKind,
        Meta(
            description="pair: events of two facets; triple: of three and of four; arrangement: "
            "both."
        ),
    ]
    form: Annotated[Form, Meta(description="Of the paper's way that is on trial.")]
    arithmetic: Annotated[str, Meta(description="Of the paper's way that is on trial.")]
    readings: Annotated[
        dict[str, str] | None,
        Meta(description="Of the paper's way that is on trial, by name; null where there is none."),
    ]
    compute_seconds: Amount | None
    count: Annotated[Count, Meta(description="Events in the window.")]
    distinct: Annotated[Count, Meta(description="Different scales.")]
    kinds: SpaceEventKinds
    facets: Annotated[
        Count, Meta(description="Of the reduced convolution, the same at all scales.")
    ]
    near_pairs: Annotated[
        Count, Meta(description="Pairs of facets whose boxes meet at some scale of the window.")
    ]
    pairs_with_events: Count
    signs: SpaceEventSigns
    trial: Annotated[
        SpaceEventTrial | None,
        Meta(
            description="With another arithmetic than rational, --form printed or --reading: how "
            "the paper's way fares, in counts of all pairs of facets; null otherwise."
        ),
    ]
    events: Annotated[
        list[SpaceEvent] | None, Meta(description="Ascending; null where they went to a file.")
    ]
    tracks: Annotated[
        Count,
        Meta(description="Triples of facets that share points in the window; 0 for --kind pair."),
    ]
