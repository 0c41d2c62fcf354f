"""The document of `adapter check`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Amount, Head
from minkref.schemas.verify.cases import Isolation, Tolerance, Witness
from msgspec import Meta


class CheckedTarget(TypedDict):
    """What it declares."""

    name: str
    version: str | None
    arithmetic: str
    numbers: Literal["text", "double"]
    tolerance: Tolerance
    sum: Literal["region", "boundary", "none"]
    capabilities: list[str]


class JudgedSum(TypedDict):
    what: str
    case: Annotated[str, Meta(description="For --case of verify.")]
    verdict: str
    reasons: list[str]
    message: str
    witness: Witness | None
    seconds: Amount


class AdapterCheckDocument(Head):
    """The document of `minkref adapter check --json`."""

    command: Literal["adapter_check"]
    exit_code: Literal[0, 1, 3]
    isolation: Isolation
    target: CheckedTarget
    left_out: Annotated[
        dict[str, str],
        Meta(
            description="Capabilities that it does not declare, and what the cases have that need "
            "them."
        ),
    ]
    sums: list[JudgedSum]
