"""Output of `minkref verify`: progress, the table of verdicts, the JSON document."""

from __future__ import annotations

import json
import signal
import sys
from collections import Counter
from pathlib import Path
from typing import Any, Self

from minkref.cli.progress_lines import progress_lines
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.catalogue import TargetEntry
from minkref.fuzz.run.runner import Finding, Run
from minkref.fuzz.shrink.finding import SmallFinding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.output.documents import Stopwatch, document
from minkref.output.signals import OUT_OF_TIME
from minkref.output.terminal import console, counted, escaped
from minkref.reports.conformance.run_words import (
    conclusion,
    counted_cases,
    describe,
    left_out,
    reasons_of,
    untaken,
)
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

SMALL = 400  # vertices up to which a finding carries its operands in full


class TerminalLine:
    """A line on the terminal (standard error); without a terminal a new line every half minute."""

    _words: str
    _progress: Progress

    def __enter__(self) -> Self:
        lines = progress_lines(lambda: self._words) if self._progress.disable else self._progress
        self._shown = lines
        self._shown.__enter__()
        return self

    def __exit__(self, *_: object) -> None:
        self._shown.__exit__(None, None, None)


class ProgressLine(TerminalLine):
    """Cases and findings of `minkref verify`."""

    def __init__(self, count: int | None) -> None:
        self._words = "verify"
        self._progress = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            TextColumn("{task.completed:,} cases"),
            TimeElapsedColumn(),
            TextColumn("{task.fields[findings]}"),
            console=Console(stderr=True),
            transient=True,
            disable=not sys.stderr.isatty(),
        )
        self._task = self._progress.add_task("verify", total=count, findings="")

    def say(self, what: str) -> None:
        self._words = what
        self._progress.update(self._task, description=what)

    def show(self, run: Run) -> None:
        cases = sum(run.cases.values())
        findings = counted(len(run.findings), "finding") if run.findings else ""
        family = run.groups[-1] if run.groups else "verify"
        self._words = ", ".join(filter(None, (f"verify: {counted_cases(cases)}", findings)))
        self._progress.update(self._task, completed=cases, description=family, findings=findings)


def document_of(
    run: Run,
    groups: list[Group],
    chosen: list[TargetEntry],
    absent: list[TargetEntry],
    declared: dict[str, Declaration],
    cases: CaseList,
    watch: Stopwatch,
    code: int,
    walls: Isolation,
) -> dict[str, Any]:
    """The JSON document of a run."""
    versions = {entry.name: entry.version for entry in chosen}
    return document(
        "verify",
        watch,
        exit_code=code,
        ended_by=ended_by(run.ended),
        isolation=walls.document(),
        seed=cases.seed,
        targets=[target_document(entry, declared[entry.name]) for entry in chosen],
        absent=[{"name": entry.name, "reason": entry.reason} for entry in absent],
        notes=cases.notes,
        left_out=dict(untaken(run)),
        groups=[{"name": name, "cases": run.cases[name]} for name in run.groups],
        matrix=matrix_document(run),
        findings=[finding_document(finding, versions) for finding in run.findings],
        shrunk=[
            shrunk_document(group, small, versions) for group in groups for small in group.small
        ],
        report=None,
    )


def matrix_document(run: Run) -> list[dict[str, Any]]:
    return [
        {
            "target": target,
            "group": group,
            "verdicts": dict(cell.verdicts),
            "skips": dict(cell.skips),
            "seconds": round(cell.seconds, 6),
        }
        for (target, group), cell in run.matrix.items()
    ]


def ended_by(number: int | None) -> str | None:
    """Names what ended a run."""
    if number is None:
        return None
    return "time-limit" if number == OUT_OF_TIME else signal.Signals(number).name


def target_document(entry: TargetEntry, declared: Declaration) -> dict[str, Any]:
    return {
        "name": entry.name,
        "version": entry.version,
        "arithmetic": declared.arithmetic,
        "tolerance": declared.tolerance_document(),
        "sum": declared.sum,
        "capabilities": sorted(declared.capabilities),
    }


def finding_document(finding: Finding, versions: dict[str, str | None]) -> dict[str, Any]:
    outcome, case = finding.outcome, finding.case
    small = case.size[0] <= SMALL
    return {
        "target": outcome.target,
        "target_version": versions.get(outcome.target),
        "verdict": str(outcome.verdict),
        "was": str(outcome.was) if outcome.was else None,
        "reasons": [str(reason) for reason in outcome.reasons],
        "message": outcome.message,
        "signal": outcome.signal,
        "case": case.name.text,
        "group": case.name.group,
        "scale": case.scale,
        "P": {"name": case.P_name, "set": json.loads(case.P) if small and case.P else None},
        "Q": {"name": case.Q_name, "set": json.loads(case.Q) if small and case.Q else None},
        "witness": outcome.witness.document() if outcome.witness else None,
        "digest": outcome.digest,
        "expected_digest": outcome.expected_digest,
        "reproduce": finding.reproduce,
    }


def shrunk_document(
    group: Group, small: SmallFinding, versions: dict[str, str | None]
) -> dict[str, Any]:
    """As a finding, of the shrunk case; `count` of its kind."""
    finding = Finding(small.outcome, small.result)
    value = finding_document(finding, versions)
    value["verdict"] = str(group.example.outcome.verdict)
    value["was"] = str(group.example.outcome.was) if group.example.outcome.was else None
    value["message"] = group.example.outcome.message or value["message"]
    return {
        **value,
        "found_as": group.example.case.name.text,
        "count": group.count,
        "calls": small.calls,
        "complete": small.complete,
        "stable": small.stable,
        "call_seconds": small.seconds,
    }


def print_tables(run: Run, groups: list[Group], value: dict[str, Any]) -> None:
    """The smallest findings of each kind, the matrix, what was not asked, and one sentence that
    says how it ended."""
    out = console()
    for group in groups:
        for line in describe(group):
            out.print(line, soft_wrap=True)
        out.print()
    out.print(_matrix(run))
    absent: dict[str, list[str]] = {}
    for row in value["absent"]:
        absent.setdefault(row["reason"], []).append(row["name"])
    for reason, names in absent.items():
        out.print(escaped(f"absent ({', '.join(names)}): {reason}"), soft_wrap=True)
    for note in value["notes"]:
        out.print(escaped(note), soft_wrap=True)
    for line in _skips(run):
        out.print(escaped(line), soft_wrap=True)
    out.print()
    out.print(conclusion(run), soft_wrap=True)
    if value["report"]:
        out.print(escaped(f"report: {value['report']}"), soft_wrap=True)
        certified = len(_certified(value))
        if certified:
            told = f"{counted(certified, 'certificate')} of witnesses: minkref check"
            out.print(escaped(f"{told} {Path(value['report']).parent}"), soft_wrap=True)
    out.print(f"{value['seconds']:.1f} s, {value['peak_bytes'] / 2**20:,.0f} MiB at most")


def _certified(value: dict[str, Any]) -> list[dict[str, Any]]:
    """The findings whose certificates are in the report's folder."""
    rows = [*value["shrunk"], *value["findings"]]
    return [row for row in rows if row.get("certificate", {}).get("file")]


def _matrix(run: Run) -> Table:
    """A row for each target: verdicts over all cases, and the groups with something amiss."""
    verdicts = [
        verdict
        for verdict in Verdict
        if any(cell.verdicts[verdict] for cell in run.matrix.values())
    ]
    title = f"Verdicts on {counted_cases(run.cases.total())}"
    table = Table(title=title, title_justify="left", pad_edge=False)
    table.add_column("target")
    for verdict in verdicts:
        table.add_column(str(verdict), justify="right")
    table.add_column("seconds", justify="right")
    table.add_column("amiss in")
    for target in run.targets:
        cells = {group: run.matrix.get((target, group)) for group in run.groups}
        there = [cell for cell in cells.values() if cell]
        counts = [sum(cell.verdicts[verdict] for cell in there) for verdict in verdicts]
        amiss = [
            group
            for group, cell in cells.items()
            if cell
            and any(v not in (*GOOD, Verdict.SKIPPED) and n for v, n in cell.verdicts.items())
        ]
        table.add_row(
            escaped(target),
            *(f"{count:,}" if count else "" for count in counts),
            f"{sum(cell.seconds for cell in there):.2f}",
            escaped(", ".join(amiss)),
        )
    return table


def _skips(run: Run) -> list[str]:
    """A line for each missing capability, and each other reason, with the number of cases; by whom,
    where others took them. A case that needs several counts for each."""
    counts: Counter[str] = Counter()
    targets: dict[str, list[str]] = {}
    for (target, _), cell in run.matrix.items():
        for message, count in cell.skips.items():
            for reason in reasons_of(message):
                counts[reason] += count
                if target not in targets.setdefault(reason, []):
                    targets[reason].append(target)
    return [
        f"skipped, {counted_cases(count)}: {reason} ({', '.join(targets[reason])})"
        for reason, count in counts.most_common()
    ] + [
        f"left out, {counted_cases(count)}: {reason} (no target takes them)"
        for reason, count in left_out(run).most_common()
    ]
