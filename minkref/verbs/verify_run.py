"""A run of `minkref verify`, and what it writes."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import typer
from minkref.cli.command_line import command_line
from minkref.errors import refusal_text
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.isolation.isolation import Isolation, choose
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.catalogue import TargetEntry
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.pool import InternalError
from minkref.fuzz.run.runner import Run, run
from minkref.fuzz.run.unasked import not_asked, resting_notes, unproven_notes
from minkref.fuzz.shrink.groups import Group, shrunk_groups
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.baseline import Baseline, accepting, read_baseline, unused
from minkref.output.documents import Stopwatch, as_text, check_writable, write_together
from minkref.output.exits import ExitCode
from minkref.output.output_folder import held_folder
from minkref.output.signals import OUT_OF_TIME, ending_in_order, time_limit
from minkref.output.terminal import counted
from minkref.reports.conformance.annotation_kinds import check_annotations
from minkref.reports.conformance.annotations import annotation_lines
from minkref.reports.conformance.junit import junit
from minkref.reports.conformance.lines import json_lines
from minkref.reports.conformance.markdown import markdown
from minkref.reports.conformance.page import write_report
from minkref.reports.conformance.sarif import sarif
from minkref.reports.conformance.space_showcase import space_showcases, told
from minkref.verbs.verify_cases import case_list
from minkref.verbs.verify_limits import check_numbers
from minkref.verbs.verify_output import ProgressLine, document_of, print_tables
from minkref.verbs.verify_request import Bounds, Output, VerifyRequest

NOTHING_RUN: dict[str, object] = {
    "where": "minkref verify",
    "what": "nothing was run: every target skipped every case, or there was no case",
    "mend": "choose other targets or cases, or raise --pairs, --seconds or --size-limit",
}


def answer(context: typer.Context, request: VerifyRequest, command: Callable[..., Any]) -> None:
    watch = Stopwatch()
    asked, output = request.asked, request.output
    _check(request)
    listed = read_baseline(asked.baseline) if asked.baseline is not None else Baseline()
    walls = _walls(request)
    limits = _limits(request.bounds, walls)
    chosen, absent = ALL_TARGETS.select(asked.targets or [])
    chosen, declared = declarations_of(chosen, ALL_TARGETS, limits)
    cases = case_list(request.cases, declared.values())
    if asked.settings is not None:
        cases.notes.append(f"settings: {asked.settings}")
    if any(ALL_TARGETS.declares_itself(entry.name) for entry in chosen):
        cases.notes.append(walls.sentence())
    if output.report is not None:
        context.with_resource(held_folder(output.report))
    done, groups = _judged(request, cases, chosen, listed, limits)
    cases.notes += _notes(done, groups, cases, chosen, declared)
    versions = {entry.name: entry.version for entry in chosen}
    cases.notes += unused(listed, [finding.outcome for finding in done.findings], versions)
    code = done.exit_code(output.strict)
    solids = []
    if output.report is not None and not (asked.targets or request.cases.case or done.ended):
        solids = space_showcases()
        cases.notes.append(told(solids))
        if any(show.differ for show in solids):
            code = code or ExitCode.WRONG
    if done.ended is not None:
        cases.notes.append(_ended(done, request))
    if output.write_baseline is not None and code in (ExitCode.WRONG, ExitCode.BROKEN):
        code = ExitCode.ALL_WELL
    if done.failed is not None:
        cases.notes.append("ended by a fault of ours: everything judged so far is here")
    value = document_of(done, groups, chosen, absent, declared, cases, watch, code, walls)
    if output.report is not None:
        again = command_line("verify", command, _said(request))
        page = write_report(output.report, done, groups, value, limits, again, solids)
        value["report"] = str(page)
        value["seconds"] = watch.seconds()
    accepted = None
    if output.write_baseline is not None:
        faults = ((finding.outcome, finding.case.name.text) for finding in done.findings)
        accepted = accepting(listed, faults, versions)
    _give(output, done, groups, value, walls, accepted)
    if done.failed is not None:
        raise InternalError(done.failed)
    if code == ExitCode.USAGE:
        sys.stderr.write(refusal_text(NOTHING_RUN))
    if code:
        raise typer.Exit(int(code))


def _check(request: VerifyRequest) -> None:
    """Refuses numbers out of range, and files that cannot be written."""
    cases, bounds = request.cases, request.bounds
    check_numbers(
        {
            "--seconds": cases.seconds,
            "--time-limit": bounds.time_limit,
            "--pairs": cases.pairs,
            "--seed": cases.seed,
            "--jobs": bounds.jobs,
            "--call-memory": bounds.call_memory,
            "--call-output": bounds.call_output,
            "--call-processes": bounds.call_processes,
            "--memory": bounds.memory,
            "--size-limit": bounds.size_limit,
            "--call-seconds": bounds.call_seconds,
        }
    )
    for file in request.output.verdict_files():
        check_writable(file)
    check_annotations(request.output.annotations)


def _walls(request: VerifyRequest) -> Isolation:
    """The walls around each call, outside of which our files are."""
    asked, output = request.asked, request.output
    files = (output.ledger, output.report, *output.verdict_files())
    return choose(
        asked.isolation, tuple(asked.pass_env or ()), tuple(file for file in files if file)
    )


def _limits(bounds: Bounds, walls: Isolation) -> Limits:
    return Limits(
        bounds.call_seconds,
        bounds.call_memory << 20,
        bounds.size_limit,
        bounds.call_output << 20,
        bounds.call_processes,
        judging_bytes=bounds.memory << 20,
        isolation=walls,
    )


def _judged(
    request: VerifyRequest,
    cases: CaseList,
    chosen: Sequence[TargetEntry],
    listed: Baseline,
    limits: Limits,
) -> tuple[Run, list[Group]]:
    """All verdicts, and the findings in groups, made small."""
    bounds, ledger = request.bounds, request.output.ledger
    workers = bounds.jobs or os.cpu_count() or 1
    versions = {entry.name: entry.version for entry in chosen}
    head = {
        "targets": [[entry.name, entry.version] for entry in chosen],
        "cases": cases.head(),
        "limits": limits.document(),
    }
    book = Ledger(ledger, head) if ledger is not None else None
    names = [entry.name for entry in chosen]
    try:
        if book is not None:
            cases.spent = book.spent
        with ending_in_order(), ProgressLine(cases.count) as line, time_limit(bounds.time_limit):
            done = run(
                cases, names, ALL_TARGETS, versions, listed, limits, workers, line.show, book,
                bounds.first,
            )  # fmt: skip
            return done, shrunk_groups(done, ALL_TARGETS, limits, bounds.shrink_calls, line.say)
    finally:
        if book is not None:
            book.close()


def _notes(
    done: Run,
    groups: Sequence[Group],
    cases: CaseList,
    chosen: Sequence[TargetEntry],
    declared: Mapping[str, Declaration],
) -> list[str]:
    """The parts that were not asked, and what could not be made small."""
    names = [entry.name for entry in chosen]
    own = {name: declared[name] for name in names if ALL_TARGETS.declares_itself(name)}
    notes = [*not_asked(done, own), *resting_notes(done, names, cases.count)]
    notes += unproven_notes(done)
    notes += [
        f"{group.example.case.name.text}: shrinking it failed, which is a fault of ours: "
        f"{group.unshrunk}"
        for group in groups
        if group.unshrunk
    ]
    return notes


def _said(request: VerifyRequest) -> dict[str, Any]:
    """All options, as a command line that needs no settings file says them."""
    parts = (request.asked, request.cases, request.bounds, request.output)
    said = {name: value for part in parts for name, value in vars(part).items()}
    return {**said, "settings": None, "no_settings": request.asked.settings is not None}


def _give(
    output: Output,
    done: Run,
    groups: list[Group],
    value: dict[str, Any],
    walls: Isolation,
    accepted: str | None,
) -> None:
    """Writes the files of verdicts, all or none, and prints."""
    written: dict[Path, str | bytes] = {}
    if output.junit_file is not None:
        written[output.junit_file] = junit(done, groups, walls)
    if output.sarif_file is not None:
        written[output.sarif_file] = sarif(groups, value)
    if output.markdown_file is not None:
        written[output.markdown_file] = markdown(done, groups, value)
    if output.lines_file is not None:
        written[output.lines_file] = json_lines(value)
    if output.write_baseline is not None and accepted is not None:
        written[output.write_baseline] = accepted
    write_together(written)
    sys.stderr.write(annotation_lines(output.annotations, groups))
    if output.json:
        sys.stdout.write(as_text(value))
    elif not output.quiet:
        print_tables(done, groups, value)


def _ended(done: Run, request: VerifyRequest) -> str:
    """Says what a run has done that a signal or the time limit ended, and how to go on."""
    ledger = request.output.ledger
    name = signal.Signals(done.ended or 0).name
    if done.ended == OUT_OF_TIME:
        name = f"--time-limit {request.bounds.time_limit:g}"
    how = "a run with --ledger FILE continues where it ended"
    if ledger is not None:
        how = f"the same command continues from {ledger}"
    return f"ended by {name} after {counted(done.cases.total(), 'case')}: {how}"
