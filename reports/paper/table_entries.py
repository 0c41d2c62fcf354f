"""Entries for Tables 1 and 2."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from statistics import fmean
from typing import Any

from minkref.reports.audit.paper_numbers import SMALL
from minkref.reports.bench import table1, table2
from minkref.reports.bench.baselines import CGAL, PAIRWISE, STATIC
from minkref.reports.bench.spread import Spread, spread
from minkref.reports.paper.entry import Claim, Entry, Table
from minkref.reports.paper.speedups import Speedups

OURS = {"dog": "dog145"}  # our polygons with the paper's sizes
SOLIDS_OF_OURS = ("ellipsoid", "gs3", "gs4", "ti", "rod")
ORDER = 10  # of magnitude
GENERALLY = (
    "this method is generally one to two orders of magnitude faster than recomputing the Minkowski "
    "sum from scratch"
)
SIGNIFICANT = (
    "significant speed-up (between 13 and 94) for computing convex Minkowksi sums dynamically over "
    "manual recomputation across all studied models"
)


def first_table(table: table1.Table1, walks: Mapping[str, Mapping[str, Speedups]]) -> Entry:
    """`walks`: by arithmetic and pair, the paper's own program."""
    found = {(row["name"], row["baseline"]): row for row in table.rows}
    rows = []
    for scaled, other in product(SMALL, SMALL):
        ours = [OURS.get(one, one) for one in (scaled, other)]
        name = " + ".join(ours)
        line: list[Any] = [" + ".join(f"{one} (ours)" for one in ours)]
        for of_pairs in walks.values():
            walk = of_pairs[name]
            line += [len(walk.rescalings), *_spread(walk.speed), round(walk.speed.mean, 1)]
        for baseline in (PAIRWISE, STATIC, CGAL):
            row = found.get((name, baseline))
            line += ["", ""] if row is None else _spread(Spread(**row["ratios"]))
        rows.append(line)
    columns = ["pair"]
    for arithmetic in walks:
        program = f"paper's program, {arithmetic}"
        columns += [f"{program}: re-scalings", "median", "quartiles", "mean"]
    for what in ("our update, doubles", "sum, our static", "sum, CGAL reduced"):
        columns += [f"{what}: median", "quartiles"]
    why = (
        "By the paper's own program: update against finding the intersections of all pairs of "
        "edges, both in one arithmetic; each of the five repetitions of a re-scaling gives a "
        "ratio, a re-scaling counts with their median, and a pair with the median of its "
        "re-scalings. By our update, with lists stored in between, against all pairs of edges in "
        "doubles, boxes first. And whole sums: our update and sum against our static sum and "
        "CGAL's. The paper's own table, of its own polygons, is in the audit."
    )
    return Entry("Table 1", "Speed-ups of the update, 25 pairs", why, "minkref bench --only table1",
                 [*_program_claims(walks), *_sum_claims(table)], _unlike_table_1(walks),
                 tables=[Table("table1", columns, rows)])  # fmt: skip


def _unlike_table_1(walks: Mapping[str, Mapping[str, Speedups]]) -> list[str]:
    counts = [
        f"{len(next(iter(of_pairs.values())).rescalings)} re-scalings a pair in {arithmetic}"
        for arithmetic, of_pairs in walks.items()
    ]
    return [
        "the polygons are ours and have the paper's numbers of vertices alone, so that single "
        "pairs are not comparable with those of its table",
        f"{', '.join(counts)}, where the paper has 100",
        "which mean its averages are, and whether of whole sums, the paper does not say",
    ]


def _program_claims(walks: Mapping[str, Mapping[str, Speedups]]) -> list[Claim]:
    claims = []
    for arithmetic, of_pairs in walks.items():
        singles = [one.speedup for walk in of_pairs.values() for one in walk.rescalings]
        pairs = spread([walk.speed.median for walk in of_pairs.values()])
        claims += [
            Claim("Our method is always faster than recomputing from scratch", "Sec. 7.1",
                  f"{arithmetic}, intersections: each single re-scaling is",
                  f"{min(singles):,.1f} to {max(singles):,.0f} times as fast",
                  min(singles) > 1),
            Claim(GENERALLY, "Sec. 1",
                  f"{arithmetic}, intersections: the median of the pairs is at least {ORDER}",
                  f"the pairs' medians: {pairs.in_words()}; {_means(of_pairs)}",
                  pairs.median >= ORDER),
        ]  # fmt: skip
    return claims


def _means(of_pairs: Mapping[str, Speedups]) -> str:
    """Mean of means, with and without the two largest pairs."""
    means = sorted(walk.speed.mean for walk in of_pairs.values())
    return (
        f"mean of their means {fmean(means):,.1f}, without the two largest {fmean(means[:-2]):,.1f}"
    )


def _sum_claims(table: table1.Table1) -> list[Claim]:
    """Whole sums: our update against static sums."""
    claims = []
    for baseline, what in ((STATIC, "our static sum"), (CGAL, "CGAL's reduced convolution")):
        medians = [row["ratios"]["median"] for row in table.rows
                   if row["small"] and row["baseline"] == baseline]  # fmt: skip
        if medians:
            pairs = spread(medians)
            claims.append(
                Claim(GENERALLY, "Sec. 1",
                      f"whole sums, our exact update and sum against {what}: the median of the "
                      f"pairs is at least {ORDER}", f"the pairs' medians: {pairs.in_words()}",
                      pairs.median >= ORDER)
            )  # fmt: skip
    return claims


def _spread(found: Spread) -> list[Any]:
    return [round(found.median, 1), f"{found.lower:.1f} to {found.upper:.1f}"]


AGAINST = {
    "brute_force": "all pairs",
    "traversal": "our best route from scratch",
    "cgal_hull": "CGAL's hull of all sums of vertices",
}


def second_table(table: table2.Table2) -> Entry:
    rows = []
    for scaled, fixed in product(SOLIDS_OF_OURS, SOLIDS_OF_OURS):
        line: list[Any] = [f"{scaled} (ours) + {fixed} (ours)"]
        for kind in table2.ABOUT:
            row = next(row for row in table.rows
                       if (row["P"], row["Q"], row["kind"]) == (scaled, fixed, kind))  # fmt: skip
            for name in AGAINST:
                line += [_rounded(row[f"{name}_ratios_mean"]), _rounded(row[f"{name}_ratio"])]
        rows.append(line)
    columns = ["pair"]
    for kind in ("random", "1 %"):
        for what in AGAINST.values():
            columns += [f"{kind}, {what}: mean of ratios", "ratio of means"]
    why = (
        f"All times are of one run, with the exact coordinates of all corners; CGAL's time has the "
        f"surface too. All pairs and CGAL's hull are timed at every {table2.ALL_EVERY}th "
        f"re-scaling. Over the 25 pairs the mean of ratios is: "
        f"{'; '.join(_of_kind(table, kind) for kind in table2.ABOUT)}. The paper's own table, of "
        f"its own models, is in the audit."
    )
    unlike = [
        "the models are ours, exactly convex, with as many facets as the paper's; a prism stands "
        "for the v-rod",
        "the range of the random factors is ours, for the paper gives none",
        "what its computation from scratch does the paper does not say, but for “brute force” in "
        "Section 1: the baselines are ours",
        "rational numbers, where the paper has MPFR",
    ]
    return Entry("Fig. 10, Table 2", "Convex polyhedra under non-uniform scaling", why,
                 "minkref bench --only table2", _claims(table), unlike,
                 tables=[Table("table2", columns, rows)])  # fmt: skip


def _values(table: table2.Table2, kind: str, name: str) -> list[float]:
    """Values for all pairs; empty if a quick run has not timed every pair."""
    values = [row[name] for row in table.rows if row["kind"] == kind]
    return [] if None in values else values


def _of_kind(table: table2.Table2, kind: str) -> str:
    texts = []
    for name, what in AGAINST.items():
        each = _values(table, kind, f"{name}_ratios_mean")
        if each:
            texts.append(f"against {what} {spread(each).in_words()}")
    return f"{table2.ABOUT[kind]}: " + ", ".join(texts)


def _claims(table: table2.Table2) -> list[Claim]:
    claims = []
    for words, place, name, least in (
        ("provides significant speed improvements over brute force", "Sec. 1", "brute_force", 1),
        (SIGNIFICANT, "Sec. 7.2.2", "brute_force", ORDER),
        (SIGNIFICANT, "Sec. 7.2.2", "traversal", ORDER),
    ):
        values = _values(table, table2.RANDOM, f"{name}_ratios_mean")
        steps = _values(table, table2.STEPS, f"{name}_ratios_mean")
        if values and steps:
            found = (
                f"{min(values):,.1f} to {max(values):,.1f} times, {spread(values).in_words()}; in "
                f"steps of 1 % {min(steps):,.1f} to {max(steps):,.1f} times"
            )
            tested = (
                f"at random factors, against {AGAINST[name]}: each pair more than {least} times "
                f"as fast, the median pair {ORDER} times"
            )
            holds = min(values) > least and spread(values).median >= ORDER
            claims.append(Claim(words, place, tested, found, holds))
    return claims


def _rounded(value: float | None) -> str:
    return "-" if value is None else f"{value:,.1f}"
