"""What `minkref verify` shows: progress, the table of verdicts, the JSON document."""

from __future__ import annotations

import json
import re
import sys
from types import TracebackType
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from minkref.documents import Stopwatch, document
from minkref.exits import ExitCode
from minkref.fuzz.cases.case_list import CaseList
from minkref.fuzz.run.runner import Cell, Finding, Run
from minkref.fuzz.targets.catalogue import TargetEntry
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.terminal import console, shown

SMALL = 400  # vertices up to which a finding carries its operands in full


class ProgressLine:
    """A line on the terminal (standard error); nothing in a pipe."""

    def __init__(self, count: int | None) -> None:
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

    def __enter__(self) -> ProgressLine:
        self._progress.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._progress.stop()

    def show(self, run: Run) -> None:
        self._progress.update(
            self._task,
            completed=sum(run.cases.values()),
            description=run.groups[-1],
            findings=f"{len(run.findings)} findings" if run.findings else "",
        )


def document_of(
    run: Run,
    chosen: list[TargetEntry],
    absent: list[TargetEntry],
    cases: CaseList,
    watch: Stopwatch,
    code: ExitCode,
) -> dict[str, Any]:
    """The JSON document of a run."""
    versions = {entry.name: entry.version for entry in chosen}
    return document(
        "verify",
        watch,
        exit_code=int(code),
        seed=cases.seed,
        targets=[{"name": entry.name, "version": entry.version} for entry in chosen],
        absent=[{"name": entry.name, "reason": entry.reason} for entry in absent],
        notes=cases.notes,
        groups=[{"name": name, "cases": run.cases[name]} for name in run.groups],
        matrix=[
            {
                "target": target,
                "group": group,
                "verdicts": dict(cell.verdicts),
                "skips": dict(cell.skips),
                "seconds": round(cell.seconds, 6),
            }
            for (target, group), cell in run.matrix.items()
        ],
        findings=[finding_document(finding, versions) for finding in run.findings],
        report=None,
    )


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


def print_tables(run: Run, value: dict[str, Any]) -> None:
    """The matrix, the smallest finding of each kind, and one sentence that says how it ended."""
    out = console()
    out.print(_matrix(run))
    absent: dict[str, list[str]] = {}
    for row in value["absent"]:
        absent.setdefault(row["reason"], []).append(row["name"])
    for reason, names in absent.items():
        out.print(shown(f"skipped ({', '.join(names)}): {reason}"), soft_wrap=True)
    for note in value["notes"]:
        out.print(note, soft_wrap=True)
    for reason, names in _skips(run).items():
        out.print(shown(f"skipped ({', '.join(names)}): {reason}"), soft_wrap=True)
    for finding, count in run.smallest():
        out.print()
        for line in describe(finding, count):
            out.print(line, soft_wrap=True)
    out.print()
    out.print(conclusion(run), soft_wrap=True)
    if value["report"]:
        out.print(shown(f"report: {value['report']}"), soft_wrap=True)
    out.print(f"{value['seconds']:.1f} s, {value['peak_bytes'] / 2**20:,.0f} MiB at most")


def _matrix(run: Run) -> Table:
    table = Table(title="Verdicts", title_justify="left", pad_edge=False)
    table.add_column("target")
    for group in run.groups:
        table.add_column(f"{group}\n{run.cases[group]:,} cases")
    table.add_column("seconds", justify="right")
    for target in run.targets:
        cells = [run.matrix.get((target, group)) for group in run.groups]
        seconds = sum(cell.seconds for cell in cells if cell)
        table.add_row(shown(target), *(cell_text(cell) for cell in cells), f"{seconds:.2f}")
    return table


def cell_text(cell: Cell | None) -> str:
    """`9,812 pass, 13 known`, in the order of severity of the verdicts."""
    if cell is None:
        return "-"
    return "\n".join(
        f"{cell.verdicts[verdict]:,} {verdict}" for verdict in Verdict if cell.verdicts[verdict]
    )


def _skips(run: Run) -> dict[str, list[str]]:
    """Why cases were skipped, with names and numbers of single cases left out, and by whom."""
    found: dict[str, list[str]] = {}
    for (target, _), cell in run.matrix.items():
        for message in cell.skips:
            general = re.sub(r"^[PQ]: ", "", message)
            general = re.sub(
                r"^\d[\d,]* (pairs of vertices), more than \d[\d,]*", r"too many \1", general
            )
            general = re.sub(r"\brings \d+ and \d+ meet", "rings meet", general)
            names = found.setdefault(general, [])
            if target not in names:
                names.append(target)
    return found


def describe(finding: Finding, count: int) -> list[str]:
    """The lines about one kind of finding, without control characters."""
    outcome, case = finding.outcome, finding.case
    times = "once" if count == 1 else f"{count:,} times, here the smallest"
    was = f" (was {outcome.was})" if outcome.was else ""
    kinds = f": {', '.join(str(reason) for reason in outcome.reasons)}" if outcome.reasons else ""
    lines = [f"{outcome.target} {outcome.verdict}{was}{kinds}, {times}"]
    if outcome.message:
        lines.append(f"  {outcome.message}")
    if outcome.signal and outcome.signal not in outcome.message:
        lines.append(f"  signal {outcome.signal}")
    lines.append(f"  case {case.name.text}, scale {case.scale}, {case.size[0]} vertices")
    witness = outcome.witness
    if witness is not None:
        point = f"({', '.join(witness.point)})"
        scale = witness.scale or case.scale
        if witness.in_truth and witness.p and witness.q:
            lines.append(
                f"  witness {point} is in the sum: {scale} * ({', '.join(witness.p)}) "
                f"+ ({', '.join(witness.q)})"
            )
        else:
            lines.append(
                f"  witness {point} is outside the sum at {scale}: the scaled P does not meet the "
                "point less Q"
            )
    lines.append(f"  {finding.reproduce}")
    return [shown(line) for line in lines]


def conclusion(run: Run) -> str:
    """One sentence: what was run and how it ended."""
    verdicts: dict[str, int] = {}
    for cell in run.matrix.values():
        for verdict, count in cell.verdicts.items():
            verdicts[verdict] = verdicts.get(verdict, 0) + count
    counts = ", ".join(f"{verdicts[v]:,} {v}" for v in Verdict if verdicts.get(v))
    return (
        f"{sum(run.cases.values()):,} cases, {len(run.targets)} targets: {counts or 'nothing run'}"
    )
