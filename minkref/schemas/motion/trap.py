"""Documents of `trap`, in the plane and in space."""

from __future__ import annotations

from typing import Annotated, Literal

from minkref.schemas.certificates import CertificateMade
from minkref.schemas.motion.values import PlaneFit, ScaleRange, SpaceFree
from minkref.schemas.values import InSpace, Point, SpacePoint, Window
from msgspec import Meta


class TrapDocument(PlaneFit, Window):
    """The document of `minkref trap --json`."""

    command: Literal["trap"]
    obstacles: str
    at: Annotated[Point, Meta(description="The place of the part's origin.")]
    scales: Annotated[
        list[ScaleRange],
        Meta(
            description="The scales at which the part is free at the place and trapped there, "
            "ascending."
        ),
    ]
    certificate: CertificateMade


class SpaceTrapDocument(SpaceFree, InSpace, Window):
    """The document of `minkref trap --json` in space."""

    command: Literal["trap"]
    obstacles: str
    at: Annotated[SpacePoint, Meta(description="The place of the part's origin.")]
    scales: Annotated[
        list[ScaleRange],
        Meta(description="The scales at which the part is free at the place and trapped there."),
    ]
