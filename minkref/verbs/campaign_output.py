"""Output of `minkref campaign`: progress, tables, JSON documents."""

from __future__ import annotations

import sys
import time
from collections import Counter, deque
from typing import TYPE_CHECKING, Any

from minkref.fuzz.campaign.engine import Drive
from minkref.fuzz.shrink.groups import Group
from minkref.output.documents import Stopwatch, document
from minkref.output.terminal import console, counted, escaped
from minkref.reports.conformance.run_words import counted_cases, untaken
from minkref.verbs.verify_output import (
    TerminalLine,
    ended_by,
    finding_document,
    matrix_document,
    print_tables,
    shrunk_document,
    target_document,
)
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

if TYPE_CHECKING:
    from minkref.verbs.campaign_work import Campaign

RATE_SECONDS = 30.0  # over which the shown rate is taken


class CampaignLine(TerminalLine):
    """Cases, rate, findings and time left of a campaign."""

    def __init__(self, drive: Drive) -> None:
        self._words, self._said = "campaign", ""
        self._rates: deque[tuple[float, int]] = deque()
        self._progress = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TimeElapsedColumn(),
            TextColumn("{task.fields[told]}", markup=False),
            console=Console(stderr=True),
            transient=True,
            disable=not sys.stderr.isatty(),
        )
        total = drive.goal.cases or drive.goal.seconds
        self._task = self._progress.add_task("campaign", total=total, told="")

    def say(self, what: str) -> None:
        """Tells, once, above the line."""
        if what == self._said:
            return
        self._said = what
        if self._progress.disable:
            sys.stderr.write(f"minkref: {escaped(what)}\n")
        else:
            self._progress.console.print(escaped(what), markup=False, highlight=False)

    def show(self, drive: Drive) -> None:
        tally, goal = drive.tally, drive.goal
        rate = self._rate(drive.here)
        told = [f"{rate:,.1f} cases/s", counted(len(tally.behaviours), "behaviour")]
        told.append(counted(tally.findings, "finding"))
        if goal.cases is not None and rate > 0:
            minutes, seconds = divmod(round(max(0, goal.cases - tally.cases) / rate), 60)
            told.append(f"{minutes}:{seconds:02} min left")
        told.append(counted(drive.workers, "worker") if drive.workers else "no worker yet")
        self._words = f"campaign: {counted_cases(tally.cases)}, {', '.join(told)}"
        done = tally.cases if goal.cases is not None else drive.seconds
        self._progress.update(
            self._task,
            completed=min(done, goal.cases or goal.seconds or done),
            description=counted_cases(tally.cases),
            told=", ".join(told),
        )

    def _rate(self, cases: int) -> float:
        now = time.monotonic()
        self._rates.append((now, cases))
        while len(self._rates) > 2 and now - self._rates[0][0] > RATE_SECONDS:
            self._rates.popleft()
        since, before = self._rates[0]
        return (cases - before) / (now - since) if now - since > 1 else 0.0


def document_of(
    campaign: Campaign, drive: Drive, watch: Stopwatch, code: int, notes: list[str]
) -> dict[str, Any]:
    """The JSON document of a run."""
    tally, run = drive.tally, drive.tally.finished()
    notes = [
        *notes,
        *(
            f"{name}: {count:,} answers pass without a proof, the first {first}"
            for name, (count, first) in sorted(tally.unproven.items())
        ),
    ]
    if any(entry.name.startswith(("py:", "so:", "cmd:", ".", "/")) for entry in campaign.chosen):
        notes.append(campaign.walls.sentence())
    return document(
        "campaign_run",
        watch,
        exit_code=code,
        ended_by=ended_by(run.ended),
        isolation=campaign.walls.document(),
        campaign=campaign.id,
        name=campaign.file.name,
        folder=str(campaign.folder),
        seed=campaign.file.seed,
        targets=[
            target_document(entry, campaign.declared[entry.name]) for entry in campaign.chosen
        ],
        absent=[{"name": entry.name, "reason": entry.reason} for entry in campaign.absent],
        notes=notes,
        left_out=dict(untaken(run)),
        families=list(dict.fromkeys(family for _, family in campaign.plan.families)),
        chunks=drive.chunks_done,
        failed=dict(drive.failed),
        cases=tally.cases,
        cases_here=drive.here,
        campaign_seconds=round(tally.spent, 3),
        worker_seconds=round(drive.work_seconds, 3),
        behaviours=len(tally.behaviours),
        findings=tally.findings,
        groups=[{"name": name, "cases": run.cases[name]} for name in run.groups],
        matrix=matrix_document(run),
        kinds=[_kind_document(group, campaign.versions) for group in tally.groups()],
    )


def _kind_document(group: Group, versions: dict[str, str | None]) -> dict[str, Any]:
    return {
        "count": group.count,
        "first": finding_document(group.example, versions),
        "shrunk": [shrunk_document(group, small, versions) for small in group.small],
        "unshrunk": group.unshrunk,
    }


def print_campaign(drive: Drive, value: dict[str, Any]) -> None:
    """The tables of `minkref verify`, and where the campaign stands."""
    groups = drive.tally.groups()
    print_tables(drive.tally.run, groups, {**value, "report": None})
    rate = value["cases_here"] / drive.seconds if drive.seconds > 1 else 0.0
    rows = [
        f"campaign {value['campaign']} in {value['folder']}",
        counted(value["chunks"], "chunk"),
        f"{counted_cases(value['cases_here'])} by this run, {rate:,.1f} a second",
        counted(value["behaviours"], "behaviour"),
    ]
    console().print(escaped(", ".join(rows)), soft_wrap=True)


def verdicts_of(matrix: list[dict[str, Any]]) -> dict[str, int]:
    """Adds up the verdicts of a matrix."""
    counts: Counter[str] = Counter()
    for cell in matrix:
        counts.update(cell["verdicts"])
    return dict(counts)
