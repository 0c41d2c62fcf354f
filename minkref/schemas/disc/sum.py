"""The document of `sum` with a disc."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.certificates import CertificateMade
from minkref.schemas.disc.values import (
    Curve,
    CurvedRing,
    DiagramStatistics,
    Enclosure,
    ExactPoint,
    Radius,
    RadiusOrRoot,
    RoundedPoint,
)
from minkref.schemas.grammar import Either
from minkref.schemas.plane.values import BesideExact, Readings
from minkref.schemas.values import Amount, Count, Digest, Fraction, Head, Operands, Written
from msgspec import Meta

DiscSumRoute = Literal["definition", "paper", "index", "paper-update"]


class DiscPassage(TypedDict):
    points: Annotated[
        list[ExactPoint],
        Meta(description="A point, or the ends of a segment.", min_length=1, max_length=2),
    ]
    near: Annotated[
        list[RoundedPoint], Meta(description="The points, rounded; null beyond doubles.")
    ]
    contacts: Annotated[
        list[Curve], Meta(description="The curves through the point, those along the segment.")
    ]


class Term(TypedDict):
    factor: Fraction
    root: Annotated[str, Meta(description="A product of square roots, or 1.")]


Angle = TypedDict("Angle", {"from": ExactPoint, "to": ExactPoint})


class Measures(TypedDict):
    length: list[Term]
    area: list[Term]
    angles: Annotated[
        list[Angle],
        Meta(
            description="Of the arcs: from one direction counter-clockwise to the other; of equal "
            "ones a whole turn."
        ),
    ]


class CurvedPolygon(TypedDict):
    holes: list[CurvedRing]
    outer: CurvedRing


class CurvedSet(TypedDict):
    """The canonical form (docs/disc.md)."""

    components: list[CurvedPolygon]
    squared_radius: Fraction


class PairStatistics(TypedDict):
    """Curves and edges that were compared, how often roots had to decide, and orders that roots
    had to tell."""

    pairs: Count
    exact_pairs: Count
    exact_orders: Count


class DiscProgramStatistics(TypedDict):
    """Counts on the route `paper-update`: segments and arcs of the convolution, pairs looked at,
    meetings of two at some scale, pairs left out for NaN; nodes and faces of the arrangement, faces
    with a collision test."""

    segments: Count
    arcs: Count
    pairs: Count
    meetings: Count
    undecided: Count
    nodes: Count
    faces: Count
    asked: Count


class ExactDiscSum(TypedDict):
    digest: Digest
    components: Count
    holes: Count
    curves: Count
    equal: Annotated[bool, Meta(description="The digests are equal, hence the sets.")]


class DiscSumDocument(Head, Operands, Written):
    """The document of `minkref sum --json` with a disc."""

    command: Literal["sum"]
    scale: Fraction
    output_exact: Annotated[
        bool | None,
        Meta(description="The file holds the very set; false where it is a picture or a polygon."),
    ]
    tolerance: Annotated[
        Radius | None, Meta(description="How far the polygon that was written may be off.")
    ]
    radius: Annotated[
        RadiusOrRoot, Meta(description="Of the disc, scaled: a number, or the root of one.")
    ]
    squared_radius: Fraction
    route: DiscSumRoute
    compute_seconds: Amount
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical text.")]
    components: Count
    holes: Count
    curves: Annotated[
        Count,
        Meta(
            description="Of all rings; parts of one circle or line that follow each other are one."
        ),
    ]
    area: Annotated[
        Enclosure | None,
        Meta(
            description="Between two doubles; null beyond these. This, the length and the tight "
            "passages are null on the route `paper-update`."
        ),
    ]
    length: Annotated[Enclosure | None, Meta(description="Of the boundary.")]
    tight_passages: Annotated[
        list[DiscPassage] | None,
        Meta(description="What the closed sum covers and the sum of the interiors does not."),
    ]
    measures: Annotated[
        Measures | None,
        Meta(
            description="With --measures. The length is the sum of `length` and of the radius "
            "times all angles, in radians; the area that of `area` and of half of the squared "
            "radius times all angles."
        ),
    ]
    result: CurvedSet
    statistics: Either[PairStatistics, DiagramStatistics, DiscProgramStatistics]
    arithmetic: Annotated[
        str, Meta(description="Of the route `paper-update`; the others are exact.")
    ]
    readings: Readings
    exact: Annotated[
        ExactDiscSum | None, Meta(description="On the route `paper-update`: what is true.")
    ]
    comparison: BesideExact
    certificate: CertificateMade
