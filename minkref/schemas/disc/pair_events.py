"""The document of `events --kind pair` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import (
    Polynomial,
    Radius,
    RadiusBetween,
    RadiusOrRoot,
    RadiusWindow,
    RoundedPoint,
    ShapeFeature,
)
from minkref.schemas.values import Amount, Count, Form, LastingHead, Written
from msgspec import Meta

PairChange = Literal["birth", "death", "touch", "swap", "overlap", "none"]
Condition = Literal["end on line", "end on circle", "circle on line", "circles"]


class PairChanges(TypedDict):
    """Of all events, what becomes of the points that the two features share; none: nothing, as
    printed only."""

    birth: Count
    death: Count
    touch: Count
    swap: Count
    overlap: Count
    none: Count


ConditionsOfEnds = TypedDict(
    "ConditionsOfEnds", {"end on line": Count, "end on circle": Count, "circle on line": Count}
)


class Conditions(ConditionsOfEnds):
    """Of all events, which condition holds; a tangent before others."""

    circles: Count


class PairTruth(TypedDict):
    count: Count
    right: Count
    missed: Count
    invented: Count


class SharedPoints(TypedDict):
    """Points that the two features share just before the radius, at it and just after it, in
    truth."""

    before: Literal[0, 1, 2]
    at: Literal[0, 1, 2, "segment"]
    after: Literal[0, 1, 2]


class PairContact(TypedDict):
    condition: Condition
    of: Annotated[
        Literal[0, 1, None],
        Meta(
            description="Which of the two features comes to the other with an end; null at a "
            "tangent."
        ),
    ]
    end: Annotated[
        Literal["first", "last", None],
        Meta(description="Which end, the polygon being on the left."),
    ]
    meets: Annotated[
        bool,
        Meta(
            description="Whether the place is on both features, and not only on the line or circle "
            "that one is a part of. As printed it may not be."
        ),
    ]
    place: Annotated[RoundedPoint, Meta(description="Rounded.")]


class DiscPairEvent(TypedDict):
    rank: Annotated[Count, Meta(description="Events of one radius have one rank.")]
    condition: Condition
    change: PairChange
    radius: RadiusBetween
    squared_radius: Annotated[Radius | None, Meta(description="Where it is rational.")]
    polynomial: Polynomial
    features: Annotated[
        list[ShapeFeature],
        Meta(
            description="The two: arcs by the coordinates of their vertex, edges by ring and first "
            "vertex.",
            min_length=2,
            max_length=2,
        ),
    ]
    shared: SharedPoints
    contacts: Annotated[
        list[PairContact], Meta(description="All conditions that hold at the radius.", min_length=1)
    ]


class DiscPairEventsDocument(LastingHead, RadiusWindow, Written):
    """The document of `minkref events --kind pair --json` with a disc."""

    command: Literal["events"]
    P: Annotated[str, Meta(description="The operand as named.")]
    Q: Annotated[
        str,
        Meta(
            description="The disc; with --form printed it may have a radius, which is that at the "
            "scale 1.",
            pattern="^disc(:.*)?$",
        ),
    ]
    kind: Literal["pair"]
    form: Form
    readings: Annotated[
        dict[str, str] | None,
        Meta(description="With --reading: how each sentence of the Appendix is read."),
    ]
    radius: Annotated[
        RadiusOrRoot | None,
        Meta(
            description="Of the disc at the scale 1, by which printed formulas are written: a "
            "number, or the root of one; null if no sentence is as printed."
        ),
    ]
    compute_seconds: Amount | None
    features: Annotated[Count, Meta(description="Offset edges, and arcs about convex vertices.")]
    pairs: Annotated[Count, Meta(description="Of features: all.")]
    filtered_pairs: Annotated[
        Count, Meta(description="That boxes tell apart up to the last radius.")
    ]
    exact_signs: Annotated[Count, Meta(description="That roots had to decide.")]
    changes: PairChanges
    conditions: Conditions
    count: Annotated[Count, Meta(description="Of events in the window, listed or not.")]
    truth: Annotated[
        PairTruth | None,
        Meta(
            description="Of the printed events, how many are there where something changes for the "
            "two features; how many changes they miss."
        ),
    ]
    events: Annotated[
        list[DiscPairEvent] | None,
        Meta(description="By radius; null where they were written to a file."),
    ]
