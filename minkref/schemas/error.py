"""What a command prints that refuses."""

from __future__ import annotations

from typing import Annotated, TypedDict

from msgspec import Meta


class Refused(TypedDict):
    code: Annotated[str, Meta(description="A stable word.")]
    what: str
    where: str
    mend: str


class ErrorDocument(TypedDict):
    """What --json prints where a command refuses (exit code 2)."""

    version: str
    command: str
    error: Refused
