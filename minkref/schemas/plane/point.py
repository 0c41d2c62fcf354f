"""The document of `point`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import PlaneScale, ProvedAnswer
from minkref.schemas.values import Head, Operands, Point
from msgspec import Meta


class DecidedPoint(TypedDict):
    """A point, and whether it is in the sum."""

    point: Point
    in_sum: bool
    contact: Annotated[
        Literal["empty", "touching", "overlapping"] | None,
        Meta(
            description="How sP and the point less Q meet; overlapping: the point is in the sum of "
            "the interiors. Null with --proved."
        ),
    ]
    p: Annotated[
        Point | None,
        Meta(description="Of P, with S p + q the point; null where it is not in the sum."),
    ]
    q: Annotated[Point | None, Meta(description="Of Q.")]


class PointDocument(Head, Operands):
    """The document of `minkref point --json`."""

    command: Literal["point"]
    scale: PlaneScale
    warnings: list[str]
    points: Annotated[list[DecidedPoint], Meta(description="In the order that they were given in.")]
    proof: Annotated[
        ProvedAnswer | None, Meta(description="With --proved; null where the reference decided.")
    ]
