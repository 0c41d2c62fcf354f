"""The tally of the paper's programs beside CGAL, shared by the steps in the plane and in space."""

from __future__ import annotations

import datetime
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from minkref.fuzz.judges.beside import AGREE, NEITHER, OURS, THEIRS, Beside, least_bits
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.paper.judged_runs import Judged, Row, as_text

ARITHMETICS = Counts(
    ("rational", "mpfr:53", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200"),
    ("rational", "double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:400", "mpfr:1000"),
)
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

    def count(self, program: str, arithmetic: str, *kinds: str) -> int:
        """Counts comparisons by kind, beside all other programs."""
        rows = (b for (p, a, _), b in self.beside.items() if (p, a) == (program, arithmetic))
        return sum(beside.counts[kind] for beside in rows for kind in kinds)

    def note_least(self, program: str, tried: dict[int, bool]) -> None:
        least = least_bits(tried)
        word = "no tried precision" if least is None else f"{least} bits"
        self.least.setdefault(program, Counter())[word] += 1


def tally(
    findings: Findings,
    size: Size,
    names: Sequence[str],
    cgal: tuple[str, ...],
    examine: Callable[[Task], Found],
    exact: Sequence[str],
    file: str,
) -> None:
    """Compares on all cases and fills the findings; a full run keeps its rows for `report paper`.
    `exact`: programs claimed right in rational numbers."""
    batches = [tuple(names[k : k + BATCH]) for k in range(0, len(names), BATCH)]
    found = Found()
    tasks = [Task(batch, size.of(ARITHMETICS), cgal) for batch in batches]
    for each in in_processes(examine, tasks, 20, "batches"):
        found.add(each)
    _judge(findings, found, exact)
    rows = [
        Row(program, arithmetic, against, dict(beside.counts))
        for (program, arithmetic, against), beside in sorted(found.beside.items())
    ]
    least = {program: dict(counts) for program, counts in found.least.items()}
    _tell(findings, rows, least, found, exact)
    if size is Size.FULL:
        today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
        path = ROOT / "reports" / "paper" / file
        path.write_text(as_text(Judged(today, found.cases, tuple(rows), least)), encoding="utf-8")


def _judge(findings: Findings, found: Found, exact: Sequence[str]) -> None:
    agreed = sum(beside.counts[AGREE] for beside in found.beside.values())
    findings.law("sums on which a program and CGAL agree", agreed > 0, "some", agreed)
    wrong = [
        f"{program}, {against}: {beside.shown[OURS]}"
        for (program, arithmetic, against), beside in found.beside.items()
        if arithmetic == "rational" and program in exact and beside.counts[OURS]
    ]
    findings.none("differences from CGAL that are a fault of rational, corrected programs", wrong)
    unsettled = [
        f"{program}, {arithmetic}, {against}: {beside.shown[NEITHER]}"
        for (program, arithmetic, against), beside in found.beside.items()
        if beside.counts[NEITHER]
    ]
    findings.none("differences that no point settles", unsettled)


def _tell(
    findings: Findings,
    rows: Sequence[Row],
    least: dict[str, dict[str, int]],
    found: Found,
    exact: Sequence[str],
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
            if kind in beside.shown and (kind is THEIRS or program in exact):
                told = f"{beside.counts[kind]:,}, the first {beside.shown[kind]}"
                findings.note(f"{program}, {arithmetic}, beside {against}: {kind}: {told[:300]}")
