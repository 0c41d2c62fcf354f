"""Documents: `erode`, `opening`, `closing`, `nofit` and `innerfit` in space."""

from __future__ import annotations

from typing import Annotated, Literal

from minkref.schemas.grammar import Either
from minkref.schemas.plane.erode import ContainerAndPart, FixedAndMoving
from minkref.schemas.space.sum import Rounding, SpacePassages
from minkref.schemas.space.values import PolyhedralSet, Polyhedron, SpaceScaling
from minkref.schemas.values import (
    Amount,
    Count,
    Digest,
    FileIsExact,
    Head,
    InSpace,
    Number,
    Operands,
    Written,
)
from msgspec import Meta

SpaceErodeRoute = Literal["edges", "definition"]


class RemainingInSpace(Head, InSpace, Written, SpaceScaling):
    """What all these documents have."""

    output_exact: FileIsExact
    rounding: Annotated[Rounding | None, Meta(description="As `minkref sum` tells it.")]
    route: SpaceErodeRoute
    compute_seconds: Amount
    convex: bool
    digest: Digest
    volume: Number
    volume_approximate: float | None
    vertices: Count
    edges: Count
    facets: Count
    components: Annotated[Count, Meta(description="Connected components of the interior.")]
    cavities: Annotated[Count, Meta(description="Bounded components of the complement.")]
    tunnels: Count
    result: Annotated[
        Either[PolyhedralSet, Polyhedron],
        Meta(description="The canonical form: of a convex set that of a convex polyhedron."),
    ]


SpaceFits = Annotated[
    SpacePassages | None,
    Meta(
        description="What has no volume of its own: there the moving operand fits exactly. Null "
        "where it was not looked for (--passages)."
    ),
]


class SpaceErodeDocument(RemainingInSpace, Operands):
    """The document of `minkref erode --json` in space."""

    command: Literal["erode"]
    remnants: SpaceFits


class SpaceOpeningDocument(RemainingInSpace, Operands):
    """The document of `minkref opening --json` in space."""

    command: Literal["opening"]
    exact_fits: Annotated[
        SpacePassages | None,
        Meta(
            description="The erosion's remnants: places at which Q just fits. Copies there are "
            "left out. Null where they were not looked for (--passages)."
        ),
    ]


class SpaceClosingDocument(RemainingInSpace, Operands):
    """The document of `minkref closing --json` in space."""

    command: Literal["closing"]
    remnants: SpaceFits


class SpaceNoFitDocument(RemainingInSpace, FixedAndMoving):
    """The document of `minkref nofit --json` in space."""

    command: Literal["nofit"]
    exact_fits: SpaceFits


class SpaceInnerFitDocument(RemainingInSpace, ContainerAndPart):
    """The document of `minkref innerfit --json` in space."""

    command: Literal["innerfit"]
    exact_fits: SpaceFits
