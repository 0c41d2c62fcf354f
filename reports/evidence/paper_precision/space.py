"""The paper's way to the events of two facets in space, in its own arithmetic, against the exact
events."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import FAMILIES, pair_of_family
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.precision_plot import draw

MINUTES = Minutes(0.1, 1.5, 15)

ARITHMETICS = ("mpfr:24", "mpfr:53", "mpfr:113", "mpfr:256", "double", "interval", "rational")
FEW_ARITHMETICS = ("mpfr:53", "double", "rational")
FORMS = ("printed", "corrected")
SEED = 512
GROUPS = {"general position": ("mixed",), "degenerate": ("slot", "ring", "cup", "spikes", "same")}
PAIRS = Counts(1, 5, 60)  # of each group
MOST_FACETS = Counts(40, 110, 110)


@dataclass(frozen=True)
class Task:
    group: str
    number: int
    arithmetics: tuple[str, ...]
    most_facets: int


def study(task: Task) -> dict[str, dict[str, int]] | None:
    """Counts by arithmetic and form; None for invalid pairs, or too many facets."""
    families = [name for name in GROUPS[task.group] if name in FAMILIES]
    try:
        pair = pair_of_family(families[task.number % len(families)], SEED, task.number)
    except ValueError:  # a self-intersecting solid
        return None
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
    if dict(_core.space_events(P, Q, "1", "1").counts())["facets"] > task.most_facets:
        return None
    return {
        f"{arithmetic}, {form}": dict(_core.facet_contact_trial(P, Q, arithmetic, form))
        for arithmetic in task.arithmetics
        for form in FORMS
    }


def run(findings: Findings, size: Size) -> None:
    arithmetics = FEW_ARITHMETICS if size is Size.QUICK else ARITHMETICS
    wanted = size.of(PAIRS)
    tables: dict[str, dict[str, dict[str, Any]]] = {}
    for group in GROUPS:
        totals: dict[str, Counter[str]] = {}
        studied = 0
        tasks = [
            Task(group, number, arithmetics, size.of(MOST_FACETS)) for number in range(12 * wanted)
        ]
        for found in in_processes(study, tasks, each=wanted):
            if found is None:
                continue
            studied += 1
            for name, counts in found.items():
                totals.setdefault(name, Counter()).update(counts)
            if studied == wanted:
                break
        findings.equal(f"{group}: pairs of polyhedra", wanted, studied)
        tables[f"{group}, {studied} pairs"] = {
            name: {**total, "share called inconsistent": total["false_inconsistent"]
                   / max(total["roots"], 1)}
            for name, total in totals.items()
        }  # fmt: skip
    for title, table in tables.items():
        _judge(findings, title, table)
    findings.figures = {"tables": tables}
    if size is Size.FULL:
        draw(tables, ROOT / "reports" / "evidence" / "space_precision.svg")


def _judge(findings: Findings, title: str, table: dict[str, dict[str, Any]]) -> None:
    exact = table["rational, corrected"]
    wrong = exact["missed"] + exact["invented"] + exact["false_inconsistent"]
    findings.none(f"{title}: corrected, in rational numbers: what is not exact", wrong)
    printed = table["rational, printed"]
    findings.equal(
        f"{title}: printed, in rational numbers: events missed but where a side is along the plane",
        printed["singular"], printed["missed"],
    )  # fmt: skip
    findings.none(f"{title}: printed, in rational numbers: invented", printed["invented"])
    if "interval, corrected" in table:
        row = table["interval, corrected"]
        findings.none(
            f"{title}: intervals that are certified and wrong",
            row["missed"] + row["invented"] + row["misplaced"],
        )
    for name, row in table.items():
        findings.note(
            f"{title}, {name}: {row['share called inconsistent']:.1%} of {row['roots']:,} systems "
            f"with a root called inconsistent; {row['missed']:,} missed ({row['singular']:,} with "
            f"a side along the plane) and {row['invented']:,} invented of {row['events']:,} "
            f"events, {row['misplaced']:,} off by more than an ulp, {row['undecided_pairs']:,} of "
            f"{row['pairs']:,} pairs undecided"
        )
