"""The document of `scene`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import Parent, SetResult
from minkref.schemas.values import Count, Head, Point, PositiveCount, Written
from msgspec import Meta


class SceneRobot(TypedDict):
    name: Annotated[str, Meta(description="As the scene names it.")]
    vertices: Count


class SceneShape(SceneRobot):
    shape: Annotated[str, Meta(description="Its name in the scene.")]
    copies: Count


class SceneOwner(Parent):
    """An edge of a copy's sum: P is the copy's shape, Q the robot turned by 180 degrees."""

    copy: Annotated[Count, Meta(description="Its number in the scene, from 0.")]


OwnersOfSide = Annotated[
    list[SceneOwner],
    Meta(description="By copy; each whose sum has a part of the side on its boundary."),
]


class ScenePassage(TypedDict):
    points: Annotated[
        list[Point],
        Meta(
            description="One point, or the vertices of a polyline; a closed one ends with its "
            "first.",
            min_length=1,
        ),
    ]
    owners: Annotated[
        list[list[SceneOwner]],
        Meta(
            description="For each segment of the polyline the edges of sums that touch along it or "
            "along a part of it; for a point, in one list, those that touch there.",
            min_length=1,
        ),
    ]


class SceneParts(TypedDict):
    scene: Annotated[str, Meta(description="The scene as named.")]
    robot: SceneRobot
    shapes: list[SceneShape]
    copies: Count
    threads: PositiveCount


class SceneFound(TypedDict):
    owners: Annotated[
        list[list[OwnersOfSide]] | None,
        Meta(
            description="With --owners: for each ring of `result` (per polygon outer, then holes), "
            "for each side, from vertex i to i + 1."
        ),
    ]
    passages: Annotated[
        list[ScenePassage] | None,
        Meta(description="With --passages: the tight passages, in canonical order."),
    ]
    counts: Annotated[dict[str, Count], Meta(description="The work that was done.")]


class SceneDocument(Head, SceneParts, Written, SetResult, SceneFound):
    """The document of `minkref scene --json`."""

    command: Literal["scene"]
