"""Compares sums with a disc to CGAL's exact offsets, curve by curve, and their times; both routes
give one form."""

from __future__ import annotations

import statistics
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge, absence
from minkref.fuzz.judges.disc.offset_comparison import Table, compare, compare_one
from minkref.fuzz.judges.disc.offset_routes import RouteTable, compare_routes
from minkref.fuzz.judges.disc.offset_sandwich import sandwich
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1, 6)

SEED = 2012
SETS = Counts(50, 400, 2000)
BATCH = 50
LARGE = ("neuron", "monkey", "bird")
PARTS = (Fraction(1, 300), Fraction(1, 100), Fraction(1, 30))  # radii relative to the box's length
SECONDS = Counts(10.0, 20.0, 120.0)  # for an offset by CGAL
TIMES = 5
WITHIN = Counts(Fraction(1, 20), Fraction(1, 500), Fraction(3, 10**7))  # of the radius


def has_judge(findings: Findings) -> bool:
    missing = absence()
    if missing:
        findings.law("CGAL's exact offset is there", False, "it is", missing)
    return missing is None


def batch(first: int) -> Table:
    table = Table()
    compare(SEED, range(first, first + BATCH), table)
    return table


def routes_batch(first: int) -> RouteTable:
    table = RouteTable()
    compare_routes(SEED, range(first, first + BATCH), table)
    return table


def run(findings: Findings, size: Size) -> None:
    routes = _both_routes(findings, size)
    if not has_judge(findings):
        return
    tell_absent(findings, *LARGE)
    table = Table()
    for one in in_processes(batch, range(0, size.of(SETS), BATCH), each=5):
        table.counts.update(one.counts)
        table.unanswered += one.unanswered
        table.differences += one.differences
        table.refuted += one.refuted
    sets = table.counts["compared"]
    rows = _large(table, size, findings)
    findings.none("sums that are neither CGAL's nor refute it by a point", table.differences)
    wanted = size.of(SETS) * 9 // 10
    findings.law("sets of cells compared, curve by curve", sets >= wanted, wanted, sets)
    findings.note(
        f"seed {SEED}: {table.counts['at radii of events']:,} at radii of events, "
        f"{table.counts['at other radii']:,} at others; {table.counts['holes']:,} holes, "
        f"{table.counts['curves']:,} curves; without an answer of CGAL: "
        f"{'; '.join(table.unanswered) or 'none'}; answers of CGAL that a point refutes: "
        f"{len(table.refuted)}"
    )
    findings.figures = {"counts": dict(table.counts), "large": rows, "routes": routes}


def _both_routes(findings: Findings, size: Size) -> dict[str, object]:
    counts: Counter[str] = Counter()
    differences: list[str] = []
    numbers = range(0, size.of(SETS), BATCH)
    for one in in_processes(routes_batch, numbers, each=5, what="batches by both routes"):
        counts.update(one.counts)
        differences += one.differences
    sets = counts["compared"]
    findings.none("sets whose sums differ by route", differences)
    wanted = len(numbers) * BATCH * 9 // 10
    findings.law("sets summed by both routes", sets >= wanted, wanted, sets)
    told = ", ".join(f"{count:,} {kind}" for kind, count in sorted(counts.items()))
    findings.note(f"both routes, seed {SEED}: {told}")
    rows: list[dict[str, object]] = []
    for name in LARGE[-1:] if size is Size.QUICK else LARGE:
        known, P = operand(name).name, operand(name).set
        xmin, ymin, xmax, ymax = P.bounding_box()
        for part in PARTS[-1:] if size is Size.QUICK else PARTS:
            radius = Fraction(round(float(part) * max(xmax - xmin, ymax - ymin) * 1000), 1000)
            found = {
                route: [_core.offset(P, str(radius**2), 1, route) for _ in range(TIMES)]
                for route in ("definition", "paper")
            }
            seconds = {
                route: statistics.median(each.seconds for each in some)
                for route, some in found.items()
            }
            same = found["definition"][0] == found["paper"][0]
            where = f"{known}, radius {radius}"
            findings.law(f"{where}: one form by both routes", same, True, same)
            findings.note(
                f"{where}, one thread: definition {seconds['definition'] * 1000:.0f} ms, "
                f"paper {seconds['paper'] * 1000:.0f} ms"
            )
            rows.append({"model": known, "radius": str(radius), "seconds": seconds})
    return {"counts": dict(counts), "large": rows}


def _large(table: Table, size: Size, findings: Findings) -> list[dict[str, object]]:
    rows: list[dict[str, object]] = []
    with OffsetJudge(size.of(SECONDS)) as judge:
        for name in LARGE[-1:] if size is Size.QUICK else LARGE:
            known, P = operand(name).name, operand(name).set
            xmin, ymin, xmax, ymax = P.bounding_box()
            for part in PARTS[-1:] if size is Size.QUICK else PARTS:
                radius = Fraction(round(float(part) * max(xmax - xmin, ymax - ymin) * 1000), 1000)
                _, theirs = compare_one(judge, known, P, radius, table)
                found = [_core.offset(P, str(radius**2), 2) for _ in range(TIMES)]
                ours = statistics.median(each.seconds for each in found)
                rows.append(
                    {
                        "model": known, "vertices": P.vertices, "radius": str(radius),
                        "curves": found[0].curves, "holes": found[0].holes, "minkref": ours,
                        "cgal": theirs,
                    }
                )  # fmt: skip
                told = "no answer"
                if theirs is not None:
                    told = f"{theirs:.2f} s, {theirs / ours:,.0f} times ours"
                findings.note(
                    f"{known} ({P.vertices:,} vertices), radius {radius}: {found[0].curves:,} "
                    f"curves, {found[0].holes} holes, {ours * 1000:.1f} ms; CGAL {told}"
                )
                if name == "neuron":
                    what = f"{known}, radius {radius}: seconds on two threads"
                    findings.target(what, ours <= 0.1, "at most 0.1 s", f"{ours:.3f} s")
                _sandwich(known, P, radius, found[0], size, findings)
    return rows


def _sandwich(
    name: str, P: _core.PolygonSet, radius: Fraction, found: _core.Offset, size: Size,
    findings: Findings,
) -> None:  # fmt: skip
    counts = found.components, found.holes
    within = size.of(WITHIN)
    told = sandwich(P, radius**2, counts, found.area, within)
    low, high = (float(area) for area in told.areas)
    findings.none(
        f"{name}, radius {radius}: what does not fit between polygons in and around the disc",
        told.faults,
    )
    findings.note(
        f"{name}, radius {radius}: with polygons of {told.corners:,} corners and more the area is "
        f"from {low:.9g} to {high:.9g}, that of the disc {found.area[0]:.9g}; "
        + ("both have as many holes" if told.same_holes else "they have not as many holes")
    )
