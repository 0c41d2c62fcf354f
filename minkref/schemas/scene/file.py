"""The file of a scene, `scene-v1`."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from msgspec import Meta

WrittenNumber = Annotated[
    str | int | float,
    Meta(description="Exactly as written: a decimal, or in a string also a fraction, 7/5."),
]
WrittenPoint = Annotated[list[WrittenNumber], Meta(min_length=2, max_length=2)]


class WrittenPolygon(TypedDict):
    outer: list[WrittenPoint]
    holes: NotRequired[list[list[WrittenPoint]]]


class WrittenSet(TypedDict):
    """A polygon set; a single outer ring with one vertex means a point, with two a segment."""

    polygons: list[WrittenPolygon]


class WrittenCopy(TypedDict):
    shape: Annotated[str, Meta(description="The name of a shape.")]
    scale: Annotated[WrittenNumber, Meta(description="Above 0; scales about the origin.")]
    place: Annotated[WrittenPoint, Meta(description="Where the origin goes.")]


SetOfScene = Annotated[
    str | WrittenSet,
    Meta(
        description="WKT or JSON as text, the name of a file, relative to the scene's folder, or "
        "of a model; or the polygons themselves."
    ),
]


class SceneFileText(TypedDict):
    """The file of a scene."""

    schema: Literal["scene-v1"]
    title: NotRequired[Annotated[str, Meta(description="For people; has no effect.")]]
    comment: NotRequired[Annotated[str, Meta(description="For people; has no effect.")]]
    robot: SetOfScene
    shapes: dict[str, SetOfScene]
    copies: NotRequired[
        Annotated[
            list[WrittenCopy] | str,
            Meta(
                description="Or the name of a CSV file with the columns shape, scale, x and y. May "
                "be absent only if --copies names such a file."
            ),
        ]
    ]
