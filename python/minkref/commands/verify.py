"""`minkref verify`: implementations against the exact reference, every disagreement with a
witness."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

import typer

from minkref.commands.verify_output import ProgressLine, document_of, print_tables
from minkref.documents import Stopwatch, as_text, check_writable, write_atomically
from minkref.errors import Refusal, refusal_text
from minkref.exits import ExitCode
from minkref.fuzz.cases.case import CaseName
from minkref.fuzz.cases.case_list import CaseList
from minkref.fuzz.run.runner import run
from minkref.fuzz.run.worker import load_limit
from minkref.fuzz.targets.catalogue import Limits, select
from minkref.fuzz.verdicts.baseline import Baseline, read_baseline
from minkref.options import Json, Schema
from minkref.reports.conformance.junit import junit
from minkref.reports.conformance.page import write_report
from minkref.signals import ending_in_order

MOST_JOBS = 1024
MOST_MEMORY = 1 << 24  # MiB

EXAMPLES = """Examples:

minkref verify

minkref verify cgal-reduced --pairs 1000 --seed 7 --report build/report

minkref verify --baseline fuzz/baseline.json --seconds 60 --json

minkref verify cgal-reduced --case random:1:42 --case disc1+cells1815@7/5

minkref verify py:my_module:my_sum --junit junit.xml"""


NOTHING_RUN: dict[str, object] = {
    "where": "minkref verify",
    "what": "nothing was run: every target skipped every case, or there was no case",
    "mend": "choose other targets or cases, or raise --pairs, --seconds or --size-limit",
}


def command(
    targets: Annotated[
        list[str] | None,
        typer.Argument(
            help="What to test: names of `minkref targets`, or py:module:function; "
            "all that are found by default.",
            metavar="TARGET...",
        ),
    ] = None,
    baseline: Annotated[
        Path | None, typer.Option("--baseline", help="Known faults: shown, without effect.")
    ] = None,
    seconds: Annotated[
        float, typer.Option("--seconds", help="Time for the random pairs.", metavar="N")
    ] = 150.0,
    pairs: Annotated[
        int | None,
        typer.Option("--pairs", help="Number of random pairs, instead of a time.", metavar="N"),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the random pairs.")] = 1,
    jobs: Annotated[
        int | None, typer.Option("--jobs", help="Worker processes; one for each core by default.")
    ] = None,
    case: Annotated[
        list[str] | None,
        typer.Option(
            "--case", help="Only this case: random:SEED:INDEX or P+Q@SCALE.", metavar="CASE"
        ),
    ] = None,
    models: Annotated[
        bool, typer.Option("--models/--no-models", help="After the random pairs, the models.")
    ] = True,
    report: Annotated[
        Path | None, typer.Option("--report", help="Write an HTML report there.", metavar="DIR")
    ] = None,
    junit_file: Annotated[
        Path | None,
        typer.Option("--junit", help="Write the verdicts as JUnit XML.", metavar="FILE"),
    ] = None,
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit with 4 where something stays undecided.")
    ] = False,
    call_seconds: Annotated[
        float, typer.Option("--call-seconds", help="Time limit of one call of one target.")
    ] = 30.0,
    call_memory: Annotated[
        int, typer.Option("--call-memory", help="Memory limit of one call, in MiB.", metavar="MIB")
    ] = 4096,
    size_limit: Annotated[
        int | None,
        typer.Option(
            "--size-limit",
            help="Slow targets skip cases with more pairs of vertices than this.",
            metavar="N",
        ),
    ] = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Test implementations against the exact reference. Cases: seeded random pairs of polygons with
    holes, small ones first; the shipped models; the paper's kind of input at five scales."""
    watch = Stopwatch()
    _check(seconds, pairs, jobs, call_seconds, call_memory, size_limit)
    if junit_file is not None:
        check_writable(junit_file)
    if report is not None:
        _make_folder(report)
    listed = read_baseline(baseline) if baseline is not None else Baseline()
    limits = Limits(call_seconds, call_memory << 20, size_limit)
    chosen, absent = select(targets or [], load_limit(limits))
    for text in case or []:
        CaseName(text, "named").load()
    cases = CaseList(seed, pairs, seconds, tuple(case or ()), models)
    workers = jobs or os.cpu_count() or 1
    names = [entry.name for entry in chosen]
    versions = {entry.name: entry.version for entry in chosen}
    with ending_in_order(), ProgressLine(cases.count) as line:
        done = run(cases, names, versions, listed, limits, workers, line.show)
    code = done.exit_code(strict)
    value = document_of(done, chosen, absent, cases, watch, code)
    if report is not None:
        value["report"] = str(write_report(report, done, value))
        value["seconds"] = watch.seconds()
    if junit_file is not None:
        write_atomically(junit_file, junit(done))
    if json:
        sys.stdout.write(as_text(value))
    else:
        print_tables(done, value)
    if code is ExitCode.USAGE:
        sys.stderr.write(refusal_text(NOTHING_RUN))
    if code:
        raise typer.Exit(int(code))


def _check(
    seconds: float,
    pairs: int | None,
    jobs: int | None,
    call_seconds: float,
    call_memory: int,
    size_limit: int | None,
) -> None:
    for option, value, least, most in (
        ("--seconds", seconds, 0, None),
        ("--pairs", pairs, 0, None),
        ("--jobs", jobs, 1, MOST_JOBS),
        ("--call-memory", call_memory, 16, MOST_MEMORY),
        ("--size-limit", size_limit, 1, None),
    ):
        if value is not None and not value >= least:
            raise Refusal(f"{value} is too small", option, f"give at least {least}")
        if value is not None and most is not None and value > most:
            raise Refusal(f"{value} is too large", option, f"give at most {most}")
    if not 0 < call_seconds <= 86_400:
        raise Refusal(
            f"{call_seconds} is out of range", "--call-seconds", "give 0 to 86400 seconds"
        )


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise Refusal(
            "this is a file, and the report needs a folder",
            str(folder),
            "name a folder that exists or is to be made",
        ) from error
    except OSError as error:
        raise Refusal(
            f"the folder cannot be made: {error.strerror}", str(folder), "choose another place"
        ) from error
