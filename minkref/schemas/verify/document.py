"""Documents of `verify` and `shrink`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict, get_args

from minkref.schemas.values import Amount, Count, Head, PositiveCount
from minkref.schemas.verify.cases import Finding, Isolation, Shrunk, Tolerance
from msgspec import Meta

EveryVerdict = Literal[
    "pass",
    "pass-within",
    "wrong",
    "known",
    "errored",
    "crashed",
    "timed-out",
    "out-of-memory",
    "gave-up",
    "undecided",
    "skipped",
]


class ShrinkDocument(Head):
    """The document of `minkref shrink --json`."""

    command: Literal["shrink"]
    isolation: Isolation
    target: str
    shrunk: Shrunk
    output: Annotated[str | None, Meta(description="The case file.")]


class JudgedTarget(TypedDict):
    name: str
    version: str | None
    arithmetic: str
    tolerance: Tolerance
    sum: Literal["region", "boundary", "none"]
    capabilities: list[str]


class AbsentTarget(TypedDict):
    name: str
    reason: str | None


class CaseGroup(TypedDict):
    name: str
    cases: Count


class MatrixCell(TypedDict):
    target: str
    group: str
    verdicts: Annotated[
        dict[str, Count],
        Meta(extra_json_schema={"propertyNames": {"enum": list(get_args(EveryVerdict))}}),
    ]
    skips: Annotated[dict[str, Count], Meta(description="Cases skipped, by reason.")]
    seconds: Annotated[Amount, Meta(description="Spent in the target.")]


class VerifyDocument(Head):
    """The document of `minkref verify --json`."""

    command: Literal["verify"]
    exit_code: Literal[0, 1, 2, 3, 4, 70, 129, 130, 143]
    ended_by: Annotated[
        Literal[None, "SIGHUP", "SIGINT", "SIGTERM", "time-limit"],
        Meta(
            description="The signal, or --time-limit, that ended the run: what was judged until "
            "then is there."
        ),
    ]
    isolation: Isolation
    seed: int
    targets: list[JudgedTarget]
    absent: Annotated[list[AbsentTarget], Meta(description="Targets that were not found here.")]
    notes: Annotated[
        list[str],
        Meta(
            description="What is to be known of the run: the file of the settings, models that are "
            "absent, what no case asked for."
        ),
    ]
    left_out: Annotated[
        dict[str, PositiveCount],
        Meta(description="Why generated cases were taken by no target, and how many."),
    ]
    groups: list[CaseGroup]
    matrix: list[MatrixCell]
    findings: list[Finding]
    report: Annotated[str | None, Meta(description="The page that was written.")]
    shrunk: Annotated[
        list[Shrunk], Meta(description="Findings of each kind made small, without doubles.")
    ]
