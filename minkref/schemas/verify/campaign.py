"""Documents of `campaign`: run, status and merge."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Amount, Count, Head, PositiveCount
from minkref.schemas.verify.cases import Finding, Isolation, Shrunk
from minkref.schemas.verify.document import AbsentTarget, CaseGroup, JudgedTarget, MatrixCell
from msgspec import Meta

CampaignId = Annotated[
    str, Meta(pattern="^[0-9a-f]{12}$", description="Made of cases, versions and limits.")
]


class FoundKind(TypedDict):
    """Findings with one target, verdict and reasons."""

    count: PositiveCount
    first: Annotated[Finding, Meta(description="The first in the campaign's order.")]
    shrunk: list[Shrunk]
    unshrunk: Annotated[str, Meta(description="Why shrinking failed.")]


class CampaignRunDocument(Head):
    """The document of `minkref campaign run --json`."""

    command: Literal["campaign_run"]
    exit_code: Literal[0, 1, 2, 3, 4, 70, 129, 130, 143]
    ended_by: Literal[None, "SIGHUP", "SIGINT", "SIGTERM"]
    isolation: Isolation
    campaign: CampaignId
    name: str
    folder: str
    seed: int
    targets: list[JudgedTarget]
    absent: list[AbsentTarget]
    notes: list[str]
    left_out: Annotated[
        dict[str, PositiveCount], Meta(description="Cases that no target takes, by reason.")
    ]
    families: list[str]
    chunks: Annotated[Count, Meta(description="Chunks in the ledger.")]
    failed: Annotated[dict[str, str], Meta(description="Chunks without a result, with reasons.")]
    cases: Annotated[Count, Meta(description="Judged by all runs.")]
    cases_here: Annotated[Count, Meta(description="Judged by this run.")]
    campaign_seconds: Annotated[Amount, Meta(description="Time of all runs.")]
    worker_seconds: Annotated[Amount, Meta(description="Work of all workers in this run.")]
    behaviours: Annotated[Count, Meta(description="Different combinations that cases showed.")]
    findings: Count
    groups: list[CaseGroup]
    matrix: list[MatrixCell]
    kinds: list[FoundKind]


class CampaignRow(TypedDict):
    campaign: CampaignId
    name: str
    minkref: str
    seed: int
    versions: Annotated[dict[str, str | None], Meta(description="By target.")]
    families: list[str]
    chunks: Count
    verdicts: dict[str, Count]
    cases: Annotated[Count, Meta(description="Counted by the last state.")]
    kinds: Count
    behaviours: Count
    campaign_seconds: Amount


class CampaignStatusDocument(Head):
    """The document of `minkref campaign status --json`."""

    command: Literal["campaign_status"]
    folder: str
    campaigns: list[CampaignRow]


class CampaignMergeDocument(Head):
    """The document of `minkref campaign merge --json`."""

    command: Literal["campaign_merge"]
    output: str
    campaigns: list[CampaignId]
    chunks: Annotated[Count, Meta(description="In the output's ledger.")]
    repeated: Annotated[Count, Meta(description="Chunks in several folders.")]
    differing: Annotated[
        list[str], Meta(description="Repeated chunks that differ in more than times.")
    ]
