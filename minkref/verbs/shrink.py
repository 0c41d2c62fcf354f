"""`minkref shrink`: the smallest case that still shows a fault."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json
from minkref.cli.output import give
from minkref.cli.target_options import (
    CallMemory,
    CallProcesses,
    CallSeconds,
    IsolationKind,
    PassedVariables,
    walls_and_limits,
)
from minkref.cli.verb import Verb, command_anywhere
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.isolation import AUTO
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.shrink.asker import Asker
from minkref.fuzz.shrink.case_file import case_text, has_case_file
from minkref.fuzz.shrink.finding import SmallFinding, shrink_finding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import PROCESSES
from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.output.documents import Stopwatch, document
from minkref.output.exits import ExitCode
from minkref.output.output_target import target_of
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, counted, escaped
from minkref.reports.conformance.run_words import witness_text
from minkref.verbs.verify_cases import refuse_unless_case
from minkref.verbs.verify_output import shrunk_document

EXAMPLES = """Examples:

minkref shrink random:1:42 --target cgal-reduced

minkref shrink case.json --target ./my_adapter.py -o small.json

minkref shrink monkey+bird@7/5 --target py:my_module:my_sum --json"""


TOLD = """\
Make a case smaller as long as the target shows the same fault on it: the verdict, its
reasons and the signal. Exact and deterministic: fewer rings and vertices, smaller numbers,
scale 1. Exits with 1 if the target is proven wrong on this case, 3 if it breaks, and 2 if
neither."""

OneCase = Annotated[
    str,
    typer.Argument(
        help="As for verify --case: FAMILY:SEED:INDEX, P+Q@SCALE, a case file, or the JSON of one.",
        metavar="CASE",
    ),
]
TargetName = Annotated[
    str, typer.Option("--target", help="The target that shows the fault, as for verify.")
]
Output = Annotated[
    Path | None,
    typer.Option("-o", "--output", help="Write a case file; - is standard output.", metavar="FILE"),
]
Calls = Annotated[int, typer.Option("--calls", help="At most N calls of the target.", metavar="N")]


@dataclass(frozen=True)
class Shrink:
    case: OneCase
    target: TargetName
    output: Output = None
    calls: Calls = MOST_CALLS
    call_seconds: CallSeconds = 30.0
    call_memory: CallMemory = 4096
    call_processes: CallProcesses = PROCESSES
    isolation: IsolationKind = AUTO
    pass_env: PassedVariables = None
    json: Json = False


command = command_anywhere(TOLD, Verb(Shrink, "minkref.verbs.shrink:run"))


def run(request: Shrink) -> None:
    watch = Stopwatch()
    case, output = request.case, request.output
    walls, limits = walls_and_limits(
        request.call_seconds,
        request.call_memory,
        request.call_processes,
        request.isolation,
        request.pass_env,
    )
    written = None if output is None else target_of(output, None, ("json",), "json", request.json)
    refuse_unless_case(case)
    (entry,), _ = declarations_of([ALL_TARGETS.select_one(request.target)], ALL_TARGETS, limits)
    with ending_in_order():
        with Asker(entry.name, ALL_TARGETS, limits) as asker:
            result, outcome = asker.ask(CaseName(case, "shrinking").text)
        if outcome is None or outcome.verdict in (*GOOD, Verdict.SKIPPED, Verdict.UNDECIDED):
            said = "is not run on it" if outcome is None else f"says: {outcome.verdict}"
            raise Refusal(
                f"the target shows no fault on this case; it {said}",
                f"{entry.name} on {case[:80]}",
                "name a case that `minkref verify` found",
            )
        found = Finding(outcome, result)
        small = shrink_finding(found, ALL_TARGETS, limits, request.calls)
    if small is None:
        raise Refusal(
            "the fault did not occur again, or the case is not in the plane",
            f"{entry.name} on {case[:80]}",
            "run it again: a target whose answers vary cannot be shrunk",
        )
    if output is not None and not has_case_file(small):
        raise Refusal(
            "case files are of sums, in space of convex polyhedra: this case has none",
            str(output),
            "leave out -o: the case is printed as JSON",
        )
    code = int(ExitCode.WRONG if outcome.verdict is Verdict.WRONG else ExitCode.BROKEN)
    if written is not None and written.write(case_text(small, entry.name)):
        raise typer.Exit(code)
    value = document(
        "shrink",
        watch,
        target=entry.name,
        shrunk=shrunk_document(Group(found, 1), small, {entry.name: entry.version}),
        output=str(output) if output else None,
        isolation=walls.document(),
    )
    give(value, request.json, lambda value: _print(small, found, value))
    raise typer.Exit(code)


def _print(small: SmallFinding, found: Finding, value: dict[str, Any]) -> None:
    out = console()
    outcome = small.outcome
    kinds = ", ".join(outcome.kinds)
    before, after = found.case.size[0], small.result.size[0]
    out.print(escaped(f"{outcome.target} {outcome.verdict}: {kinds}"))
    out.print(f"{before} vertices before, {after} now; {counted(small.calls, 'call')}")
    if not small.complete:
        out.print("the calls ran out: --calls allows more")
    if not small.stable:
        out.print("asked again, the target did not show the fault: it does not answer alike")
    if outcome.witness is not None:
        out.print(escaped(witness_text(outcome.witness, small.result.scale)), soft_wrap=True)
    out.print(escaped(Finding(outcome, small.result).reproduce), soft_wrap=True)
    if value["output"]:
        out.print(escaped(f"written: {value['output']}"), soft_wrap=True)
