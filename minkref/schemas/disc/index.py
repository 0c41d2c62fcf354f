"""The document of `index` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from minkref.schemas.disc.values import DiscEvent, Enclosure, ExactPlace, ShapeAndDisc, ShapeFeature
from minkref.schemas.grammar import EXACTLY_ONE, ruled
from minkref.schemas.values import Amount, Count, LastingHead, MaybeEroded, Pair, PositiveCount
from msgspec import Meta


@ruled(**EXACTLY_ONE)
class PartEnd(TypedDict, total=False):
    """The number of an event; the coordinates of a reflex vertex; or two vertices of the convex
    hull, between which the part goes on to infinity."""

    event: Count
    vertex: ExactPlace
    infinity: Annotated[list[ExactPlace], Meta(min_length=2, max_length=2)]


DiagramPartEnds = TypedDict("DiagramPartEnds", {"from": PartEnd, "to": PartEnd})


class DiagramPart(DiagramPartEnds):
    features: Annotated[
        list[ShapeFeature],
        Meta(description="The two that are nearest.", min_length=2, max_length=2),
    ]


class DiscHole(TypedDict):
    birth: Enclosure | None
    end: Enclosure
    place: Annotated[
        list[float], Meta(description="Where it ends, rounded.", min_length=2, max_length=2)
    ]
    of: Annotated[Count, Meta(description="The hole that it was a part of; 0: the outside, or P.")]


class Join(TypedDict):
    radius: Enclosure | None
    polygons: Pair


class DiscIndexDocument(LastingHead, ShapeAndDisc, MaybeEroded):
    """The document of `minkref index --json` with a disc, and its file."""

    command: Literal["index"]
    warnings: list[str]
    output: Annotated[str, Meta(description="The file that was written.")]
    threads: PositiveCount
    build_seconds: Amount | None
    exact_signs: Annotated[Count, Meta(description="Decisions that roots had to make.")]
    events: Annotated[
        Count | list[DiscEvent], Meta(description="How many; in the file all, by radius.")
    ]
    radii: Annotated[Count, Meta(description="Different radii of events.")]
    places: NotRequired[
        Annotated[
            list[Annotated[list[Count], Meta(min_length=4, max_length=4)]],
            Meta(
                description="In the file: of each event with three features or more, three of "
                "them, by number, and which of the places that they tell it is. What --index FILE "
                "proves again."
            ),
        ]
    ]
    parts: Annotated[
        Count | list[DiagramPart],
        Meta(
            description="Of the outer Voronoi diagram, on each of which the radius only grows or "
            "shrinks, or stays: how many; in the file all."
        ),
    ]
    holes: Annotated[
        list[DiscHole], Meta(description="Numbered from 1 on, those of P first (birth null).")
    ]
    joins: Annotated[
        list[Join],
        Meta(
            description="Polygons of P, by number, whose components are one from a radius on "
            "(null: they touch)."
        ),
    ]
