"""Sums by the paper's programs in MPFR beside CGAL's static sums: agreements, and whose fault each
difference is, by a point."""

from __future__ import annotations

import datetime
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.plane.paper_cgal import (
    AGREE,
    NEITHER,
    OURS,
    THEIRS,
    Beside,
    beside_in_plane,
    beside_in_space,
    least_bits,
    plane_answer,
)
from minkref.fuzz.libraries.paper.program_name import PREFIX, read_name
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.naming import load
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.targets.answer import Limits, Target
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.paper_targets.chosen_cases import plane_cases, space_cases
from minkref.reports.paper.judged_runs import SUMS, Judged, Row, as_text

MINUTES = Minutes(0.3, 2, 12)

CASES = Counts(24, 80, 200)
SOLIDS = Counts(8, 24, 60)
ARITHMETICS = Counts(
    ("rational", "mpfr:53", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:400", "mpfr:1000"),
)
FORMS = ("corrected", "corrected,solve=printed", "printed", "static")
IN_SPACE = ("corrected", "printed")
TITLES = {
    "corrected": "update, all corrected",
    "corrected,solve=printed": "update, the solve as printed",
    "printed": "update, all as printed",
    "static": "static program",
}
REPAIRS = {"corrected": "repair, all corrected", "printed": "repair, all as printed"}
CGAL = ("cgal-reduced", "cgal-vertical", "cgal-triangulation", "cgal-optimal")
NEF = "cgal-nef"
EXACT = (TITLES["corrected"], TITLES["static"], REPAIRS["corrected"])  # in rational numbers
BATCH = 10
Key = tuple[str, str, str]  # program, arithmetic, and the other program


@dataclass(frozen=True)
class Task:
    names: tuple[str, ...]
    arithmetics: tuple[str, ...]
    cgal: tuple[str, ...]


@dataclass
class Found:
    cases: int = 0
    beside: dict[Key, Beside] = field(default_factory=dict)
    least: dict[str, Counter[str]] = field(default_factory=dict)

    def at(self, *key: str) -> Beside:
        program, arithmetic, against = key
        return self.beside.setdefault((program, arithmetic, against), Beside())

    def add(self, other: Found) -> None:
        self.cases += other.cases
        for key, beside in other.beside.items():
            self.at(*key).add(beside)
        for program, counts in other.least.items():
            self.least.setdefault(program, Counter()).update(counts)

    def note_least(self, program: str, tried: dict[int, bool]) -> None:
        least = least_bits(tried)
        word = "no tried precision" if least is None else f"{least} bits"
        self.least.setdefault(program, Counter())[word] += 1


def examine(task: Task) -> Found:
    """All programs on some cases, as a worker process."""
    found = Found()
    targets = {name: ALL_TARGETS.target(name, Limits(seconds=20)) for name in task.cgal}
    try:
        for name in task.names:
            case = _case(name)
            if isinstance(case, Case):
                _in_plane(case, task, targets, found)
            elif isinstance(case, SpaceCase) and NEF in targets:
                _in_space(case, task, targets[NEF], found)
    finally:
        for target in targets.values():
            target.close()
    return found


def _case(name: str) -> AnyCase | None:
    """None for solids that are not convex."""
    case = load(CaseName(name, "evidence"))
    if isinstance(case, SpaceCase):
        solids = (case.pair.P, case.pair.Q)
        return case if all(is_convex(s) and not s.is_thin for s in solids) else None
    return case


def _in_plane(case: Case, task: Task, targets: dict[str, Target], found: Found) -> None:
    found.cases += 1
    theirs = {n: t.sum(case).region for n, t in targets.items() if n != NEF}
    for form in FORMS:
        right: dict[int, bool] = {}
        for arithmetic in task.arithmetics:
            name = read_name(f"{PREFIX}@{arithmetic},{form}")
            got = plane_answer(name, case)
            before = _faults(found, TITLES[form], arithmetic)
            for other, region in theirs.items():
                at = found.at(TITLES[form], arithmetic, other)
                beside_in_plane(name, case, got, region, at)
            if name.bits and arithmetic != "double":
                after = _faults(found, TITLES[form], arithmetic)
                right[name.bits] = got is not None and before == after
        if any(region is not None for region in theirs.values()):
            found.note_least(TITLES[form], right)


def _in_space(case: SpaceCase, task: Task, nef: Target, found: Found) -> None:
    found.cases += 1
    theirs = nef.sum(case).solid
    for form in IN_SPACE:
        right: dict[int, bool] = {}
        for arithmetic in task.arithmetics:
            name = read_name(f"{PREFIX}@{arithmetic},{form}")
            at = found.at(REPAIRS[form], arithmetic, NEF)
            agreed = at.counts[AGREE]
            beside_in_space(name, case, theirs, at)
            if name.bits and arithmetic != "double":
                right[name.bits] = at.counts[AGREE] > agreed
        if theirs is not None:
            found.note_least(REPAIRS[form], right)


def _faults(found: Found, program: str, arithmetic: str) -> int:
    """The differences so far that are the program's fault."""
    rows = (b for (p, a, _), b in found.beside.items() if (p, a) == (program, arithmetic))
    return sum(beside.counts[OURS] + beside.counts[NEITHER] for beside in rows)


def run(findings: Findings, size: Size) -> None:
    cgal = tuple(available_cgal(findings, *CGAL, NEF))
    names = [*plane_cases(size.of(CASES)), *space_cases(size.of(SOLIDS))]
    batches = [tuple(names[k : k + BATCH]) for k in range(0, len(names), BATCH)]
    found = Found()
    tasks = [Task(batch, size.of(ARITHMETICS), cgal) for batch in batches]
    for each in in_processes(examine, tasks, 20, "batches"):
        found.add(each)
    _judge(findings, found)
    rows = [
        Row(program, arithmetic, against, dict(beside.counts))
        for (program, arithmetic, against), beside in sorted(found.beside.items())
    ]
    least = {program: dict(counts) for program, counts in found.least.items()}
    _tell(findings, rows, least, found)
    if size is Size.FULL:
        today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
        path = ROOT / "reports" / "paper" / SUMS
        path.write_text(as_text(Judged(today, found.cases, tuple(rows), least)), encoding="utf-8")


def _judge(findings: Findings, found: Found) -> None:
    agreed = sum(beside.counts[AGREE] for beside in found.beside.values())
    findings.law("sums on which a program and CGAL agree", agreed > 0, "some", agreed)
    exact = [
        f"{program}, {against}: {beside.shown[OURS]}"
        for (program, arithmetic, against), beside in found.beside.items()
        if arithmetic == "rational" and program in EXACT and beside.counts[OURS]
    ]
    findings.none("differences from CGAL that are a fault of rational, corrected programs", exact)
    unsettled = [
        f"{program}, {arithmetic}, {against}: {beside.shown[NEITHER]}"
        for (program, arithmetic, against), beside in found.beside.items()
        if beside.counts[NEITHER]
    ]
    findings.none("differences that no point settles", unsettled)


def _tell(
    findings: Findings, rows: Sequence[Row], least: dict[str, dict[str, int]], found: Found
) -> None:
    findings.figures["cases"] = found.cases
    findings.figures["sums beside CGAL's"] = {
        f"{row.program}, {row.arithmetic}, {row.against}": row.counts for row in rows
    }
    findings.figures["right from so many bits on"] = least
    for program, counts in least.items():
        told = ", ".join(f"{count:,} from {word}" for word, count in sorted(counts.items()))
        findings.note(f"{program}: right beside CGAL in MPFR: {told.replace('from no', 'at no')}")
    for kind in (THEIRS, OURS):
        for (program, arithmetic, against), beside in sorted(found.beside.items()):
            if kind in beside.shown and (kind is THEIRS or program in EXACT):
                told = f"{beside.counts[kind]:,}, the first {beside.shown[kind]}"
                findings.note(f"{program}, {arithmetic}, beside {against}: {kind}: {told[:300]}")
