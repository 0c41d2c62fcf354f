"""The document of `view` with a path."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.motion.values import OnPath
from minkref.schemas.values import Count, Number, Page
from msgspec import Meta

PathViewWindow = TypedDict(
    "PathViewWindow",
    {
        "from": Annotated[
            Number, Meta(description="The smallest scale of the slider; 0 is none itself.")
        ],
        "to": Annotated[Number, Meta(description="The largest.")],
    },
)


class PathViewDocument(Page, OnPath, PathViewWindow):
    """The document of `minkref view --json` with a path."""

    command: Literal["view"]
    part: Annotated[str, Meta(description="The operand as named.")]
    obstacles: Annotated[str, Meta(description="The operand as named.")]
    bounds: Annotated[Count, Meta(description="How many ends of valid ranges there are.")]
    polygons: Annotated[
        Count,
        Meta(
            description="Of the window, each of a piece of the part, one of the obstacles and a "
            "segment."
        ),
    ]
