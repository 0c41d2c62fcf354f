"""Table 2 of Behar & Lien 2012: convex polyhedra under non-uniform scaling, updated and afresh."""

from __future__ import annotations

from typing import Any

from minkref.reports.bench import table2
from minkref.reports.bench.table2 import ABOUT, PAPER, RANDOM, STEPS
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 0.7, 6)
ALONE = True
SEED = 1
LEAST = {RANDOM: 15, STEPS: 100}
MOST_OF_FLOOR = 3


def run(findings: Findings, size: Size) -> None:
    table = table2.run(
        size is not Size.FULL, SEED, lambda text: print(text, flush=True), lambda: None
    )
    for note in table.notes:
        findings.note(note)
    told = table2.summary(table)
    findings.none(
        "updates that differ from the static pairs, or sums from CGAL's hull", table.wrong
    )
    lost = sum(row["chains_without_error"] for row in table.rows)
    findings.none("ee-errors without an error of a facet", lost)
    for kind, least in LEAST.items():
        hull = told[f"{kind}_cgal_hull_ratio"]
        findings.target(
            f"geometric mean ratio of CGAL's hull to ours, {ABOUT[kind]}",
            hull is not None and hull["mean"] >= least,
            f"at least {least}",
            _extent(hull),
        )
        whole = told[f"{kind}_cgal_hull_surface_ratio"]
        findings.note(f"the same with our certified surface, {ABOUT[kind]}: {_extent(whole)}")
    static, floor = told[f"{STEPS}_traversal_ratio"], told[f"{STEPS}_floor_ratio"]
    findings.target(
        "ratio of our best static route to ours for each pair, at steps of 1 %",
        static["least"] > 1,
        "above 1",
        _extent(static),
    )
    findings.target(
        "ours over the coordinates alone for each pair, at steps of 1 %",
        floor["greatest"] <= MOST_OF_FLOOR,
        f"at most {MOST_OF_FLOOR}",
        _extent(floor),
    )
    for kind in ABOUT:
        findings.note(f"{kind}: {_costs([row for row in table.rows if row['kind'] == kind])}")
    for name in ("brute_force_ratio", "traversal_ratio", "floor_ratio"):
        findings.note(f"at random factors, {name}: {_extent(told[f'{RANDOM}_{name}'])}")
    findings.note(f"at steps, brute_force_ratio: {_extent(told[f'{STEPS}_brute_force_ratio'])}")
    findings.note(
        f"the paper, against its own recomputation, at factors whose range it does not give: "
        f"{PAPER['least']} to {PAPER['greatest']}, arithmetic mean {PAPER['mean']}"
    )
    findings.figures = {"seed": table.seed, "rescalings": table.rescalings, "rows": table.rows}


def _extent(told: dict[str, float] | None) -> str:
    if told is None:
        return "not timed"
    return f"{told['mean']:,.2f} ({told['least']:,.2f} to {told['greatest']:,.2f})"


def _costs(rows: list[dict[str, Any]]) -> str:
    def mean(name: str) -> float:
        values = [row[name] for row in rows if row[name] is not None]
        return float(sum(values) / len(values))

    return (
        f"a re-scaling has {mean('fv_errors'):.1f} fv-, {mean('vf_errors'):.1f} vf- and "
        f"{mean('ee_errors'):.1f} ee-errors, {mean('descent_steps'):.1f} descent steps and "
        f"{mean('chains_walked'):.1f} chains walked; {mean('signs'):,.0f} predicates, "
        f"{mean('exact_signs'):.1f} of them in integers; {mean('signs_per_error'):.1f} predicates "
        "for each error mended"
    )
