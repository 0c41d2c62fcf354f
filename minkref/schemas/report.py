"""The document of `report`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Head
from msgspec import Meta

Subject = Literal["audit", "paper", "degeneracies", "findings"]


class FailedEntry(TypedDict):
    entry: str
    failure: str


class ReportDocument(Head):
    """The document of `minkref report --json`."""

    command: Literal["report"]
    subjects: list[Subject]
    pages: Annotated[list[str], Meta(description="The first page of each.")]
    failed: Annotated[
        list[FailedEntry],
        Meta(description="Entries of the audit whose check has found something else."),
    ]
