"""The request of `minkref verify`: what is asked of whom, the cases, the limits, and what comes
out."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli import completion
from minkref.cli.options import Json
from minkref.cli.settings import begin_settings
from minkref.cli.target_options import (
    CallMemory,
    CallProcesses,
    CallSeconds,
    IsolationKind,
    PassedVariables,
)
from minkref.fuzz.isolation.isolation import AUTO
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import JUDGING_BYTES, PROCESSES
from minkref.reports.conformance.annotation_kinds import AUTO as WHERE_IT_RUNS

TargetNames = Annotated[
    list[str] | None,
    typer.Argument(
        help="What to test: names of `minkref targets`, a program ./PATH or cmd:COMMAND that "
        "speaks the adapter protocol, py:module:function, so:./library.so:function. "
        "`minkref`: the reference, tested by its judges; `all`: everything found here. "
        "Default: our routes and every CGAL method found.",
        metavar="TARGET...",
        autocompletion=completion.targets,
    ),
]
BaselineFile = Annotated[
    Path | None,
    typer.Option("--baseline", help="Known faults: shown, but without effect on the exit code."),
]
WriteBaseline = Annotated[
    Path | None,
    typer.Option(
        "--write-baseline",
        help="Accept the faults of this run: write them to a baseline, after the entries of "
        "--baseline, and exit with 0.",
        metavar="FILE",
    ),
]
Suite = Annotated[
    str, typer.Option("--suite", help="fuzz (generated cases), corpus (case files) or all.")
]
CorpusFolder = Annotated[
    Path | None, typer.Option("--corpus", help="Folder of case files for --suite.", metavar="DIR")
]
Seconds = Annotated[
    float, typer.Option("--seconds", help="Time for the generated cases.", metavar="N")
]
Pairs = Annotated[
    int | None,
    typer.Option(
        "--pairs",
        help="Stop after N generated cases that a target takes, not after a time.",
        metavar="N",
    ),
]
Seed = Annotated[int, typer.Option("--seed", help="Seed of the generated cases.")]
Family = Annotated[
    list[str] | None,
    typer.Option(
        "--family",
        help="Only these families (`minkref families`).",
        autocompletion=completion.families,
    ),
]
Derived = Annotated[
    bool, typer.Option("--derived/--no-derived", help="Include probes at events, laws and mutants.")
]
Jobs = Annotated[
    int | None, typer.Option("--jobs", help="Worker processes. Default: one per core.")
]
OneCase = Annotated[
    list[str] | None,
    typer.Option(
        "--case",
        help="Only this case: FAMILY:SEED:INDEX, P+Q@SCALE, a case file, or the JSON of one.",
        metavar="CASE",
        is_eager=True,  # with one no settings are looked for
    ),
]
NoSettings = Annotated[
    bool, typer.Option("--no-settings", is_eager=True, help="Read no settings file.")
]
SettingsFile = Annotated[
    Path | None,
    typer.Option(
        "--settings",
        help="Read options that are not given here from this file. Default: the nearest "
        "minkref.toml, or table tool.minkref of pyproject.toml, in this folder or one above.",
        metavar="FILE",
        is_eager=True,
        callback=begin_settings,
    ),
]
Models = Annotated[
    bool, typer.Option("--models/--no-models", help="Run the models after the generated cases.")
]
LedgerFile = Annotated[
    Path | None,
    typer.Option(
        "--ledger",
        help="Keep each result here as a JSON line; a later run continues from it.",
        metavar="FILE",
    ),
]
TimeLimit = Annotated[
    float | None,
    typer.Option(
        "--time-limit",
        help="End the whole run after this time, in seconds: cases, models and shrinking. What "
        "is judged by then counts.",
        metavar="N",
    ),
]
ShrinkCalls = Annotated[
    int,
    typer.Option(
        "--shrink-calls", help="Most calls to shrink a finding; 0: do not shrink.", metavar="N"
    ),
]
ReportFolder = Annotated[
    Path | None, typer.Option("--report", help="Write an HTML report there.", metavar="DIR")
]
Junit = Annotated[
    Path | None, typer.Option("--junit", help="Write the verdicts as JUnit XML.", metavar="FILE")
]
Sarif = Annotated[
    Path | None, typer.Option("--sarif", help="Write the findings as SARIF.", metavar="FILE")
]
MarkdownFile = Annotated[
    Path | None, typer.Option("--markdown", help="Write the verdicts as Markdown.", metavar="FILE")
]
LinesFile = Annotated[
    Path | None, typer.Option("--lines", help="Write the findings as JSON lines.", metavar="FILE")
]
Annotations = Annotated[
    str,
    typer.Option(
        "--annotations",
        help="Mark findings on the page of the run: github, none, or auto: github where "
        "GITHUB_ACTIONS is true. They go to standard error.",
        metavar="KIND",
    ),
]
First = Annotated[
    bool, typer.Option("--first", help="Stop at the first case that is wrong or broken.")
]
Strict = Annotated[
    bool, typer.Option("--strict", help="Exit with 4 if something stays undecided or is given up.")
]
CallOutput = Annotated[
    int,
    typer.Option(
        "--call-output",
        help="Size limit of one answer, including what is logged meanwhile, in MiB.",
        metavar="MIB",
    ),
]
JudgingMemory = Annotated[
    int,
    typer.Option(
        "--memory",
        help="Memory of a worker to make and judge a case, on top of --call-memory, in MiB.",
        metavar="MIB",
    ),
]
SizeLimit = Annotated[
    int | None,
    typer.Option(
        "--size-limit",
        help="Slow targets skip cases with more pairs of vertices than this.",
        metavar="N",
    ),
]
Quiet = Annotated[
    bool, typer.Option("--quiet", help="Print nothing; see the exit code and the files.")
]


@dataclass(frozen=True)
class Asked:
    """The targets to ask, and known facts about them."""

    targets: TargetNames = None
    baseline: BaselineFile = None
    no_settings: NoSettings = False
    settings: SettingsFile = None
    isolation: IsolationKind = AUTO
    pass_env: PassedVariables = None


@dataclass(frozen=True)
class Cases:
    """What they are asked."""

    suite: Suite = "fuzz"
    corpus: CorpusFolder = None
    seconds: Seconds = 150.0
    pairs: Pairs = None
    seed: Seed = 1
    family: Family = None
    derived: Derived = True
    case: OneCase = None
    models: Models = True


@dataclass(frozen=True)
class Bounds:
    """How much it may take. Memory and output in MiB."""

    jobs: Jobs = None
    time_limit: TimeLimit = None
    shrink_calls: ShrinkCalls = MOST_CALLS
    first: First = False
    call_seconds: CallSeconds = 30.0
    call_memory: CallMemory = 4096
    call_output: CallOutput = 64
    call_processes: CallProcesses = PROCESSES
    memory: JudgingMemory = JUDGING_BYTES >> 20
    size_limit: SizeLimit = None


@dataclass(frozen=True)
class Output:
    """The files to write and the text to print."""

    ledger: LedgerFile = None
    report: ReportFolder = None
    junit_file: Junit = None
    sarif_file: Sarif = None
    markdown_file: MarkdownFile = None
    lines_file: LinesFile = None
    write_baseline: WriteBaseline = None
    annotations: Annotations = WHERE_IT_RUNS
    strict: Strict = False
    quiet: Quiet = False
    json: Json = False

    def verdict_files(self) -> list[Path]:
        """Files written together, at the end."""
        files = (
            self.junit_file, self.sarif_file, self.markdown_file, self.lines_file,
            self.write_baseline,
        )  # fmt: skip
        return [file for file in files if file is not None]


@dataclass(frozen=True)
class VerifyRequest:
    asked: Asked
    cases: Cases
    bounds: Bounds
    output: Output


#: As the help lists them.
ORDER = (
    "targets", "baseline", "write_baseline", "suite", "corpus", "seconds", "pairs", "time_limit",
    "seed", "family", "derived", "jobs", "case", "no_settings", "settings", "models", "ledger",
    "shrink_calls", "report", "junit_file", "sarif_file", "markdown_file", "lines_file",
    "annotations", "first", "strict", "call_seconds",
    "call_memory", "call_output", "call_processes", "memory", "size_limit", "isolation",
    "pass_env", "quiet", "json",
)  # fmt: skip
