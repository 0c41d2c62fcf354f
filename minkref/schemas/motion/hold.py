"""Documents of `hold`, in the plane and in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.certificates import Certificate
from minkref.schemas.motion.path import PathBound, PathRoute, SpacePathBound, SpacePathRoute
from minkref.schemas.motion.values import ContactRule, EndScale, ScaleRange
from minkref.schemas.values import (
    InSpace,
    LastingHead,
    Point,
    PositiveCount,
    SpacePoint,
    Window,
    Written,
)
from msgspec import Meta

Cause = Annotated[
    Literal["place", "way"],
    Meta(
        description="place: the part fits at its place on one side of the scale only; way: the "
        "contact is one of the way."
    ),
]
BEGIN = Meta(description="The contact at the range's begin; null: it begins with the window.")
END = Meta(description="The contact at the range's end; null: it ends with the window, or not.")
STOP = Meta(
    description="At a scale of the range, the first place of the way where the part collides (with "
    "contact allowed: the limit of such places), and the contact there."
)


class AnyHold(LastingHead, Window, Written):
    """The fields of `hold` in the plane and in space."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    obstacles: str
    path: Annotated[str, Meta(description="The way out as named.")]
    vertices: Annotated[PositiveCount, Meta(description="Of the way.")]
    contact: ContactRule
    motion: Annotated[str, Meta(description="The part is never turned.")]
    largest: Annotated[
        EndScale | None, Meta(description="The end of the last held range; null: none is held.")
    ]
    smallest: Annotated[
        EndScale | None, Meta(description="The begin of the first held range; null: none is held.")
    ]
    star_shaped: Annotated[
        bool, Meta(description="Whether the part is star-shaped about its origin.")
    ]


class HeldEnd(PathBound):
    cause: Cause


class HeldRange(ScaleRange):
    """Scales at which the part is held."""

    begin: Annotated[HeldEnd | None, BEGIN]
    end: Annotated[HeldEnd | None, END]
    stop: Annotated[PathBound, STOP]


class Scales(TypedDict):
    scales: Annotated[list[ScaleRange], Meta(description="Ascending.")]
    bounds: Annotated[list[PathBound], Meta(description="As `path` has them.")]


class HoldDocument(AnyHold):
    """The document of `minkref hold --json`."""

    command: Literal["hold"]
    route: PathRoute
    at: Annotated[Point, Meta(description="The part's place: the way's first vertex.")]
    held: Annotated[list[HeldRange], Meta(description="`fits` less `way`, ascending.")]
    fits: Annotated[Scales, Meta(description="The scales at which the part fits at its place.")]
    way: Annotated[Scales, Meta(description="The scales at which the way is valid.")]
    certificates: Annotated[
        Annotated[list[Certificate], Meta(min_length=2, max_length=2)] | None,
        Meta(
            description="With --certify: the proofs of `fits` and of `way` that were written, as "
            "of `path`; null without."
        ),
    ]


class SpaceHeldEnd(SpacePathBound):
    cause: Cause


class SpaceHeldRange(ScaleRange):
    """Scales at which the part is held."""

    begin: Annotated[SpaceHeldEnd | None, BEGIN]
    end: Annotated[SpaceHeldEnd | None, END]
    stop: Annotated[SpacePathBound, STOP]


class SpaceScales(TypedDict):
    scales: Annotated[list[ScaleRange], Meta(description="Ascending.")]
    bounds: Annotated[list[SpacePathBound], Meta(description="As `path` has them.")]


class SpaceHoldDocument(AnyHold, InSpace):
    """The document of `minkref hold --json` in space."""

    command: Literal["hold"]
    route: SpacePathRoute
    at: Annotated[SpacePoint, Meta(description="The part's place: the way's first vertex.")]
    held: Annotated[list[SpaceHeldRange], Meta(description="`fits` less `way`, ascending.")]
    fits: Annotated[
        SpaceScales, Meta(description="The scales at which the part fits at its place.")
    ]
    way: Annotated[SpaceScales, Meta(description="The scales at which the way is valid.")]
