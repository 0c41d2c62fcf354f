"""The document of `sweep` in space."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired

from minkref.schemas.grammar import Either, ruled
from minkref.schemas.space.paper_update import PaperSweepRow
from minkref.schemas.space.repair import RepairRow
from minkref.schemas.space.values import SpaceScaling
from minkref.schemas.values import Amount, AnySweep, Count, InSpace, Operands
from msgspec import Meta

SpaceSweepFormat = Literal["json", "off", "obj", "stl", "ply"]


class SpaceSweepRow(SpaceScaling):
    vertices: Count
    edges: Count
    facets: Count
    fv_errors: Annotated[Count, Meta(description="Facets of P whose vertex of Q changed.")]
    vf_errors: Annotated[Count, Meta(description="Facets of Q whose vertex of P changed.")]
    ee_errors: Annotated[Count, Meta(description="Pairs of edges that are no more.")]
    descent_steps: Annotated[
        Count, Meta(description="Edges walked from the old vertices to the new ones.")
    ]
    chains_walked: Annotated[
        Count, Meta(description="Edges of P whose compatible edges were looked for again.")
    ]
    update_seconds: Amount | None
    sum_seconds: Annotated[
        Amount | None,
        Meta(
            description="Of the surface in canonical form, with the proof that it is closed and "
            "convex."
        ),
    ]
    file: str | None
    file_exact: bool | None


@ruled(
    dependentRequired={
        "repair": ["arithmetic", "readings"],
        "route": [
            *("arithmetic", "readings", "convolution_facets", "pairs", "crossings", "events"),
            "undecided_pairs",
        ],
    }
)
class SpaceSweepDocument(AnySweep, InSpace, Operands):
    """The document of `minkref sweep --json` for convex polyhedra, and by the paper's own update
    for solids of any shape."""

    command: Literal["sweep"]
    format: SpaceSweepFormat | None
    preprocessing_seconds: Annotated[
        Amount | None,
        Meta(
            description="Of the sum at the first scaling, from scratch; with a route, of the "
            "search for crossings."
        ),
    ]
    rows: Annotated[list[Either[SpaceSweepRow, RepairRow, PaperSweepRow]], Meta(min_length=1)]
    repair: NotRequired[
        Annotated[Literal["literal"], Meta(description="Of the paper's own repair only.")]
    ]
    route: NotRequired[
        Annotated[Literal["paper-update"], Meta(description="Of the paper's own update only.")]
    ]
    convolution_facets: NotRequired[Count]
    pairs: NotRequired[Count]
    crossings: NotRequired[Count]
    events: NotRequired[Count]
    undecided_pairs: NotRequired[Count]
    arithmetic: NotRequired[
        Annotated[str, Meta(description="Of the paper's own repair and update only.")]
    ]
    readings: NotRequired[
        Annotated[
            dict[str, str],
            Meta(
                description="How the sentences of the paper are read, by name; of its own repair "
                "and update only."
            ),
        ]
    ]
