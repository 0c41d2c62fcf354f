"""The paper's way to the pair events in its own arithmetic, against the exact events."""

from __future__ import annotations

from collections import Counter
from typing import Any

from minkref import _core
from minkref.fuzz.least_precision import MOST_BITS, least_precision
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.precision_plot import draw

MINUTES = Minutes(0.1, 1, 20)

ARITHMETICS = ("mpfr:24", "mpfr:53", "mpfr:113", "mpfr:256", "double", "interval")
FEW_ARITHMETICS = ("mpfr:24", "mpfr:53", "double")
FORMS = ("printed", "corrected")
PAIRS, SEED = Counts(100, 600, 10_000), 1
SUMS = Counts(80, 600, 10_000)
LEAST = Counts(8, 40, 500)


def run(findings: Findings, size: Size) -> None:
    arithmetics = FEW_ARITHMETICS if size is Size.QUICK else ARITHMETICS
    names = ("disc1", "neuron") if size is Size.FULL else ("g1", "g2")
    if size is Size.FULL:
        tell_absent(findings, *names)
    P, Q = (operand(name) for name in names)
    sets = [(P.set, Q.set)]
    tables = {f"{P.name} + {Q.name}": _table(sets, arithmetics)}
    drawn = [random_pair(SEED, i) for i in range(size.of(PAIRS))]
    pairs = [(_core.PolygonSet.from_json(p.P), _core.PolygonSet.from_json(p.Q)) for p in drawn]
    tables[f"{len(pairs)} random pairs"] = _table(pairs, arithmetics)
    findings.figures = {"tables": tables}
    for title, table in tables.items():
        _judge(findings, title, table)
    _wrong_sums(findings, pairs[: size.of(SUMS)], arithmetics)
    _least(findings, pairs[-size.of(LEAST) :])
    if size is Size.FULL:
        draw(tables, ROOT / "reports" / "evidence" / "precision.svg")


def _wrong_sums(
    findings: Findings,
    pairs: list[tuple[_core.PolygonSet, _core.PolygonSet]],
    arithmetics: tuple[str, ...],
) -> None:
    """Counts sums at scale 7/5 that differ from the exact sum's numbers of vertices, components or
    holes."""

    def shape(answer: _core.Sum) -> tuple[int, int, int]:
        return answer.region.vertices, answer.components, answer.holes

    counts: dict[str, Counter[str]] = {name: Counter() for name in arithmetics}
    for P, Q in pairs:
        truth = shape(_core.minkowski_sum(P, Q, "7/5"))
        for name in arithmetics:
            try:
                got = shape(_core.minkowski_sum(P, Q, "7/5", "paper", name))
                counts[name]["right" if got == truth else "wrong"] += 1
            except _core.UndecidedSign:
                counts[name]["undecided"] += 1
            except (ValueError, RuntimeError):
                counts[name]["broke down"] += 1
    findings.figures["sums at 7/5"] = {name: dict(count) for name, count in counts.items()}
    if "interval" in counts:
        wrong = counts["interval"]["wrong"] + counts["interval"]["broke down"]
        findings.none("sums that intervals certify and get wrong", wrong)
    for name, count in counts.items():
        findings.note(f"sums of {len(pairs)} random pairs at 7/5 in {name}: {dict(count)}")


def _least(findings: Findings, pairs: list[tuple[_core.PolygonSet, _core.PolygonSet]]) -> None:
    found = Counter(str(least_precision(P, Q)) for P, Q in pairs)
    findings.figures["least sufficient bits, corrected"] = dict(found)
    none = found["None"]
    findings.note(
        f"least sufficient precision of {len(pairs)} random pairs, corrected: {none} have none up "
        f"to {MOST_BITS} bits (events that only exact arithmetic can tell)"
    )


def _table(
    pairs: list[tuple[_core.PolygonSet, _core.PolygonSet]], arithmetics: tuple[str, ...]
) -> dict[str, dict[str, Any]]:
    """Counts summed over all operand pairs, by arithmetic and form."""
    table: dict[str, dict[str, Any]] = {}
    for arithmetic in arithmetics:
        for form in FORMS:
            total: Counter[str] = Counter()
            for P, Q in pairs:
                total.update(_core.precision_trial(P, Q, arithmetic, form))
            row: dict[str, Any] = dict(total)
            row["operands all right"] = row.pop("all_right")
            row["share called inconsistent"] = row["false_inconsistent"] / max(row["roots"], 1)
            table[f"{arithmetic}, {form}"] = row
    return table


def _judge(findings: Findings, title: str, table: dict[str, dict[str, Any]]) -> None:
    for form in FORMS:
        same = table[f"mpfr:53, {form}"] == table[f"double, {form}"]
        findings.law(
            f"{title}, {form}: mpfr at 53 bits answers as doubles do", same, "the same counts",
            "the same counts" if same else "others",
        )  # fmt: skip
    if "interval, corrected" in table:
        row = table["interval, corrected"]
        bad = row["missed"] + row["invented"] + row["misplaced"]
        findings.none(f"{title}: intervals that are certified and wrong", bad)
    shares = ", ".join(
        f"{name.split(',')[0]} {row['share called inconsistent']:.1%}"
        for name, row in table.items()
        if name.endswith("printed")
    )
    findings.note(f"{title}: solves with a root that are called inconsistent: {shares}")
    for name, row in table.items():
        findings.note(
            f"{title}, {name}: {row['missed']:,} missed and {row['invented']:,} invented of "
            f"{row['events']:,} events, {row['misplaced']:,} off by more than an ulp, "
            f"{row['inversions']:,} pairs of events in the wrong order, "
            f"{row['undecided_pairs']:,} pairs undecided"
        )
