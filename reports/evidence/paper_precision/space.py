"""The paper's way to the events of two facets in space, in its own arithmetic, against the exact
events."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

from minkref import _core
from minkref.cli.readings import FACET_CHOICES, readings_of
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
BLAMED = ("rational", "mpfr:53", "mpfr:256")  # arithmetics in which sentences are tried one by one
HARMLESS = ("solve=printed", "solve=least-squares", "coplanar=turned", "plane-solve=printed",
            "plane-solve=least-squares", "plane-adjacent=taken")  # fmt: skip
SEED = 512
GROUPS = {"general position": ("mixed",), "degenerate": ("slot", "ring", "cup", "spikes", "same")}
PAIRS = Counts(1, 5, 60)  # of each group
BLAMED_PAIRS = Counts(0, 1, 12)
MOST_FACETS = Counts(40, 110, 110)


@dataclass(frozen=True)
class Task:
    group: str
    number: int
    arithmetics: tuple[str, ...]
    most_facets: int
    blames: bool


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
    rows = {
        f"{arithmetic}, {form}": dict(
            _core.facet_contact_trial(P, Q, arithmetic, readings_of(form, None, FACET_CHOICES))
        )
        for arithmetic in task.arithmetics
        for form in FORMS
    }
    for arithmetic in BLAMED if task.blames else ():
        for reading in one_by_one():
            readings = readings_of("corrected", [reading], FACET_CHOICES)
            found = dict(_core.facet_contact_trial(P, Q, arithmetic, readings))
            rows[f"{arithmetic}, corrected but {reading}"] = found
    return rows


def one_by_one() -> list[str]:
    """Each sentence's values, except the corrected one: `corner=lines`."""
    return [
        f"{name}={value.replace('EPS', '1e-9')}"
        for name, values, corrected, _ in FACET_CHOICES.rows
        for value in values
        if value != corrected
    ]


def run(findings: Findings, size: Size) -> None:
    arithmetics = FEW_ARITHMETICS if size is Size.QUICK else ARITHMETICS
    wanted = size.of(PAIRS)
    tables: dict[str, dict[str, dict[str, Any]]] = {}
    blamed = size.of(BLAMED_PAIRS)
    for group in GROUPS:
        totals: dict[str, Counter[str]] = {}
        studied = 0
        tasks = [
            Task(group, number, arithmetics, size.of(MOST_FACETS), number < 2 * blamed)
            for number in range(12 * wanted)
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
    _blame(findings, title, table)
    if "interval, corrected" in table:
        row = table["interval, corrected"]
        findings.none(
            f"{title}: intervals that are certified and wrong",
            row["missed"] + row["invented"] + row["misplaced"],
        )
    for name, row in table.items():
        findings.note(
            f"{title}, {name}: {row['share called inconsistent']:.1%} of {row['roots']:,} systems "
            f"with a root called inconsistent; {row['missed']:,} missed "
            f"({row['parallel_faces']:,}, {row['parallel_sides']:,} and "
            f"{row['side_along_plane']:,} where a matrix is singular: parallel faces, parallel "
            f"sides, a side along the plane) and {row['invented']:,} invented of "
            f"{row['events']:,} events, {row['misplaced']:,} off by more than an ulp, "
            f"{row['undecided_pairs']:,} of {row['pairs']:,} pairs undecided"
        )


def _blame(findings: Findings, title: str, table: dict[str, dict[str, Any]]) -> None:
    """In rational numbers each sentence has its own fault, or none."""
    for reading in one_by_one():
        row = table.get(f"rational, corrected but {reading}")
        if row is None:
            continue
        wrong = row["missed"] + row["invented"]
        if reading in HARMLESS:
            findings.none(f"{title}: {reading} alone, in rational numbers: wrong", wrong)
        singular = sum(row[why] for why in ("parallel_faces", "parallel_sides", "side_along_plane"))
        if reading in ("corner=lines", "crossing=points"):
            what = f"{title}: {reading} alone: missed, but not where a matrix is singular"
            findings.equal(what, 0, row["missed"] - singular)
            findings.none(f"{title}: {reading} alone: invented", row["invented"])
