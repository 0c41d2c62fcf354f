"""Documents of `path`, in the plane and in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.certificates import CertificateMade
from minkref.schemas.motion.values import EndScale, Feature, OnPath, SpaceFeature
from minkref.schemas.values import (
    Count,
    InSpace,
    LastingHead,
    Number,
    Point,
    PositiveCount,
    SpacePoint,
    Window,
    Written,
)
from msgspec import Meta

PathRoute = Literal["pieces", "contacts", "index"]

PathEvent = Annotated[
    Literal["blocks", "frees"],
    Meta(description="blocks: scales just above are not valid; frees: those just below are not."),
]

SpacePathRoute = Literal["pieces", "contacts"]


class AnyPath(LastingHead, Window, Written, OnPath):
    """All that `path` tells in the plane and in space."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    obstacles: str
    vertices: Annotated[PositiveCount, Meta(description="Of the path.")]
    is_closed: Annotated[bool, Meta(description="Whether it ends where it begins.")]
    motion: Annotated[str, Meta(description="The part is never turned.")]
    largest: Annotated[
        EndScale | None, Meta(description="The end of the last range; null: no scale is valid.")
    ]
    smallest: Annotated[
        EndScale | None, Meta(description="The begin of the first range; null: no scale is valid.")
    ]
    star_shaped: Annotated[
        bool,
        Meta(
            description="Whether the part is star-shaped about its origin; the valid scales are "
            "then one range that starts at 0."
        ),
    ]
    statistics: Annotated[
        dict[str, Count],
        Meta(
            description="Convex pieces of the part and of the obstacles, triples of two of them "
            "and a segment, those of them that were not left out in doubles, critical scales that "
            "were looked at."
        ),
    ]


class Place(TypedDict):
    """Where on the path: the segment, how far along it, the point."""

    segment: Count
    t: Number
    point: Point


class PathBound(TypedDict):
    scale: Number
    event: PathEvent
    at: Place
    part: Feature
    obstacle: Feature
    touching: Annotated[Point, Meta(description="Where the two features touch.")]


class PathDocument(AnyPath):
    """The document of `minkref path --json`."""

    command: Literal["path"]
    route: PathRoute
    bounds: Annotated[
        list[PathBound],
        Meta(
            description="The ends of ranges that are no end of the window, each with a contact "
            "that causes it: the first along the path."
        ),
    ]
    certificate: CertificateMade


class SpacePlace(TypedDict):
    """Where on the path: the segment, how far along it, the point."""

    segment: Count
    t: Number
    point: SpacePoint


class SpacePathBound(TypedDict):
    scale: Number
    event: PathEvent
    at: SpacePlace
    part: SpaceFeature
    obstacle: SpaceFeature
    touching: Annotated[SpacePoint, Meta(description="Where the two features touch.")]


class SpacePathDocument(AnyPath, InSpace):
    """The document of `minkref path --json` in space."""

    command: Literal["path"]
    route: SpacePathRoute
    bounds: Annotated[
        list[SpacePathBound],
        Meta(
            description="The ends of ranges that are no end of the window, each with a contact "
            "that causes it: the first along the path."
        ),
    ]
