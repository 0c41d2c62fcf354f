"""Sets in the plane, and what is said of the paper's way in several documents."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Amount, Count, Digest, FileIsExact, Number, Pair, Point
from msgspec import Meta

EdgeKind = Literal["S", "T"]
Change = Literal["birth", "death"]

Misplaced = Annotated[
    Count,
    Meta(
        description="Events of the right edges at another scale: less than half of its digits are "
        "right."
    ),
]

PlaneScale = Annotated[
    Number | Point, Meta(description="The scale of P; a list has the factors of the two axes.")
]

AreaApproximate = Annotated[
    float | None,
    Meta(
        description="The double next to the area; null where that is beyond the range of doubles."
    ),
]

Ring = list[Point]

Readings = Annotated[
    dict[str, str] | None,
    Meta(description="Of the route `paper-update`: how each formula was read (docs/paper.md)."),
]

SweepRoute = Literal["index", "dynamic", "winding", "paper-update"]
ViewRoute = Literal["index", "dynamic", "paper-update"]


class ProvedAnswer(TypedDict):
    """Grounds of an answer of the proved program."""

    proved: Annotated[str, Meta(description="The theorem, in words.")]
    trusted: Annotated[list[str], Meta(description="All that no theorem speaks about.")]


class Segments(TypedDict):
    """Edges of the convolution: the full one on the route `winding`, else the reduced one."""

    S: Count
    T: Count


class Parent(TypedDict):
    """An edge of the convolution by its parents; rings are numbered outer, holes, outer, holes,
    ..."""

    kind: Annotated[
        EdgeKind,
        Meta(description="S: an edge of P at a vertex of Q. T: an edge of Q at a vertex of P."),
    ]
    edge: Annotated[Pair, Meta(description="Ring and index of the vertex where the edge starts.")]
    vertex: Annotated[Pair, Meta(description="Ring and index.")]


class PairEvent(TypedDict):
    scale: Number
    change: Change
    a: Annotated[
        str,
        Meta(
            description="An edge of the reduced convolution by its parents: S or T, ring and index "
            "of the edge, ring and index of the vertex."
        ),
    ]
    b: str


class Polygon(TypedDict):
    holes: list[Ring]
    outer: Ring


class PolygonSet(TypedDict):
    """A polygon set: outer rings counter-clockwise, holes clockwise."""

    polygons: list[Polygon]


class SetResult(TypedDict):
    """A set that was computed, in canonical form, with what is told of it."""

    output_exact: FileIsExact
    compute_seconds: Annotated[
        Amount, Meta(description="Of the operation, without reading, area and digest.")
    ]
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical JSON.")]
    area: Annotated[Number, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    components: Annotated[Count, Meta(description="Connected components of the interior.")]
    holes: Annotated[Count, Meta(description="Bounded connected components of the complement.")]
    vertices: Annotated[Count, Meta(description="Of the canonical form, over all rings.")]
    result: Annotated[PolygonSet, Meta(description="The set in canonical form.")]


class TightPassage(TypedDict):
    points: Annotated[
        list[Point],
        Meta(
            description="One point, or the vertices of a polyline; a closed one ends with its "
            "first.",
            min_length=1,
        ),
    ]
    contacts: Annotated[
        list[Annotated[list[Parent], Meta(min_length=2)]],
        Meta(
            description="For each segment of the polyline the features that touch along it or "
            "along a part of it; for a point, in one list, those that touch there.",
            min_length=1,
        ),
    ]


class PointWitness(TypedDict):
    point: Point
    in_sum: bool


class PaperComparison(TypedDict):
    same_structure: Annotated[
        bool,
        Meta(
            description="As many rings, and to each outer ring and each hole one with as many "
            "vertices, near its own."
        ),
    ]
    ulps: Annotated[
        float | None,
        Meta(
            description="The largest distance of a coordinate from the right one, in units in the "
            "last place of the largest; null where the structure is another one."
        ),
    ]
    witness: Annotated[
        PointWitness | None,
        Meta(
            description="Where the structure is another one: a point that only one of the two sets "
            "has, and whether it is in the sum."
        ),
    ]


BesideExact = Annotated[
    PaperComparison | None,
    Meta(description="On the route `paper-update`: the sum beside the exact one."),
]


class PaperEvents(TypedDict):
    right: Count
    missed: Count
    invented: Count
    first_missed: PairEvent | None
    first_invented: PairEvent | None
    misplaced: Misplaced


class PaperRun(TypedDict):
    """What is told of the paper's own program."""

    arithmetic: Annotated[
        str, Meta(description="Of the route `paper-update`; the others are exact.")
    ]
    readings: Readings
    events: Annotated[
        PaperEvents | None,
        Meta(
            description="Of the route `paper-update`: its array of events, at all scales, beside "
            "the exact one, by edges."
        ),
    ]
