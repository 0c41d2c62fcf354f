"""The document of `trap`."""

from __future__ import annotations

from typing import Annotated, Literal

from minkref.schemas.motion.values import CertificateMade, PlaneFit, ScaleRange
from minkref.schemas.values import Point, Window
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
