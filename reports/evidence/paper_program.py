"""The paper's program of Section 4, followed literally in several arithmetics: how often it has the
right sum, and which formula is to blame."""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.judges.rounded_sums import compare, significant_bits
from minkref.reports.bench.pairs import Pair, pairs
from minkref.reports.bench.rescalings import rescalings
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import COMPARISON, MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "The paper's update (Behar & Lien 2012, Section 4) formula by formula on the pairs of Table 1: "
    "all formulas corrected, all but one, and as printed; in rational numbers, doubles and MPFR of "
    "53 to 1,000 bits; after 1, 10 and 100 re-scalings."
)
MINUTES = (40, 0.3)
DEPENDS = (*REFERENCE, *READERS, *MODELS, *COMPARISON, "reports/bench/*.py")

SEED = 1
AFTER = (1, 10, 100)  # re-scalings
ROUNDING = ("double", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:1000")
FEW = ("double", "mpfr:200")  # of pairs with many edges
MANY = 60_000  # pairs of edges
MOST = 600_000
TOO_MANY = 10  # times as many intersections as there are: no sum is asked for, it is another one
CORRECTED = {name: corrected for name, _, corrected, _ in _core.paper_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.paper_readings()}
VARIANTS = {
    "all corrected": CORRECTED,
    **{
        f"{name} as printed": CORRECTED | {name: PRINTED[name]}
        for name in CORRECTED
        if PRINTED[name] != CORRECTED[name]
    },
    "solve within a tolerance": CORRECTED | {"solve": "tolerance:1e-9"},
    "solve by least squares": CORRECTED | {"solve": "least-squares"},
    "all as printed": PRINTED,
}


@dataclass(frozen=True)
class Task:
    """`intersections`: how many there are after each of AFTER."""

    pair: Pair
    arithmetic: str
    variant: str
    intersections: tuple[int, ...]


@dataclass(frozen=True)
class Row:
    """One program on one pair. `right`: after each of AFTER, whether the structure is right."""

    arithmetic: str
    variant: str
    name: str
    right: tuple[bool, ...]
    same: tuple[bool, ...]  # the same set of points, exactly
    most_ulps: float
    seconds: float


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
    return Row(
        task.arithmetic, task.variant, task.pair.name, tuple(right), tuple(same), most, seconds
    )


def intersections(pair: Pair) -> tuple[int, ...]:
    scales = rescalings(SEED, AFTER[-1])
    exact = _core.PaperUpdate(pair.P.set, pair.Q.set, "1", "rational", CORRECTED)
    return tuple(exact.move_to(scales[number - 1])["updated"] for number in AFTER)


def tasks(quick: bool) -> tuple[list[Task], list[str]]:
    chosen, notes = pairs(quick=True)
    found, left_out = [], []
    for pair in chosen:
        edges = len(_core.reduced_convolution(pair.P.set, pair.Q.set))
        count = edges * (edges - 1) // 2
        if quick and count > 12_000:
            continue
        if count > MOST:
            left_out.append(f"{pair.name}, {count:,} pairs of edges")
            arithmetics, variants = ["double"], ["all corrected", "solve as printed"]
        else:
            arithmetics = ["rational", *(FEW if quick or count > MANY else ROUNDING)]
            variants = list(VARIANTS)
        there = intersections(pair)
        found += [Task(pair, a, v, there) for a in arithmetics for v in variants]
    if left_out:
        notes.append(f"in doubles only, and by two programs only: {'; '.join(left_out)}")
    return found, notes


def run(findings: Findings, quick: bool) -> None:
    chosen, notes = tasks(quick)
    for note in notes:
        findings.note(note)
    rows = list(in_processes(follow, chosen))
    wrong = [r.name for r in rows if (r.arithmetic, r.variant) == ("rational", "all corrected")
             and not all(r.same)]  # fmt: skip
    findings.none("all corrected, rational: sums that are not the exact ones", wrong)
    harmless = ("solve as printed", "solve by least squares")
    wrong = [f"{r.name}: {r.variant}" for r in rows if r.arithmetic == "rational"
             and r.variant in harmless and not all(r.same)]  # fmt: skip
    findings.none("the solve alone as printed, rational: sums that are not the exact ones", wrong)
    findings.figures["right after 1, 10 and 100 re-scalings"] = _table(rows)
    findings.figures["largest distance in ulps where the structure is right"] = {
        arithmetic: max(
            (r.most_ulps for r in rows
             if r.arithmetic == arithmetic and r.variant == "all corrected"), default=0.0)
        for arithmetic in ROUNDING
    }  # fmt: skip
    findings.figures["seconds of processor time to find the regions, all corrected"] = {
        arithmetic: round(sum(r.seconds for r in rows
                              if r.arithmetic == arithmetic and r.variant == "all corrected"), 2)
        for arithmetic in ("rational", *ROUNDING)
    }  # fmt: skip


def _table(rows: list[Row]) -> dict[str, dict[str, str]]:
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
