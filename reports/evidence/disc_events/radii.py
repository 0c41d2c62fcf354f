"""Radii at which sums with a disc change: between two of them nothing changes, at each
something."""

from __future__ import annotations

import json
import random
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge
from minkref.fuzz.judges.disc.offset_comparison import Table, compare_one, grid_set
from minkref.reports.evidence.disc_sums.sums import LARGE, has_judge
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.8, 3)

SEED = 1904
SETS = Counts(6, 80, 300)
GAPS = Counts(2, 12, 60)  # of a large polygon
SECONDS = 20.0  # for an offset by CGAL


@dataclass
class Looked:
    counts: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    table: Table = field(default_factory=Table)


def gaps(rows: list[Any]) -> list[tuple[Fraction, Fraction]]:
    """Gaps between events, from 0 to beyond the last event; skips events that doubles do not
    separate."""
    bounds = [(Fraction(low), Fraction(high)) for _, _, _, (low, high), _, _ in rows]
    found, last = [], Fraction(0)
    for low, high in bounds:
        if low > last:
            found.append((last, low))
        last = max(last, high)
    return [*found, (last, 2 * last + 1)]


def inside(gap: tuple[Fraction, Fraction], part: Fraction) -> Fraction:
    """A short number in a gap."""
    low, high = gap
    wanted = low + (high - low) * part
    return wanted.limit_denominator(max(1000, int(100 / (high - low))))


def structure(P: _core.PolygonSet, radius: Fraction) -> tuple[str, int]:
    found = _core.offset(P, str(radius**2))
    return json.dumps(json.loads(found.canonical_json())["components"]), found.holes


def of_grid(number: int) -> Looked:
    looked = Looked()
    P = grid_set(random.Random(f"minkref disc events {SEED}:{number}"))
    if P.is_empty:
        return looked
    rows = _core.diagram_events(P).rows(0, 10**9)
    looked.counts.update(sets=1, events=len(rows), **Counter(row[0] for row in rows))
    before = None
    with OffsetJudge(SECONDS) as judge:
        for gap in gaps(rows):
            radii = [inside(gap, Fraction(part, 7)) for part in (1, 6)]
            first, last = (structure(P, radius) for radius in radii)
            looked.counts["gaps"] += 1
            where = f"grid {number}, radii {float(gap[0]):g} to {float(gap[1]):g}"
            if first != last:
                looked.faults.append(f"{where}: the curves change: {P.canonical_json()}")
            if first == before:
                looked.faults.append(f"{where}: the curves are those before: {P.canonical_json()}")
            before = last
            compare_one(judge, f"grid {number}", P, radii[0], looked.table)
    return looked


def of_model(name: str, count: int, findings: Findings) -> tuple[dict[str, Any], list[str]]:
    P, name = operand(name).set, operand(name).name
    found = _core.diagram_events(P, 2)
    rows = found.rows(0, 10**9)
    kinds = Counter(row[0] for row in rows)
    every = gaps(rows)
    faults = []
    for k in random.Random(f"minkref disc gaps {name}").sample(range(1, len(every) - 1), count):
        first, last, next_one = (
            structure(P, inside(gap, Fraction(part, 7)))
            for gap, part in ((every[k], 1), (every[k], 6), (every[k + 1], 1))
        )
        if first != last or last == next_one:
            faults.append(f"{name}: around {float(every[k][1]):g}")
    corners = len(rows) - kinds["saddle"]
    findings.note(
        f"{name} ({P.vertices:,} vertices): {corners:,} corners of the outer Voronoi diagram, "
        f"{kinds['joint']:,} of them joints and {kinds['maximum']} maxima; {kinds['saddle']} "
        f"saddles; {found.seconds:.2f} s on two threads; the last at {rows[-1][3][0]:.6g}"
    )
    return {"model": name, **kinds, "seconds": found.seconds}, faults


def run(findings: Findings, size: Size) -> None:
    if not has_judge(findings):
        return
    tell_absent(findings, *LARGE)
    all_looked = Looked()
    for looked in in_processes(of_grid, range(size.of(SETS)), each=20):
        all_looked.counts.update(looked.counts)
        all_looked.faults += looked.faults
        all_looked.table.counts.update(looked.table.counts)
        all_looked.table.differences += looked.table.differences
        all_looked.table.refuted += looked.table.refuted
    rows = []
    for name in LARGE[-1:] if size is Size.QUICK else LARGE:
        row, faults = of_model(name, size.of(GAPS), findings)
        rows.append(row)
        all_looked.faults += faults
    counts = all_looked.counts
    findings.none("gaps in which curves change, or are those of the gap before", all_looked.faults)
    findings.none("sums in gaps that are not CGAL's", all_looked.table.differences)
    enough = all_looked.table.counts["compared"] >= counts["gaps"] * 9 // 10
    findings.law("gaps that CGAL looked into", enough, "nine tenths", f"{counts['gaps']:,} gaps")
    findings.note(
        f"{counts['sets']:,} sets of cells, {counts['events']:,} events; answers of CGAL that a "
        f"point refutes: {len(all_looked.table.refuted)}"
    )
    findings.figures = {"counts": dict(counts), "models": rows}
