"""Radii, features and curves of a shape with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.grammar import EXACTLY_ONE, ruled
from minkref.schemas.values import Count, Fraction, Pair
from msgspec import Meta

Radius = Annotated[str, Meta(pattern="^[0-9]+(/[0-9]+)?$")]
DiscEventKind = Literal["corner", "joint", "saddle", "ridge", "maximum"]

Polynomial = Annotated[
    list[Fraction],
    Meta(
        description="That the squared radius is a root of: rational coefficients, the lowest "
        "first, without multiple roots.",
        min_length=2,
    ),
]

RoundedPoint = Annotated[list[float | None], Meta(min_length=2, max_length=2)]
RadiusOrRoot = Annotated[str, Meta(pattern="^(sqrt:)?[0-9]+(/[0-9]+)?$")]
ExactPlace = Annotated[list[str], Meta(min_length=2, max_length=2)]

ExactPoint = Annotated[
    ExactPlace,
    Meta(description="x and y, as expressions of rational numbers, +, -, * and sqrt(...)."),
]

Curve = Annotated[list[str], Meta(min_length=3, max_length=4)]

CurvedRing = Annotated[
    list[Curve],
    Meta(
        description='A ring: each curve ["arc", x, y] about a centre, or ["line", dx, dy, c] with '
        "a primitive direction."
    ),
]

PartsOfTheDiagram = Annotated[
    Count,
    Meta(
        description="Parts of the outer Voronoi diagram on which the radius only grows or shrinks."
    ),
]


class ShapeAndDisc(TypedDict):
    """The operands."""

    P: Annotated[str, Meta(description="The operand as named.")]
    Q: Literal["disc"]


RadiusWindow = TypedDict(
    "RadiusWindow",
    {
        "from": Annotated[Radius | None, Meta(description="The smallest radius, included.")],
        "to": Annotated[Radius | None, Meta(description="The largest radius, included.")],
    },
)


class DiscEventCounts(TypedDict):
    corner: Count
    joint: Count
    saddle: Count
    ridge: Count
    maximum: Count


class Enclosure(TypedDict):
    low: float | None
    high: float | None


RadiusBetween = Annotated[
    Enclosure, Meta(description="Two doubles with the radius between; null beyond these.")
]


@ruled(**EXACTLY_ONE)
class ShapeFeature(TypedDict, total=False):
    vertex: Annotated[list[Fraction], Meta(min_length=2, max_length=2)]
    edge: Pair


class DiscEvent(TypedDict):
    kind: DiscEventKind
    radius: RadiusBetween
    squared_radius: Annotated[Radius | None, Meta(description="Where it is known to be rational.")]
    polynomial: Polynomial
    place: Annotated[RoundedPoint, Meta(description="Rounded.")]
    features: Annotated[
        list[ShapeFeature],
        Meta(
            description="All that are as near: vertices by coordinates, edges by ring and first "
            "vertex, each of which has the nearest point.",
            min_length=2,
        ),
    ]


class DiagramStatistics(TypedDict):
    """Of the route index: radii at which something changes, parts of the outer Voronoi diagram,
    and how often roots had to decide."""

    radii_of_events: Count
    parts_of_the_diagram: Count
    exact_signs: Count
