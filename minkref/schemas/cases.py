"""The document of `generate`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Count, Head
from msgspec import Meta


class GeneratedCase(TypedDict):
    family: str
    index: Annotated[Count, Meta(description="Its number in the family.")]
    id: Annotated[str, Meta(description="The family, and a hash of the content.")]
    case: Annotated[str, Meta(description="File (case-v1).")]
    certificate: Annotated[
        str | None,
        Meta(
            description="File (certificate-v1, in space convex-certificate-v1); null for invalid "
            "input."
        ),
    ]
    bytes: Annotated[Count, Meta(description="Of both files of this id.")]


class GenerateDocument(Head):
    """The document of `minkref generate --json`."""

    command: Literal["generate"]
    output: Annotated[str, Meta(description="The folder.")]
    seed: int
    cases_per_second: Annotated[float, Meta(description="Proof and files included.")]
    different: Annotated[
        Count,
        Meta(description="Of the ids; members that are the same case have the files of the first."),
    ]
    bytes: Annotated[Count, Meta(description="Of all files, each counted once.")]
    cases: Annotated[
        list[GeneratedCase], Meta(description="A row for each member, by family, then by number.")
    ]
