"""Scales, contacts and features of parts that move."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.grammar import EXACTLY_ONE, ruled
from minkref.schemas.values import Count, Head, Number, Pair, Point, Rule, SpacePoint
from msgspec import Meta

ContactRule = Annotated[Rule, Meta(description="Whether the part may touch what it must not meet.")]
FitEvent = Literal["contact", "birth", "death", "merge", "split", "touch"]


class EndScale(TypedDict):
    scale: Number | None
    is_valid: Annotated[bool, Meta(description="Whether the scale itself is one of them.")]


class AnyFit(Head):
    """All that `fit` and `trap` tell of a part."""

    part: Annotated[str, Meta(description="The part as named; it is scaled.")]
    contact: ContactRule
    warnings: list[str]
    motion: Annotated[
        str, Meta(description="By translations only; a rotation may do what they cannot.")
    ]
    largest: Annotated[
        EndScale | None, Meta(description="The end of the last range; null: no scale.")
    ]
    smallest: Annotated[
        EndScale | None, Meta(description="The begin of the first range; null: no scale.")
    ]


@ruled(**EXACTLY_ONE)
class Feature(TypedDict, total=False):
    """A vertex, or the edge that starts at it: ring and index."""

    vertex: Pair
    edge: Pair


class Contact(TypedDict):
    part: Feature
    obstacle: Feature


class FitBound(TypedDict):
    scale: Number
    ends: Annotated[
        bool, Meta(description="Whether the range ends there; otherwise it begins there.")
    ]
    event: Annotated[
        FitEvent,
        Meta(
            description="contact: the part touches at a place that was asked for. Others: what "
            "happens to a hole of the sum of obstacles and turned part."
        ),
    ]
    at: Annotated[
        Point,
        Meta(
            description="Where: of a contact the point that is touched, otherwise a place of the "
            "part."
        ),
    ]
    contact: Contact | None


class Proof(TypedDict):
    scale: Number
    holds: bool


class PlaneFit(AnyFit):
    """All that `fit` and `trap` tell in the plane."""

    output: Annotated[str | None, Meta(description="The file that was written.")]
    bounds: Annotated[list[FitBound], Meta(description="The ends of ranges.")]
    proofs: Annotated[
        list[Proof],
        Meta(
            description="Scales at, just below and just above each bound, and whether the answer "
            "holds there, as static sums found again."
        ),
    ]
    critical_scales: Annotated[
        Count, Meta(description="At and between which the question was decided.")
    ]


ScaleRangeEnds = TypedDict(
    "ScaleRangeEnds",
    {
        "from": Annotated[
            Number, Meta(description="The least scale; 0 where the range goes down to 0.")
        ],
        "to": Annotated[Number | None, Meta(description="The greatest scale; null: no end.")],
    },
)


class ScaleRange(ScaleRangeEnds):
    from_in: Annotated[bool, Meta(description="Whether `from` belongs to the range.")]
    to_in: Annotated[bool, Meta(description="Whether `to` does.")]


@ruled(**EXACTLY_ONE)
class SpaceFeature(TypedDict, total=False):
    """What touches in space."""

    vertex: Annotated[list[Count], Meta(description="Its number.", min_length=1, max_length=1)]
    edge: Annotated[Pair, Meta(description="Its two vertices, the smaller first.")]
    face: Annotated[
        list[Count],
        Meta(
            description="The number of a face, inside of which it is.", min_length=1, max_length=1
        ),
    ]


class SpaceContact(TypedDict):
    part: SpaceFeature
    obstacle: SpaceFeature


SpaceFitEvent = Literal["contact", "death", "split"]


class SpaceFreeBound(TypedDict):
    scale: Number
    ends: Annotated[
        bool, Meta(description="Whether the range ends there; otherwise it begins there.")
    ]
    event: Annotated[
        SpaceFitEvent,
        Meta(
            description="contact: the part touches, and fits no more; death: the last free places "
            "vanish; split: a way closes."
        ),
    ]
    at: Annotated[
        SpacePoint,
        Meta(
            description="Where: of a contact the point that is touched, otherwise a place of the "
            "part."
        ),
    ]
    contact: SpaceContact | None


class SpaceFree(AnyFit):
    """The fields of `fit` and `trap` in space."""

    bounds: Annotated[list[SpaceFreeBound], Meta(description="The ends of ranges.")]
    proofs: Annotated[
        list[Proof],
        Meta(
            description="Scales at, just below and just above each bound, and whether the answer "
            "holds there, found again by other means."
        ),
    ]
    critical_scales: Annotated[
        Count, Meta(description="Scales of events among which a bound was found; 0: none needed.")
    ]


class OnPath(TypedDict):
    """A part on a path."""

    path: Annotated[str, Meta(description="The path as named.")]
    contact: ContactRule
    valid: Annotated[list[ScaleRange], Meta(description="The valid scales, ascending.")]
