"""`minkref verify`: implementations against the exact reference, every disagreement with a
witness."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli import completion
from minkref.cli.command_line import command_line
from minkref.cli.options import Json, Schema
from minkref.cli.settings import begin_settings, is_outdone, naming_settings
from minkref.cli.target_options import (
    CallMemory,
    CallProcesses,
    CallSeconds,
    IsolationKind,
    PassedVariables,
)
from minkref.errors import refusal_text
from minkref.fuzz.isolation.isolation import AUTO, choose
from minkref.fuzz.run.catalogue import declares_itself, select
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.pool import InternalError
from minkref.fuzz.run.runner import Run, run
from minkref.fuzz.run.unasked import not_asked, resting_notes, unproven_notes
from minkref.fuzz.shrink.groups import shrunk_groups
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import JUDGING_BYTES, PROCESSES, Limits
from minkref.fuzz.verdicts.baseline import Baseline, read_baseline, unused
from minkref.output.documents import Stopwatch, as_text, check_writable, write_together
from minkref.output.exits import ExitCode
from minkref.output.output_folder import held_folder
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted
from minkref.reports.conformance.junit import junit
from minkref.reports.conformance.lines import json_lines
from minkref.reports.conformance.markdown import markdown
from minkref.reports.conformance.page import write_report
from minkref.reports.conformance.sarif import sarif
from minkref.reports.conformance.space_showcase import space_showcases, told
from minkref.verbs.verify_cases import case_list
from minkref.verbs.verify_limits import check_numbers
from minkref.verbs.verify_output import ProgressLine, document_of, print_tables

EXAMPLES = """Examples:

minkref verify

minkref verify ./my_adapter.py --seconds 60 --report build/report

minkref verify py:my_module:my_sum --junit junit.xml --sarif verify.sarif

minkref verify cgal-reduced --family holes --family comb --pairs 1000 --seed 7

minkref verify cgal-reduced --case random:1:42 --case disc1+cells1815@7/5

minkref verify clipper2 --baseline known.json --ledger run.jsonl --json

minkref verify minkref --pairs 300 --no-models"""


NOTHING_RUN: dict[str, object] = {
    "where": "minkref verify",
    "what": "nothing was run: every target skipped every case, or there was no case",
    "mend": "choose other targets or cases, or raise --pairs, --seconds or --size-limit",
}


@naming_settings
def command(
    context: typer.Context,
    targets: Annotated[
        list[str] | None,
        typer.Argument(
            help="What to test: names of `minkref targets`, a program ./PATH or cmd:COMMAND that "
            "speaks the adapter protocol, py:module:function, so:./library.so:function. "
            "`minkref`: the reference, tested by its judges; `all`: everything found here. "
            "Default: our routes and every CGAL method found.",
            metavar="TARGET...",
            autocompletion=completion.targets,
        ),
    ] = None,
    baseline: Annotated[
        Path | None,
        typer.Option(
            "--baseline", help="Known faults: shown, but without effect on the exit code."
        ),
    ] = None,
    suite: Annotated[
        str, typer.Option("--suite", help="fuzz (generated cases), corpus (case files) or all.")
    ] = "fuzz",
    corpus: Annotated[
        Path | None,
        typer.Option("--corpus", help="Folder of case files for --suite.", metavar="DIR"),
    ] = None,
    seconds: Annotated[
        float, typer.Option("--seconds", help="Time for the generated cases.", metavar="N")
    ] = 150.0,
    pairs: Annotated[
        int | None,
        typer.Option(
            "--pairs",
            help="Stop after N generated cases that a target takes, not after a time.",
            metavar="N",
        ),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the generated cases.")] = 1,
    family: Annotated[
        list[str] | None,
        typer.Option(
            "--family",
            help="Only these families (`minkref families`).",
            autocompletion=completion.families,
        ),
    ] = None,
    derived: Annotated[
        bool,
        typer.Option("--derived/--no-derived", help="Include probes at events, laws and mutants."),
    ] = True,
    jobs: Annotated[
        int | None, typer.Option("--jobs", help="Worker processes. Default: one per core.")
    ] = None,
    case: Annotated[
        list[str] | None,
        typer.Option(
            "--case",
            help="Only this case: FAMILY:SEED:INDEX, P+Q@SCALE, a case file, or the JSON of one.",
            metavar="CASE",
            is_eager=True,  # with one no settings are looked for
        ),
    ] = None,
    no_settings: Annotated[
        bool, typer.Option("--no-settings", is_eager=True, help="Read no settings file.")
    ] = False,
    settings: Annotated[
        Path | None,
        typer.Option(
            "--settings",
            help="Read options that are not given here from this file. Default: the nearest "
            "minkref.toml, or table tool.minkref of pyproject.toml, in this folder or one above.",
            metavar="FILE",
            is_eager=True,
            callback=begin_settings,
        ),
    ] = None,
    models: Annotated[
        bool, typer.Option("--models/--no-models", help="Run the models after the generated cases.")
    ] = True,
    ledger: Annotated[
        Path | None,
        typer.Option(
            "--ledger",
            help="Keep each result here as a JSON line; a later run continues from it.",
            metavar="FILE",
        ),
    ] = None,
    shrink_calls: Annotated[
        int,
        typer.Option(
            "--shrink-calls", help="Most calls to shrink a finding; 0: do not shrink.", metavar="N"
        ),
    ] = MOST_CALLS,
    report: Annotated[
        Path | None, typer.Option("--report", help="Write an HTML report there.", metavar="DIR")
    ] = None,
    junit_file: Annotated[
        Path | None,
        typer.Option("--junit", help="Write the verdicts as JUnit XML.", metavar="FILE"),
    ] = None,
    sarif_file: Annotated[
        Path | None, typer.Option("--sarif", help="Write the findings as SARIF.", metavar="FILE")
    ] = None,
    markdown_file: Annotated[
        Path | None,
        typer.Option("--markdown", help="Write the verdicts as Markdown.", metavar="FILE"),
    ] = None,
    lines_file: Annotated[
        Path | None,
        typer.Option("--lines", help="Write the findings as JSON lines.", metavar="FILE"),
    ] = None,
    first: Annotated[
        bool, typer.Option("--first", help="Stop at the first case that is wrong or broken.")
    ] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit with 4 if something stays undecided.")
    ] = False,
    call_seconds: CallSeconds = 30.0,
    call_memory: CallMemory = 4096,
    call_output: Annotated[
        int,
        typer.Option(
            "--call-output",
            help="Size limit of one answer, including what is logged meanwhile, in MiB.",
            metavar="MIB",
        ),
    ] = 64,
    call_processes: CallProcesses = PROCESSES,
    memory: Annotated[
        int,
        typer.Option(
            "--memory",
            help="Memory of a worker to make and judge a case, on top of --call-memory, in MiB.",
            metavar="MIB",
        ),
    ] = JUDGING_BYTES >> 20,
    size_limit: Annotated[
        int | None,
        typer.Option(
            "--size-limit",
            help="Slow targets skip cases with more pairs of vertices than this.",
            metavar="N",
        ),
    ] = None,
    isolation: IsolationKind = AUTO,
    pass_env: PassedVariables = None,
    quiet: Annotated[
        bool, typer.Option("--quiet", help="Print nothing; see the exit code and the files.")
    ] = False,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Test implementations against the exact reference. Cases: seeded families of generated pairs,
    small ones first, with probes at their events, laws, and mutants of those that show something
    new; then the included models, and the paper's kind of input at five scales."""
    watch = Stopwatch()
    if is_outdone(context, "pairs", by="seconds"):
        pairs = None
    sizes = (call_seconds, call_memory, call_output, size_limit, memory)
    check_numbers(seconds, pairs, jobs, *sizes, seed, call_processes)
    for file in (junit_file, sarif_file, markdown_file, lines_file):
        if file is not None:
            check_writable(file)
    listed = read_baseline(baseline) if baseline is not None else Baseline()
    files = (ledger, report, junit_file, sarif_file, markdown_file, lines_file)
    walls = choose(isolation, tuple(pass_env or ()), tuple(file for file in files if file))
    limits = Limits(
        call_seconds,
        call_memory << 20,
        size_limit,
        call_output << 20,
        call_processes,
        judging_bytes=memory << 20,
        isolation=walls,
    )
    chosen, absent = select(targets or [])
    chosen, declared = declarations_of(chosen, limits)
    cases = case_list(
        seed, pairs, seconds, case, models, family, derived, suite, corpus, declared.values()
    )
    if settings is not None:
        cases.notes.append(f"settings: {settings}")
    if any(declares_itself(entry.name) for entry in chosen):
        cases.notes.append(walls.sentence())
    if report is not None:
        context.with_resource(held_folder(report))
    workers = jobs or os.cpu_count() or 1
    names = [entry.name for entry in chosen]
    versions = {entry.name: entry.version for entry in chosen}
    head = {
        "targets": [[entry.name, entry.version] for entry in chosen],
        "cases": cases.head(),
        "limits": limits.document(),
    }
    book = Ledger(ledger, head) if ledger is not None else None
    try:
        if book is not None:
            cases.spent = book.spent
        with ending_in_order(), ProgressLine(cases.count) as line:
            done = run(cases, names, versions, listed, limits, workers, line.show, book, first)
            groups = shrunk_groups(done, limits, shrink_calls, line.say)
    finally:
        if book is not None:
            book.close()
    cases.notes += not_asked(
        done, {name: declared[name] for name in names if declares_itself(name)}
    )
    cases.notes += resting_notes(done, names, cases.count)
    cases.notes += unproven_notes(done)
    cases.notes += [
        f"{group.example.case.name.text}: shrinking it failed, which is a fault of ours: "
        f"{group.unshrunk}"
        for group in groups
        if group.unshrunk
    ]
    cases.notes += unused(listed, [finding.outcome for finding in done.findings], versions)
    code = done.exit_code(strict)
    solids = []
    if report is not None and not targets and not case and done.ended is None:
        solids = space_showcases()
        cases.notes.append(told(solids))
        if any(show.differ for show in solids):
            code = code or ExitCode.WRONG
    if done.ended is not None:
        cases.notes.append(_ended(done, ledger))
    if done.failed is not None:
        cases.notes.append("ended by a fault of ours: everything judged so far is here")
    value = document_of(done, groups, chosen, absent, declared, cases, watch, code, walls)
    if report is not None:
        said = {**locals(), "settings": None, "no_settings": settings is not None}
        again = command_line("verify", command, said)
        value["report"] = str(write_report(report, done, groups, value, limits, again, solids))
        value["seconds"] = watch.seconds()
    written: dict[Path, str | bytes] = {}
    if junit_file is not None:
        written[junit_file] = junit(done, groups, walls)
    if sarif_file is not None:
        written[sarif_file] = sarif(groups, value)
    if markdown_file is not None:
        written[markdown_file] = markdown(done, groups, value)
    if lines_file is not None:
        written[lines_file] = json_lines(value)
    write_together(written)
    if json:
        sys.stdout.write(as_text(value))
    elif not quiet:
        print_tables(done, groups, value)
    if done.failed is not None:
        raise InternalError(done.failed)
    if code == ExitCode.USAGE:
        sys.stderr.write(refusal_text(NOTHING_RUN))
    if code:
        raise typer.Exit(int(code))


def _ended(done: Run, ledger: Path | None) -> str:
    """Says what a run has done that a signal ended, and how to go on."""
    name = signal.Signals(done.ended or 0).name
    how = "a run with --ledger FILE continues where it ended"
    if ledger is not None:
        how = f"the same command continues from {ledger}"
    return f"ended by {name} after {counted(done.cases.total(), 'case')}: {how}"
