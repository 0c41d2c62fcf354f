"""Table 1 of Behar & Lien 2012: dynamic update against finding the same afresh."""

from __future__ import annotations

from typing import Any

from minkref.reports.bench import table1
from minkref.reports.bench.baselines import ABOUT, CGAL, CONTACTS, PAIRWISE, STATIC
from minkref.reports.bench.table1 import PAPER_MEAN, Table1
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 0.5, 5)
ALONE = True
SEED = 1


def run(findings: Findings, size: Size) -> None:
    table = table1.run(
        size is not Size.FULL, SEED, lambda text: print(text, flush=True), lambda: None
    )
    for note in table.notes:
        findings.note(note)
    findings.none("sums after the update that differ from the static ones", table.wrong)
    reached = table.mean_ratio(PAIRWISE)
    findings.target(
        "mean ratio over the 25 pairs, against all pairs of edges in doubles",
        reached is not None and reached >= PAPER_MEAN,
        f"at least {PAPER_MEAN}, which the paper has for polygons of its own",
        "not all pairs were timed" if reached is None else f"{reached:.2f}",
    )
    for baseline in (CONTACTS, STATIC, CGAL):
        mean = table.mean_ratio(baseline)
        if mean is not None:
            findings.note(f"mean ratio over the 25 pairs against {ABOUT[baseline]}: {mean:.2f}")
    for row in table.rows:
        if not row["small"]:
            findings.note(_sentence(row))
    single = table.mean_of_ratios(PAIRWISE)
    if single is not None:
        findings.note(
            f"the same against all pairs of edges, with the mean of the ratios of single "
            f"re-scalings for each pair: {single:.2f}; the paper does not say which mean its own is"
        )
    findings.note(f"{table.rescalings} re-scalings of each pair, seed {SEED}; ratios of means")
    findings.figures = _figures(table)


def _sentence(row: dict[str, Any]) -> str:
    pays = f"pays from {row['break_even']:,} on" if row["break_even"] is not None else "never pays"
    spread = row["ratios"]
    return (
        f"{row['name']}, {row['measure']}, against {row['baseline']}: {row['ratio']:.2f} (median "
        f"{spread['median']:.2f}, quartiles {spread['lower']:.2f} and {spread['upper']:.2f}), "
        f"{row['rescalings_timed']} re-scalings timed; {pays}"
    )


def _figures(table: Table1) -> dict[str, Any]:
    return {"seed": table.seed, "pairs": table.pairs, "rows": table.rows}
