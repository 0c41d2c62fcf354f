"""Documents of `path`, `fit` and `trap` with a disc, and of parts that keep a distance."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import (
    DiscEventKind,
    Enclosure,
    Polynomial,
    RadiusBetween,
    RadiusOrRoot,
    RoundedPoint,
    ShapeFeature,
)
from minkref.schemas.motion.path import PathEvent, Place
from minkref.schemas.motion.values import ContactRule, Feature
from minkref.schemas.values import (
    Count,
    Head,
    LastingHead,
    Number,
    Point,
    PositiveCount,
    Window,
    Written,
)
from msgspec import Meta

Cause = Literal["contact", "neck", "room", "apart", "meets", "free"]
Clearance = Annotated[
    Number | None, Meta(description="The distance to keep beyond the radius; null without one.")
]


class DiscRadius(TypedDict):
    """The root of a squared distance, less the clearance."""

    radius: RadiusBetween
    squared_distance: Annotated[
        Number | None, Meta(description="Where it is known to be rational.")
    ]
    polynomial: Polynomial


DiscRangeEnds = TypedDict(
    "DiscRangeEnds",
    {
        "from": Annotated[DiscRadius | None, Meta(description="null: all radii above 0.")],
        "to": Annotated[DiscRadius | None, Meta(description="null: no end.")],
    },
)


class DiscRange(DiscRangeEnds):
    from_in: Annotated[bool, Meta(description="Whether `from` is one of the radii.")]
    to_in: Annotated[bool, Meta(description="Whether `to` is.")]


class DiscTouches(TypedDict):
    """The centre's place, the touched feature, the touching point."""

    at: Place
    obstacle: Feature
    touching: Point


class DiscPlace(TypedDict):
    """A neck, or a place of the largest disc: as an event of `events P disc`."""

    kind: DiscEventKind
    place: Annotated[RoundedPoint, Meta(description="Rounded.")]
    features: Annotated[list[ShapeFeature], Meta(min_length=2)]


class AskedRadius(TypedDict):
    """The answer for one radius, with `disc:R`."""

    radius: RadiusOrRoot
    holds: bool


class AnyDisc(TypedDict):
    """Fields that the three commands share."""

    part: Annotated[str, Meta(description="The disc as named.")]
    contact: ContactRule
    clearance: Clearance
    radii: Annotated[DiscRange | None, Meta(description="The radii, one range; null: none.")]
    cause: Annotated[
        Cause,
        Meta(
            description="The end of the radii: a contact at a place or on the path, a neck on the "
            "way, the container's room; or why there is none: places apart, a place that is not "
            "free, nothing in the way."
        ),
    ]
    touches: Annotated[
        DiscTouches | None, Meta(description="The contact at the greatest radius, the first one.")
    ]
    events: Annotated[
        list[DiscPlace], Meta(description="Necks on a best way, or places of the largest disc.")
    ]
    asked: AskedRadius | None


class DiscPathDocument(AnyDisc, LastingHead, Written):
    """The document of `minkref path disc --json`."""

    command: Literal["path"]
    obstacles: str
    path: Annotated[str, Meta(description="The path as named.")]
    vertices: PositiveCount


class DiscFitDocument(AnyDisc, LastingHead, Written):
    """The document of `minkref fit disc --json`."""

    command: Literal["fit"]
    container: str
    question: Literal["at", "anywhere", "between"]
    places: Annotated[list[Point], Meta(description="As asked for.", max_length=2)]


class DiscTrapDocument(AnyDisc, LastingHead, Written):
    """The document of `minkref trap disc --json`."""

    command: Literal["trap"]
    obstacles: str
    at: Annotated[Point, Meta(description="The place of the disc's centre.")]


class RootNumber(Enclosure):
    """A number as an expression, and two doubles around it."""

    exact: Annotated[str, Meta(description="Rational numbers, +, -, * and sqrt(...).")]


ClearRangeEnds = TypedDict(
    "ClearRangeEnds",
    {"from": RootNumber, "to": Annotated[RootNumber | None, Meta(description="null: no end.")]},
)


class ClearRange(ClearRangeEnds):
    from_in: bool
    to_in: bool


class ClearBound(TypedDict):
    """An end, with the features at the distance there, and their place on the path."""

    scale: RootNumber
    event: PathEvent
    segment: Count
    t: RootNumber
    part: Feature
    obstacle: Feature


class AnyClear(TypedDict):
    """Fields for a part that keeps a distance."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    contact: ContactRule
    clearance: Number
    clear: Annotated[list[ClearRange], Meta(description="The scales, ascending.")]
    ends: Annotated[list[ClearBound], Meta(description="Ends that are none of the window.")]


class ClearPathDocument(AnyClear, LastingHead, Window, Written):
    """The document of `minkref path --clearance C --json`."""

    command: Literal["path"]
    obstacles: str
    path: Annotated[str, Meta(description="The path as named.")]
    vertices: PositiveCount
    route: Literal["pieces"]
    motion: str
    star_shaped: bool


class ClearFitDocument(AnyClear, Head):
    """The document of `minkref fit --at X,Y --clearance C --json`."""

    command: Literal["fit"]
    container: str
    question: Literal["at"]
    places: Annotated[list[Point], Meta(min_length=1, max_length=1)]
    warnings: list[str]


class ClearBracket(TypedDict):
    """Two scales around the end of the scales from 0 on, both decided exactly."""

    holds_to: Annotated[Number, Meta(description="Holds up to this scale; 0: at none asked.")]
    fails_from: Annotated[
        Number | None, Meta(description="Fails from this scale on; null: at none asked.")
    ]
    is_exact: Annotated[bool, Meta(description="Whether both are equal, the end itself.")]
    end_in: Annotated[bool, Meta(description="Whether the end is one of the scales.")]
    decisions: Annotated[Count, Meta(description="The number of scales decided.")]


class AnyBracket(Head):
    """Fields of `fit` and `trap` with a clearance, for all scales."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    contact: ContactRule
    clearance: Number
    tolerance: Annotated[
        Number, Meta(description="The most by which the scales may differ, as a share of them.")
    ]
    motion: str
    cause: Annotated[Cause | None, Meta(description="What limits the distance at `holds_to`.")]
    near: Annotated[RoundedPoint | None, Meta(description="Where it does.")]
    warnings: list[str]


class ClearPlace(TypedDict):
    """A part that keeps the distance: exact."""

    scale: Number
    place: Point


class ClearFitBracketDocument(AnyBracket, Written):
    """The document of `minkref fit --anywhere --clearance C --json`, also with `--between`."""

    command: Literal["fit"]
    container: str
    question: Literal["anywhere", "between"]
    places: Annotated[list[Point], Meta(description="As asked for.", max_length=2)]
    bracket: ClearBracket
    witness: Annotated[
        ClearPlace | None,
        Meta(description="A scale and place at which the part keeps the distance."),
    ]


class ClearTrapDocument(AnyBracket, Window, Written):
    """The document of `minkref trap --clearance C --json`."""

    command: Literal["trap"]
    obstacles: str
    at: Annotated[Point, Meta(description="The place of the part's origin.")]
    bracket: Annotated[
        ClearBracket | None,
        Meta(description="The scales at which the part gets away; null: free at none, or at all."),
    ]
    free: Annotated[list[ClearRange], Meta(description="The scales at which it is free there.")]
    is_trapped: Annotated[
        bool, Meta(description="Whether it is trapped, at the free scales from `fails_from` on.")
    ]


class AnyClearScale(Head):
    """Fields of `fit` and `trap` with a clearance, for one scale."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    contact: ContactRule
    clearance: Number
    scale: Number
    motion: str
    holds: Annotated[bool, Meta(description="The answer for the clearance.")]
    distances: Annotated[
        DiscRange | None, Meta(description="The clearances for which it holds; null: none.")
    ]
    cause: Cause
    near: Annotated[list[RoundedPoint], Meta(description="Necks, or places of the most room.")]
    warnings: list[str]


class ClearFitScaleDocument(AnyClearScale):
    """The document of `minkref fit --anywhere --clearance C --scale S --json`, also with
    `--between`."""

    command: Literal["fit"]
    container: str
    question: Literal["anywhere", "between"]
    places: Annotated[list[Point], Meta(description="As asked for.", max_length=2)]


class ClearTrapScaleDocument(AnyClearScale):
    """The document of `minkref trap --clearance C --scale S --json`."""

    command: Literal["trap"]
    obstacles: str
    at: Annotated[Point, Meta(description="The place of the part's origin.")]
