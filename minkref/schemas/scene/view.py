"""The document of `view` for a scene."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.scene.scene import SceneRobot, SceneShape
from minkref.schemas.values import Count, Page
from msgspec import Meta


class SceneViewParts(TypedDict):
    scene: Annotated[str, Meta(description="The scene as named.")]
    robot: SceneRobot
    shapes: list[SceneShape]
    copies: Count
    sums: Annotated[Count, Meta(description="Different shapes that have copies.")]
    tracks: Annotated[Count, Meta(description="Vertices a + b s of the boundaries of these sums.")]
    boundary_events: Annotated[
        Count, Meta(description="Scales of the page at which one of these boundaries changes.")
    ]


class SceneViewDocument(Page, SceneViewParts):
    """The document of `minkref view --json` for a scene."""

    command: Literal["view"]
