"""The critical scales that the paper's program lists in MPFR, beside computer algebra's: missed,
invented and misplaced ones, by precision and formula."""

from __future__ import annotations

import datetime
from collections import Counter
from dataclasses import dataclass, field

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.beside import least_bits
from minkref.fuzz.judges.plane.paper_algebra import (
    GENERAL,
    INVENTED,
    MISPLACED,
    MISSED,
    RIGHT,
    UNDECIDED,
    Algebra,
    by_algebra,
    compared,
    listed,
)
from minkref.fuzz.libraries.paper.program_name import PREFIX, ProgramName, read_name
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.naming import load
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.paper_targets.chosen_cases import plane_cases
from minkref.reports.paper.judged_runs import EVENTS, Judged, Row, as_text

MINUTES = Minutes(0.2, 0.6, 2)

CASES = Counts(40, 160, 400)
MOST_EDGES = Counts(30, 60, 90)
ARITHMETICS = Counts(
    ("rational", "mpfr:53", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:400", "mpfr:1000"),
)
ALL_CORRECTED = "all corrected"
FORMULAS = {
    ALL_CORRECTED: "corrected",
    "Observation 1 as printed": "corrected,observation=printed",
    "the solve as printed": "corrected,solve=printed",
    "the interval as printed": "corrected,interval=printed",
    "no parallel edges": "corrected,parallel=left-out",
    "all as printed": "printed",
}
ALGEBRA = "computer algebra"
BATCH = 20


@dataclass(frozen=True)
class Task:
    names: tuple[str, ...]
    arithmetics: tuple[str, ...]
    most_edges: int


@dataclass
class Found:
    """Event counts by program and arithmetic; `wrong`: faults of the all-corrected program in
    rational numbers."""

    cases: int = 0
    events: int = 0
    counts: dict[tuple[str, str], Counter[str]] = field(default_factory=dict)
    least: dict[str, Counter[str]] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)

    def add(self, other: Found) -> None:
        self.cases += other.cases
        self.events += other.events
        self.wrong += other.wrong
        for key, counts in other.counts.items():
            self.counts.setdefault(key, Counter()).update(counts)
        for program, counts in other.least.items():
            self.least.setdefault(program, Counter()).update(counts)


def examine(task: Task) -> Found:
    found = Found()
    for text in task.names:
        case = load(CaseName(text, "evidence"))
        if not isinstance(case, Case) or not (case.P.is_region and case.Q.is_region):
            continue
        if case.vertex_pairs > task.most_edges**2:  # too many edges
            continue
        truth = by_algebra(case.P, case.Q, task.most_edges)
        if truth is None:
            continue
        found.cases += 1
        found.events += len(truth.scales)
        _follow(case, truth, task, found)
    return found


def _follow(case: Case, truth: Algebra, task: Task, found: Found) -> None:
    for program, form in FORMULAS.items():
        right: dict[int, bool] = {}
        for arithmetic in task.arithmetics:
            name = read_name(f"{PREFIX}@{arithmetic},{form}")
            counts = _counts(case, truth, name)
            found.counts.setdefault((program, arithmetic), Counter()).update(counts)
            faultless = counts[RIGHT] == len(truth.scales) and not counts[INVENTED]
            if name.bits and arithmetic != "double":
                right[name.bits] = faultless
            if arithmetic == "rational" and program == ALL_CORRECTED and not faultless:
                found.wrong.append(f"{case.name.text}: {dict(counts)}")
        least = least_bits(right)
        word = "no tried precision" if least is None else f"{least} bits"
        found.least.setdefault(program, Counter())[word] += 1


def _counts(case: Case, truth: Algebra, name: ProgramName) -> Counter[str]:
    try:
        return compared(truth, listed(case.P, case.Q, name), name.relative)
    except _core.UndecidedSign:
        return Counter({UNDECIDED: len(truth.scales)})


def run(findings: Findings, size: Size) -> None:
    names = plane_cases(size.of(CASES))
    batches = [tuple(names[k : k + BATCH]) for k in range(0, len(names), BATCH)]
    found = Found()
    tasks = [Task(batch, size.of(ARITHMETICS), size.of(MOST_EDGES)) for batch in batches]
    for each in in_processes(examine, tasks, 20, "batches"):
        found.add(each)
    findings.law("events by computer algebra", found.events > 0, "some", found.events)
    findings.none(
        "all corrected, rational: cases whose events are not computer algebra's", found.wrong
    )
    finest = size.of(ARITHMETICS)[-1]
    general = found.counts.get((ALL_CORRECTED, finest), Counter())[GENERAL]
    findings.target(
        f"all corrected, {finest}: wrong events of pairs in general position",
        not general,
        0,
        general,
    )
    rows = [
        Row(program, arithmetic, ALGEBRA, dict(counts))
        for (program, arithmetic), counts in found.counts.items()
    ]
    least = {program: dict(counts) for program, counts in found.least.items()}
    findings.figures["cases"] = found.cases
    findings.figures["events"] = found.events
    findings.figures["events beside computer algebra's"] = {
        f"{row.program}, {row.arithmetic}": row.counts for row in rows
    }
    findings.figures["all events right from so many bits on"] = least
    for row in rows:
        told = ", ".join(
            f"{row.counts.get(kind, 0):,} {kind}"
            for kind in (MISSED, INVENTED, MISPLACED, UNDECIDED, GENERAL)
            if row.counts.get(kind, 0)
        )
        findings.note(f"{row.program}, {row.arithmetic}: {told or 'nothing wrong'}")
    if size is Size.FULL:
        today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
        path = ROOT / "reports" / "paper" / EVENTS
        path.write_text(as_text(Judged(today, found.cases, tuple(rows), least)), encoding="utf-8")
