"""Documents of `fit`, in the plane and in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.motion.values import PlaneFit, ScaleRange, SpaceFree
from minkref.schemas.values import Count, InSpace, Number, Point, SpacePoint
from msgspec import Meta


class FitDocument(PlaneFit):
    """The document of `minkref fit --json`."""

    command: Literal["fit"]
    container: str
    question: Literal["at", "anywhere", "between"]
    places: Annotated[list[Point], Meta(description="Those that were asked for.", max_length=2)]
    scales: Annotated[
        list[ScaleRange], Meta(description="The scales at which the part fits, ascending.")
    ]


class FitSupport(TypedDict):
    """A contact that keeps the part from growing, with its weight."""

    vertex: Annotated[Count, Meta(description="Of the part.")]
    face: Annotated[Count, Meta(description="Of the container, whose plane the vertex touches.")]
    weight: Annotated[
        Number,
        Meta(
            description="Above 0. The weighted normals of the faces, each twice the face's area "
            "vector, sum up to zero: no greater scale is possible."
        ),
    ]


class SpaceFitDocument(SpaceFree, InSpace):
    """The document of `minkref fit --json` in space."""

    command: Literal["fit"]
    container: str
    question: Literal["at", "anywhere"]
    places: Annotated[
        list[SpacePoint], Meta(description="The place that was asked for, if any.", max_length=1)
    ]
    scales: Annotated[
        list[ScaleRange], Meta(description="The scales at which the part fits, ascending.")
    ]
    place: Annotated[
        SpacePoint | None,
        Meta(description="With --anywhere: a place of the part at the greatest scale."),
    ]
    supports: Annotated[
        list[FitSupport],
        Meta(description="With --anywhere, in a convex container: the proof of the scale."),
    ]
