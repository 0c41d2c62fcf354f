"""The document of `scene`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.motion.values import Feature
from minkref.schemas.plane.values import Parent, SetResult
from minkref.schemas.values import Count, Head, Number, Point, PositiveCount, Written
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


class FreeCell(TypedDict):
    """A connected component beside `result`."""

    component: Annotated[Count, Meta(description="The free component that it belongs to.")]
    outer: Annotated[list[Point] | None, Meta(description="null: without bound.")]
    holes: list[list[Point]]


class FreeComponents(TypedDict):
    contact: Literal["allowed", "forbidden"]
    count: Annotated[PositiveCount, Meta(description="The one without bound, number 0, included.")]
    cells: Annotated[
        list[FreeCell],
        Meta(
            description="The one without bound first, then in canonical order. A component without "
            "a cell is a tight passage.",
            min_length=1,
        ),
    ]


class SceneHolder(TypedDict):
    copy: Count
    contact: Literal["touching", "overlapping"]


class SceneStop(TypedDict):
    """The contact that stops the robot."""

    copy: Count
    segment: Annotated[Count, Meta(description="Of the way.")]
    t: Number
    at: Annotated[Point, Meta(description="The place of the robot's origin.")]
    robot: Feature
    shape: Annotated[Feature, Meta(description="Of the copy's shape.")]
    touching: Point


class SceneSeam(TypedDict):
    """Copies that stop a robot without area together, none of them alone."""

    copies: Annotated[list[Count], Meta(min_length=2)]
    segment: Annotated[Count, Meta(description="Of the way.")]
    t: Number
    at: Annotated[Point, Meta(description="The place of the robot's origin.")]
    touching: Annotated[Point, Meta(description="Inside the union of the copies.")]


class SceneGrowth(TypedDict):
    factor: Annotated[Number | None, Meta(description="null: without bound.")]
    included: Annotated[bool, Meta(description="Whether it is free at the factor itself.")]
    stop: SceneStop | None
    seam: Annotated[
        SceneSeam | None,
        Meta(
            description="In place of a stop; then `included` tells whether it closes just above "
            "the factor, not at it."
        ),
    ]


class SceneAnswer(TypedDict):
    """The answer about a place or a way."""

    points: Annotated[list[Point], Meta(min_length=1)]
    contact: Literal["allowed", "forbidden"]
    free: bool
    stopped_by: Annotated[
        list[Count],
        Meta(description="Copies that stop the robot by themselves; none where a seam does."),
    ]
    holders: Annotated[
        list[SceneHolder] | None,
        Meta(description="Of a place: the copies that the robot meets there."),
    ]
    growth: Annotated[
        SceneGrowth | None,
        Meta(
            description="The largest factor by which all copies may grow, each about its own "
            "place; null where the way is not free."
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
    free_components: Annotated[
        FreeComponents | None, Meta(description="With --contact: the free places' components.")
    ]
    asked: Annotated[SceneAnswer | None, Meta(description="With --at or --way.")]
    counts: Annotated[dict[str, Count], Meta(description="The work that was done.")]


class SceneDocument(Head, SceneParts, Written, SetResult, SceneFound):
    """The document of `minkref scene --json`."""

    command: Literal["scene"]
