"""Documents of `campaign query`, `compact` and `site`."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypedDict

from minkref.schemas.values import Count, Head
from msgspec import Meta


class AnswerColumn(TypedDict):
    name: str
    type: Annotated[str, Meta(description="As Arrow calls it.")]


class CampaignQueryDocument(Head):
    """The document of `minkref campaign query --json`."""

    command: Literal["campaign_query"]
    folder: str
    question: Annotated[str | None, Meta(description="The name of the question, if it has one.")]
    sql: str
    columns: list[AnswerColumn]
    count: Annotated[Count, Meta(description="How many rows the answer has.")]
    output: Annotated[str | None, Meta(description="The file that was written; else see `rows`.")]
    rows: Annotated[
        list[list[Any]],
        Meta(description="The answer. Times are text in ISO 8601, UTC. None if a file has them."),
    ]


class CampaignCompactDocument(Head):
    """The document of `minkref campaign compact --json`."""

    command: Literal["campaign_compact"]
    folder: str
    files: Annotated[Count, Meta(description="Files that were written.")]
    rows: Annotated[Count, Meta(description="Rows in these files.")]
    chunks: Annotated[Count, Meta(description="Chunks in these files.")]


class CampaignSiteDocument(Head):
    """The document of `minkref campaign site --json`."""

    command: Literal["campaign_site"]
    folder: str
    page: Annotated[str, Meta(description="The front page.")]
    subjects: Annotated[list[str], Meta(description="The libraries that have pages.")]
