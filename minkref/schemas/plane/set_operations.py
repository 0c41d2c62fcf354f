"""The documents of `union`, `intersection` and `difference`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.certificates import CertificateMade
from minkref.schemas.plane.values import ProvedAnswer, SetResult
from minkref.schemas.values import Count, Head, Written
from msgspec import Meta


class CombinedOperand(TypedDict):
    name: str
    polygons: Annotated[Count, Meta(description="As the operand has them.")]
    united: Annotated[
        bool, Meta(description="The polygons overlapped or shared edges: they were united first.")
    ]


class CombinedOperands(TypedDict):
    operands: list[CombinedOperand]


class CombinedSets(Head, Written, CombinedOperands, SetResult):
    """A combination of sets."""

    proof: Annotated[
        ProvedAnswer | None, Meta(description="With --proved; null where the reference combined.")
    ]


class UnionDocument(CombinedSets):
    """The document of `minkref union --json`."""

    command: Literal["union"]
    certificate: CertificateMade


class IntersectionDocument(CombinedSets):
    """The document of `minkref intersection --json`."""

    command: Literal["intersection"]


class DifferenceDocument(CombinedSets):
    """The document of `minkref difference --json`."""

    command: Literal["difference"]
