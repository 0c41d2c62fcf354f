"""The documents of `union`, `intersection` and `difference`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import AreaApproximate, PolygonSet
from minkref.schemas.values import Amount, Count, Digest, FileIsExact, Head, Number, Written
from msgspec import Meta


class CombinedOperand(TypedDict):
    name: str
    polygons: Annotated[Count, Meta(description="As the operand has them.")]
    united: Annotated[
        bool, Meta(description="The polygons overlapped or shared edges: they were united first.")
    ]


class CombinedSets(Head, Written):
    operands: list[CombinedOperand]
    output_exact: FileIsExact
    compute_seconds: Annotated[
        Amount, Meta(description="Of the operation, without reading, area and digest.")
    ]
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical JSON.")]
    area: Annotated[Number, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    components: Annotated[Count, Meta(description="Connected components of the interior.")]
    holes: Annotated[Count, Meta(description="Bounded connected components of the complement.")]
    vertices: Annotated[Count, Meta(description="Of the canonical form, over all rings.")]
    result: Annotated[PolygonSet, Meta(description="The set in canonical form.")]


class UnionDocument(CombinedSets):
    """The document of `minkref union --json`."""

    command: Literal["union"]


class IntersectionDocument(CombinedSets):
    """The document of `minkref intersection --json`."""

    command: Literal["intersection"]


class DifferenceDocument(CombinedSets):
    """The document of `minkref difference --json`."""

    command: Literal["difference"]
