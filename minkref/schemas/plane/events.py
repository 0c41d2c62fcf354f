"""The document of `events` in the plane."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from minkref.schemas.plane.values import Misplaced, PairEvent, Parent, Ring, Segments
from minkref.schemas.values import (
    Amount,
    Count,
    Form,
    LastingHead,
    MaybeEroded,
    Number,
    Operands,
    Point,
    Written,
)
from msgspec import Meta

EventsRoute = Literal["dynamic", "index", "winding"]
EventsKind = Literal["pair", "parallel", "triple", "arrangement", "boundary", "topology"]
EventKind = Literal["pair", "parallel", "triple", "boundary", "topology"]


EventsWindow = TypedDict(
    "EventsWindow",
    {
        "from": Annotated[
            Number | None,
            Meta(description="Begin of the closed window of scales; null: open to 0."),
        ],
        "to": Annotated[
            Number | None, Meta(description="End of the closed window; null: endless.")
        ],
    },
)


class CutOperands(TypedDict):
    """The rings of operands with holes, cut along slits; null for an operand without holes."""

    P: list[Ring] | None
    Q: list[Ring] | None


class EventSigns(TypedDict):
    """Signs of the exact stage: decided by floats, by integers of fixed width, by rationals."""

    by_float: Count | None
    by_integer: Count | None
    by_rational: Count | None


class LeastPrecision(TypedDict):
    bits: Annotated[int, Meta(ge=2)] | None
    most_tried: int


class Lifetime(TypedDict):
    id: Count
    birth: Annotated[
        Number | None, Meta(description="The scale; null: there when the window begins.")
    ]
    death: Annotated[
        Number | None, Meta(description="The scale; null: there when the window ends.")
    ]


class Event(TypedDict):
    s: Number
    rank: Annotated[
        Count,
        Meta(
            description="How many different scales among all events of the list, those that "
            "--where leaves out too, lie below this one: events of equal scale have equal rank."
        ),
    ]
    kind: EventKind
    change: Annotated[
        Literal["birth", "death", "touch", "overlap", "swap", "merge", "split"],
        Meta(
            description="As s grows. Pair and parallel events: the edges start to meet, stop, meet "
            "at this scale only, share a segment at this scale only; ends of edges on one line "
            "pass each other (swap). Triple events: nodes along an edge swap. Boundary events: "
            "more vertices, fewer, as many others, the same (touch). Topology events: a feature is "
            "born, dies, several merge, one splits, one touches itself."
        ),
    ]
    parents: Annotated[
        list[Parent],
        Meta(
            description="The edges of the convolution that meet: two, of triple events three, of "
            "boundary and topology events those through the places where the boundary changes; on "
            "the route `index` those whose sides begin or end there."
        ),
    ]
    at: Annotated[
        Point,
        Meta(
            description="Where it happens: where the edges meet; one of the places where the "
            "boundary changes; where a feature vanishes, appears or touches."
        ),
    ]
    to: Annotated[
        Point | None, Meta(description="The other end, where parallel edges share a segment.")
    ]
    feature: NotRequired[
        Annotated[Literal["hole", "component"], Meta(description="Of topology events.")]
    ]
    before: NotRequired[
        Annotated[
            list[Count], Meta(description="Features just below the scale; hole 0 is the outside.")
        ]
    ]
    after: NotRequired[Annotated[list[Count], Meta(description="Features just above it.")]]
    parts: NotRequired[
        Annotated[
            Count, Meta(description="Into how many connected parts they fall at the scale itself.")
        ]
    ]


class LiteralRow(PairEvent):
    exact: Annotated[
        Number | None,
        Meta(description="The exact scale of the same event; null where there is none."),
    ]


class LiteralEvents(TypedDict):
    readings: dict[str, str]
    right: int
    missed: int
    invented: int
    first_missed: PairEvent | None
    first_invented: PairEvent | None
    rows: list[LiteralRow]
    misplaced: Misplaced


class EventsDocument(LastingHead, Operands, Written, EventsWindow, MaybeEroded):
    """The document of `minkref events --json`."""

    command: Literal["events"]
    kind: EventsKind
    form: Form
    arithmetic: str
    cut: Annotated[
        CutOperands | None,
        Meta(
            description="For the route `winding`: edges and vertices are numbered along "
            "these rings; null on other routes."
        ),
    ]
    where: Annotated[str | None, Meta(description="The condition that --where gives.")]
    compute_seconds: Amount | None
    segments: Segments
    signs: EventSigns
    kernel: Annotated[
        str | None,
        Meta(description="The exact numbers that were used: grid64, grid256 or rational."),
    ]
    count: Annotated[Count, Meta(description="Events found, whatever --where and --limit say.")]
    distinct: Annotated[Count, Meta(description="Different scales among them.")]
    matching: Annotated[
        Count, Meta(description="Those of them that --where keeps; without it all.")
    ]
    matching_distinct: Annotated[Count, Meta(description="Different scales among those.")]
    pairs: Annotated[Count | None, Meta(description="All pairs of edges.")]
    filtered_pairs: Annotated[
        Count | None, Meta(description="Pairs of which floats proved that they never meet.")
    ]
    intersecting_pairs: Annotated[
        Count | None,
        Meta(
            description="Pairs, not parallel, that meet on an interval of scales within the window."
        ),
    ]
    always_meeting_pairs: Annotated[Count | None, Meta(description="Of those: at every scale.")]
    touching_pairs: Annotated[
        Count | None, Meta(description="Pairs, not parallel, that meet at one scale only.")
    ]
    parallel_pairs: Annotated[
        Count | None, Meta(description="Parallel pairs that share a point at some scale.")
    ]
    trial: Annotated[
        dict[str, Any] | None,
        Meta(
            description="With another arithmetic than rational: how the paper's method fares in "
            "it, in counts."
        ),
    ]
    least_precision: Annotated[
        LeastPrecision | None,
        Meta(
            description="With --least-precision: the fewest bits of mpfr at which the paper's "
            "method gets every event right, by doubling and halving; bits is null if none up to "
            "most_tried are enough."
        ),
    ]
    holes: Annotated[
        list[Lifetime] | None,
        Meta(
            description="With --kind topology: every hole of the window; hole 0 is the outside and "
            "is not listed."
        ),
    ]
    components: Annotated[
        list[Lifetime] | None,
        Meta(description="With --kind topology: every component of the interior."),
    ]
    events: Annotated[
        list[Event] | None,
        Meta(
            description="Those that --where keeps, the first of them with --limit. Ascending; null "
            "if they were written to a file."
        ),
    ]
    route: Annotated[
        EventsRoute | None,
        Meta(
            description="Of boundary and topology events: `dynamic`, from all events of the "
            "arrangement, or `index`, from the boundary of the swept sum, on which the counts of "
            "pairs are null. Null for events of the arrangement."
        ),
    ]
    literal: Annotated[
        LiteralEvents | None,
        Meta(
            description="With another arithmetic than rational, or a reading: the array of events "
            "of the paper's program, at all scales, beside the exact one, by edges. `rows` are the "
            "first of them, as many as --limit says."
        ),
    ]
