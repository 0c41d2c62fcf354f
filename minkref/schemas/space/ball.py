"""Documents: `sum` and `erode` with a ball."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import Radius, RadiusOrRoot
from minkref.schemas.grammar import Either
from minkref.schemas.space.sum import Rounding
from minkref.schemas.space.values import PolyhedralSet, Polyhedron, SpaceScale, VolumeApproximate
from minkref.schemas.values import (
    AskedPlace,
    Count,
    Digest,
    FileIsExact,
    Fraction,
    Head,
    InSpace,
    Number,
    Operands,
    Written,
)
from msgspec import Meta


class SetInSpace(TypedDict):
    """A polyhedral set."""

    convex: bool
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical JSON.")]
    volume: Annotated[Number, Meta(description="Exact.")]
    volume_approximate: VolumeApproximate
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


class WithBall(Head, InSpace, Operands, Written):
    """The answer with a ball lies between two polyhedral sets."""

    scale: SpaceScale
    output_exact: FileIsExact
    output_is: Annotated[
        Literal["inner", "outer", None], Meta(description="The set that was written.")
    ]
    rounding: Annotated[Rounding | None, Meta(description="As `minkref sum` tells it.")]
    radius: Annotated[RadiusOrRoot, Meta(description="Of the ball: a number, or the root of one.")]
    squared_radius: Fraction
    tolerance: Annotated[Radius, Meta(description="How far polyhedra may be off the ball.")]
    components: Annotated[
        Count | None,
        Meta(
            description="Of the sum, proven, if both sets have as many; null otherwise, and for an "
            "erosion."
        ),
    ]
    inner: Annotated[SetInSpace, Meta(description="Within the answer.")]
    outer: Annotated[SetInSpace, Meta(description="Contains the answer.")]


class BallSumDocument(WithBall):
    """The document of `minkref sum --json` with a ball."""

    command: Literal["sum"]
    at: AskedPlace


class BallErodeDocument(WithBall):
    """The document of `minkref erode --json` with a ball."""

    command: Literal["erode"]
