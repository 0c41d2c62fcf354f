"""Answers from the paper's own update in space, in documents of `sum` and `sweep`."""

from __future__ import annotations

from typing import Annotated, TypedDict

from minkref.schemas.space.values import SpaceScale
from minkref.schemas.values import Amount, Count, Number, SpacePoint
from msgspec import Meta


class BoundaryWitness(TypedDict):
    """A point for which the program's answer is wrong."""

    point: SpacePoint
    normal: Annotated[
        list[Annotated[str, Meta(pattern="^-?[0-9]+$")]],
        Meta(
            description="Of the plane, with the sum on the side away from it.",
            min_length=3,
            max_length=3,
        ),
    ]
    offset: Annotated[Number, Meta(description="The product of the normal with the point.")]
    on_boundary: Annotated[
        bool,
        Meta(
            description="The exact sum has a face at the point, on this side; the program has "
            "answered the contrary."
        ),
    ]


class SpaceFaults(TypedDict):
    """An answer beside the exact sum."""

    same_structure: Annotated[
        bool,
        Meta(
            description="The same facets of the convolution are on the boundary, each with as many "
            "rings and corners, and the corners are near."
        ),
    ]
    ulps: Annotated[
        Amount | None,
        Meta(
            description="The largest error of a coordinate of a corner, in units in the last place "
            "of the largest; null where the structure differs or it is beyond the range of doubles."
        ),
    ]
    witness: Annotated[
        BoundaryWitness | None,
        Meta(description="Where the structure differs, if a cell of a facet shows it."),
    ]


class SpaceSearch(TypedDict):
    """Counts from the search at all scales."""

    convolution_facets: Count
    pairs: Annotated[Count, Meta(description="Of facets, that were looked at: all.")]
    crossings: Annotated[
        Count, Meta(description="Nodes that exist at some scale, mostly a side in a facet.")
    ]
    events: Annotated[Count, Meta(description="Scales at which crossings begin or end.")]
    undecided_pairs: Annotated[
        Count, Meta(description="Pairs left out, for a number was not a number.")
    ]
    preprocessing_seconds: Amount


class SpaceAnswer(TypedDict):
    """The program's answer at one scale."""

    placed: Annotated[Count, Meta(description="Crossings that are there, at their places.")]
    place_seconds: Amount
    exposed_facets: Annotated[Count, Meta(description="Facets with a part on the boundary.")]
    rings: Annotated[Count, Meta(description="Around these parts.")]
    corners: Annotated[Count, Meta(description="Of these rings: each node of the arrangement.")]
    cells: Annotated[Count, Meta(description="Into which the facets are cut.")]
    asked: Annotated[Count, Meta(description="Of these, that collision detection decided.")]
    sum_seconds: Annotated[
        Amount, Meta(description="Of the arrangements on the facets and collision detection.")
    ]
    exact: SpaceFaults


class SpacePaperAnswer(SpaceSearch, SpaceAnswer):
    """The answer from the paper's own program; all further fields hold the exact sum."""

    arithmetic: Annotated[str, Meta(pattern="^(rational|interval|double|mpfr:[0-9]+)$")]
    readings: Annotated[
        dict[str, str], Meta(description="How the sentences of the paper are read, by name.")
    ]


class PaperSweepRow(SpaceAnswer):
    """A row of `sweep` by the paper's own update."""

    scale: SpaceScale
    insertions: Count
    deletions: Count
    updated: Annotated[Count, Meta(description="Crossings on the list at the scale.")]
    update_seconds: Annotated[
        Amount, Meta(description="Of the events on the way; `place_seconds` come on top.")
    ]
    file: None
    file_exact: None
