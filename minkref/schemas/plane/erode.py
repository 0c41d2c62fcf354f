"""Documents: `erode`, `opening`, `closing`, `nofit`, `innerfit` in the plane."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import Parent, PlaneScale, SetResult
from minkref.schemas.values import Head, Operands, Point, Written
from msgspec import Meta

ErodeRoute = Literal["paper", "winding", "definition", "dynamic", "index"]


class ExactFit(TypedDict):
    points: Annotated[
        list[Point],
        Meta(
            description="One point, or the vertices of a polyline; a closed one ends with its "
            "first.",
            min_length=1,
        ),
    ]
    contacts: Annotated[
        list[list[Parent]],
        Meta(
            description="For each segment of the polyline the features that touch along it or "
            "along a part of it, for a point, in one list, those that touch there: S, an edge of "
            "the first operand and a vertex of the second one, which is turned by half a turn; T, "
            "an edge of the second one and a vertex of the first. Empty where one of both has no "
            "area, and for openings."
        ),
    ]


class ScaledFirst(TypedDict):
    scale: PlaneScale


Remnants = Annotated[
    list[ExactFit],
    Meta(
        description="The points and polylines beside the region, in canonical order: there the "
        "second operand fits exactly."
    ),
]


class Remaining(Head, Operands, Written, ScaledFirst, SetResult):
    """A set with remnants."""

    remnants: Remnants


class ErodeDocument(Remaining):
    """The document of `minkref erode --json`."""

    command: Literal["erode"]
    route: ErodeRoute


class OpeningDocument(Remaining):
    """The document of `minkref opening --json`."""

    command: Literal["opening"]


class ClosingDocument(Remaining):
    """The document of `minkref closing --json`."""

    command: Literal["closing"]


class FixedAndMoving(TypedDict):
    A: Annotated[str, Meta(description="The fixed shape as named, which is scaled.")]
    B: Annotated[str, Meta(description="The moving shape as named.")]


class ContainerAndPart(TypedDict):
    container: Annotated[str, Meta(description="As named; it is scaled.")]
    part: str


class NoFitDocument(Head, FixedAndMoving, Written, ScaledFirst, SetResult):
    """The document of `minkref nofit --json`. The rings of `result` are the touching placements."""

    command: Literal["nofit"]
    exact_fits: Annotated[
        list[ExactFit],
        Meta(
            description="The points and polylines inside of the region at which the shapes only "
            "touch, in canonical order."
        ),
    ]


class InnerFitDocument(Head, ContainerAndPart, Written, ScaledFirst, SetResult):
    """The document of `minkref innerfit --json`. The rings of `result`, and the exact fits, are the
    touching placements."""

    command: Literal["innerfit"]
    exact_fits: Remnants
