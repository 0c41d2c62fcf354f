"""Documents of `fit`, in the plane and in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.motion.values import AnyFit, PlaneFit, Proof, ScaleRange, SpaceFeature
from minkref.schemas.values import InSpace, Number, Point, SpacePoint
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


class SpaceContact(TypedDict):
    part: SpaceFeature
    obstacle: SpaceFeature


class SpaceFitBound(TypedDict):
    scale: Number
    ends: Annotated[
        bool, Meta(description="Whether the range ends there; otherwise it begins there.")
    ]
    event: Annotated[Literal["contact"], Meta(description="The part touches the container.")]
    at: Annotated[SpacePoint, Meta(description="The point that is touched.")]
    contact: SpaceContact


class SpaceFitDocument(AnyFit, InSpace):
    """The document of `minkref fit --json` in space."""

    command: Literal["fit"]
    container: str
    question: Literal["at"]
    places: Annotated[
        list[SpacePoint],
        Meta(description="The place that was asked for.", min_length=1, max_length=1),
    ]
    scales: Annotated[
        list[ScaleRange], Meta(description="The scales at which the part fits, ascending.")
    ]
    bounds: Annotated[list[SpaceFitBound], Meta(description="The ends of ranges.")]
    proofs: Annotated[
        list[Proof],
        Meta(
            description="Scales at, just below and just above each bound, and whether the part "
            "fits there, decided anew from what its pieces cover."
        ),
    ]
