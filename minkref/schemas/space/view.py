"""The document of `view` in space."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from minkref.schemas.space.values import SpaceScaling
from minkref.schemas.values import Count, InSpace, Operands, Page, PositiveCount
from msgspec import Meta

FrameKindsOfTwo = TypedDict(
    "FrameKindsOfTwo", {"facet+edge": Count, "edge+facet": Count, "facet+facet": Count}
)


class FrameKinds(FrameKindsOfTwo):
    """Facets by what they are the sum of: a facet (f), an edge (e) or a vertex (v) of P, and one
    of Q. `several`, where an operand is not convex: of different kinds in one plane."""

    fv: Count
    vf: Count
    ee: Count
    several: NotRequired[Count]


class Frame(SpaceScaling):
    vertices: Annotated[int, Meta(ge=4)]
    edges: Annotated[int, Meta(ge=6)]
    facets: Annotated[int, Meta(ge=4)]
    components: NotRequired[
        Annotated[
            PositiveCount,
            Meta(
                description="Of the interior; this and the next two only where an operand is not "
                "convex."
            ),
        ]
    ]
    cavities: NotRequired[
        Annotated[Count, Meta(description="Bounded components of the complement.")]
    ]
    tunnels: NotRequired[
        Annotated[
            Count,
            Meta(description="The sum of the genera of the surfaces that bound the components."),
        ]
    ]
    kinds: FrameKinds
    fv_errors: Annotated[
        Count | None,
        Meta(
            description="Facets of P whose vertex of Q changed. Null, as the next four, where an "
            "operand is not convex: each sum is found from scratch then."
        ),
    ]
    vf_errors: Annotated[Count | None, Meta(description="Facets of Q whose vertex of P changed.")]
    ee_errors: Annotated[Count | None, Meta(description="Pairs of edges that are no more.")]
    descent_steps: Annotated[
        Count | None, Meta(description="Edges walked from the old vertices to the new ones.")
    ]
    chains_walked: Annotated[
        Count | None, Meta(description="Edges of P whose compatible edges were looked for again.")
    ]


class ViewEventKinds(TypedDict):
    vertex: Count
    edge: Count
    parallel: Count
    triple: Count
    four: Count


class SpaceViewDocument(Page, InSpace, Operands):
    """The document of `minkref view --json` in space."""

    command: Literal["view"]
    viewer: Annotated[
        str, Meta(description="The library in the page that draws, with its version.")
    ]
    frames: Annotated[
        list[Frame],
        Meta(description="One for each scale, in the order of the slider.", min_length=1),
    ]
    events: Annotated[
        ViewEventKinds | None,
        Meta(
            description="With --from and --to: how many events of facets there are in the window, "
            "by kind."
        ),
    ]
