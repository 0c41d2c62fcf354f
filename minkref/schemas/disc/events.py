"""The document of `events` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import DiscEvent, DiscEventCounts, RadiusWindow, ShapeAndDisc
from minkref.schemas.values import Amount, Count, LastingHead, MaybeEroded, Pair, Written
from msgspec import Meta

DiscEventsKind = Literal["boundary", "topology"]


class BornHole(TypedDict):
    hole: Count
    of: Count


class HoleChanges(TypedDict):
    born: list[BornHole]
    ended: list[Count]
    joined: list[Pair]


class ChangingDiscEvent(DiscEvent):
    changes: Annotated[
        HoleChanges | None,
        Meta(
            description="With --kind topology: holes that are born, each with the hole that it was "
            "a part of (0: the outside), holes that end, polygons whose components are one from "
            "here on. Holes are numbered from 1 on, those of P first. With --erode: components of "
            "the erosion for holes, and holes of P for polygons, numbered from 1, 0 being what is "
            "outside of all of P. Otherwise null."
        ),
    ]


class DiscEventsDocument(LastingHead, ShapeAndDisc, RadiusWindow, Written, MaybeEroded):
    """The document of `minkref events --json` with a disc."""

    command: Literal["events"]
    kind: DiscEventsKind
    compute_seconds: Amount | None
    exact_signs: Annotated[Count, Meta(description="That roots had to decide.")]
    counts: DiscEventCounts
    count: Annotated[Count, Meta(description="Of events of the kind.")]
    inradius: Annotated[
        list[DiscEvent] | None,
        Meta(
            description="With --erode: the events at the largest radius of a disc within P, with "
            "the features that bound it. Otherwise null."
        ),
    ]
    events: Annotated[
        list[ChangingDiscEvent] | None,
        Meta(description="By radius; null where they were written to a file."),
    ]
