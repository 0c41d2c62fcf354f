"""The document of `view` in the plane."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import PaperRun, Segments, ViewRoute
from minkref.schemas.values import Count, MaybeEroded, Number, Operands, Page
from msgspec import Meta

ViewWindow = TypedDict(
    "ViewWindow",
    {
        "from": Annotated[Number, Meta(description="Begin of the closed window of scales.")],
        "to": Annotated[Number, Meta(description="End of the closed window.")],
    },
)


class ViewDocument(Page, Operands, PaperRun, ViewWindow, MaybeEroded):
    """The document of `minkref view --json`."""

    command: Literal["view"]
    segments: Segments
    boundary_events: Annotated[
        Count,
        Meta(
            description="Scales of the window at which the vertices of the boundary or their order "
            "change."
        ),
    ]
    topology_events: Annotated[
        Count,
        Meta(
            description="Births, deaths, merges, splits and touches of holes and components in the "
            "window."
        ),
    ]
    holes: Annotated[Count, Meta(description="Holes that there are at some scale of the window.")]
    components: Annotated[
        Count, Meta(description="Components that there are at some scale of the window.")
    ]
    tracks: Annotated[
        Count, Meta(description="Vertices a + b s of the boundary, each counted once.")
    ]
    splices: Annotated[Count, Meta(description="Changes of rings that the page stores.")]
    route: Annotated[
        ViewRoute,
        Meta(
            description="How the sums were got: `index`, read off the boundary of the swept sum; "
            "`dynamic`, the paper's dynamic update; `paper-update`, read off, with the answers of "
            "the paper's own program beside them."
        ),
    ]
    first_wrong: Annotated[
        Number | None,
        Meta(
            description="Of the route `paper-update`: the first scale of the slider at which the "
            "structure is another one; null where there is none."
        ),
    ]
    steps: Annotated[
        Annotated[int, Meta(ge=2)] | None,
        Meta(
            description="Of the route `paper-update`: how many scales of the slider the program "
            "goes through."
        ),
    ]
    wrong_steps: Annotated[
        Count | None, Meta(description="At how many of them the structure is another one.")
    ]
