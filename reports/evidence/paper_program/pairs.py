"""The paper's program from Section 4, followed literally in several arithmetics: how often the sum
is right, and which formula to blame."""

from __future__ import annotations

import datetime
import time
from collections import Counter
from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.judges.plane.rounded_sums import compare, significant_bits
from minkref.reports.bench.pairs import Pair, pairs
from minkref.reports.bench.rescalings import rescalings
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.paper.program_runs import CORRECTED as ALL_CORRECTED
from minkref.reports.paper.program_runs import FILE, Run, Runs, as_text, committed

MINUTES = Minutes(0.2, 1.5, 30)

SEED = 1
AFTER = (1, 10, 100)  # re-scalings
ROUNDING = ("double", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:1000")
FEW = ("double", "mpfr:200")  # for pairs with many edges, and programs that invent events
LARGE = ("double", "mpfr:53", "mpfr:200")  # of the solve as printed on large pairs
MANY = 60_000  # pairs of edges
MOST = 600_000
HUGE = 60_000_000
MOST_PAIRS = Counts(8_000, 20_000, HUGE)  # of edges
TOO_MANY = 10  # more than so many times the true intersections: skips the sum, which would differ
CORRECTED = {name: corrected for name, _, corrected, _ in _core.paper_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.paper_readings()}
VARIANTS = {
    ALL_CORRECTED: CORRECTED,
    **{
        f"{name} as printed": CORRECTED | {name: PRINTED[name]}
        for name in CORRECTED
        if PRINTED[name] != CORRECTED[name]
    },
    "solve within a tolerance": CORRECTED | {"solve": "tolerance:1e-9"},
    "solve by least squares": CORRECTED | {"solve": "least-squares"},
    "all as printed": PRINTED,
}


SOLVE = "solve as printed"


@dataclass(frozen=True)
class Task:
    """`intersections`: the true count after each number in AFTER."""

    pair: Pair
    arithmetic: str
    variant: str
    intersections: tuple[int, ...]


@dataclass(frozen=True)
class Row:
    run: Run
    same: tuple[bool, ...]  # after each number in AFTER, exactly the same set of points


def follow(task: Task) -> Row:
    P, Q = task.pair.P.set, task.pair.Q.set
    scales = rescalings(SEED, AFTER[-1])
    since = time.process_time()
    program = _core.PaperUpdate(P, Q, "1", task.arithmetic, VARIANTS[task.variant])
    seconds = time.process_time() - since
    bits = significant_bits(task.arithmetic)
    right, same, most = [], [], 0.0
    there = dict(zip(AFTER, task.intersections, strict=True))
    for number, scale in enumerate(scales, start=1):
        step = program.move_to(scale)
        if number not in there:
            continue
        if step["updated"] > TOO_MANY * (there[number] + 100):
            right.append(False)
            same.append(False)
            continue
        found = compare(P, Q, scale, program.sum(), bits)
        right.append(found.same_structure)
        same.append(found.ulps == 0)
        most = max(most, float(found.ulps or 0))
    pairs = int(program.counts()["pairs"])
    run = Run(task.pair.name, task.arithmetic, task.variant, tuple(right), most, pairs, seconds)
    return Row(run, tuple(same))


def intersections(pair: Pair, arithmetic: str) -> tuple[int, ...]:
    scales = rescalings(SEED, AFTER[-1])
    exact = _core.PaperUpdate(pair.P.set, pair.Q.set, "1", arithmetic, CORRECTED)
    return tuple(exact.move_to(scales[number - 1])["updated"] for number in AFTER)


def pairs_of_edges(pair: Pair) -> int:
    edges = len(_core.reduced_convolution(pair.P.set, pair.Q.set))
    return edges * (edges - 1) // 2


def tasks(chosen: list[Pair], size: Size) -> tuple[list[Task], list[str]]:
    """Tasks and notes, the longest tasks first."""
    found, notes = [], []
    for pair in chosen:
        count = pairs_of_edges(pair)
        there = intersections(pair, "double" if count > MOST else "rational")
        plan = _plan(count, size)
        found += [(count, Task(pair, a, v, there)) for v, names in plan.items() for a in names]
        if count > MOST:
            notes.append(f"{pair.name}, {count:,} pairs of edges: " + "; ".join(
                f"{variant} in {', '.join(names)}" for variant, names in plan.items()))  # fmt: skip
    return [task for _, task in sorted(found, key=lambda one: -one[0])], notes


def _plan(count: int, size: Size) -> dict[str, tuple[str, ...]]:
    """The arithmetics for each program, given so many pairs of edges."""
    if count > HUGE:  # the printed solve leaves too many regions for memory
        return {ALL_CORRECTED: tuple(reversed(ROUNDING))}
    if count > MOST:
        return {ALL_CORRECTED: ROUNDING, SOLVE: LARGE}
    few = ("rational", *(FEW if size is not Size.FULL or count > MANY else ROUNDING))
    return dict.fromkeys(VARIANTS, few) | (
        {}
        if size is not Size.FULL
        else dict.fromkeys((ALL_CORRECTED, SOLVE), ("rational", *ROUNDING))
    )


def run(findings: Findings, size: Size) -> None:
    every, notes = pairs(size is Size.QUICK)
    most = size.of(MOST_PAIRS)
    follow_all([pair for pair in every if pairs_of_edges(pair) <= most], notes, findings, size)


def follow_all(every: list[Pair], notes: list[str], findings: Findings, size: Size) -> None:
    """Runs all pairs. `notes` name models that look-alikes replace."""
    chosen, more = tasks(every, size)
    for note in (*notes, *more):
        findings.note(note)
    rows = []
    for row in in_processes(follow, chosen):
        rows.append(row)
        print(row, flush=True)
    runs = [row.run for row in rows]
    exact = [row for row in rows if row.run.arithmetic == "rational"]
    if exact:
        in_rational_numbers(exact, findings)
    findings.figures["right after 1, 10 and 100 re-scalings"] = _table(runs)
    right = [run for run in runs if run.variant == ALL_CORRECTED]
    findings.figures["largest distance in ulps where the structure is right"] = {
        arithmetic: max((r.most_ulps for r in right if r.arithmetic == arithmetic), default=0.0)
        for arithmetic in ROUNDING
    }
    findings.figures["microseconds of processor time for a pair of edges, all corrected"] = {
        arithmetic: _microseconds([r for r in right if r.arithmetic == arithmetic])
        for arithmetic in ("rational", *ROUNDING)
    }
    for variant, shares in findings.figures["right after 1, 10 and 100 re-scalings"].items():
        told = "; ".join(f"{arithmetic} {share}" for arithmetic, share in shares.items())
        if told:
            findings.note(f"{variant}: right after 1, 10 and 100 re-scalings: {told}")
    times = findings.figures["microseconds of processor time for a pair of edges, all corrected"]
    findings.note("microseconds for a pair of edges, all corrected: " + ", ".join(
        f"{arithmetic} {time}" for arithmetic, time in times.items()))  # fmt: skip
    if size is Size.FULL:
        path = ROOT / "reports" / "paper" / FILE
        path.write_text(_renewed(runs, not notes), encoding="utf-8")


def in_rational_numbers(rows: list[Row], findings: Findings) -> None:
    wrong = [row.run.name for row in rows
             if row.run.variant == ALL_CORRECTED and not all(row.same)]  # fmt: skip
    findings.none("all corrected, rational: sums that are not the exact ones", wrong)
    harmless = (SOLVE, "solve by least squares")
    wrong = [f"{row.run.name}: {row.run.variant}" for row in rows
             if row.run.variant in harmless and not all(row.same)]  # fmt: skip
    findings.none("the solve alone as printed, rational: sums that are not the exact ones", wrong)


def _renewed(runs: list[Run], paper_models: bool) -> str:
    """The committed runs, with new runs replacing older runs of the same pairs."""
    names = {run.name for run in runs}
    others = [run for run in committed().runs if run.name not in names]
    today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    return as_text(Runs(today, paper_models, AFTER, tuple(VARIANTS), (*runs, *others)))


def _microseconds(runs: list[Run]) -> float:
    pairs = sum(run.pairs for run in runs)
    return round(1e6 * sum(run.seconds for run in runs) / pairs, 2) if pairs else 0.0


def _table(rows: list[Run]) -> dict[str, dict[str, str]]:
    """For each program and arithmetic the share of pairs with the right structure."""
    right: Counter[tuple[str, str, int]] = Counter()
    asked: Counter[tuple[str, str]] = Counter()
    for row in rows:
        asked[row.variant, row.arithmetic] += 1
        for k, is_right in enumerate(row.right):
            right[row.variant, row.arithmetic, k] += is_right
    return {
        variant: {
            arithmetic: _counts(right, asked, variant, arithmetic)
            for arithmetic in ("rational", *ROUNDING)
            if asked[variant, arithmetic]
        }
        for variant in VARIANTS
    }


def _counts(
    right: Counter[tuple[str, str, int]],
    asked: Counter[tuple[str, str]],
    variant: str,
    arithmetic: str,
) -> str:
    numbers = ", ".join(str(right[variant, arithmetic, k]) for k in range(len(AFTER)))
    return f"{numbers} of {asked[variant, arithmetic]} pairs"
