"""The index of all radii of a sum with a disc: queries give the static sum at any radius; and their
speed."""

from __future__ import annotations

import json
import random
import statistics
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge
from minkref.fuzz.judges.disc.offset_comparison import grid_set
from minkref.fuzz.judges.disc.offset_sandwich import sandwich
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.8, 12)

SEED = 1911
SETS = Counts(20, 100, 1000)
RADII, PORTIONS = Counts(10, 100, 1000), Counts(1, 2, 20)
LARGE = ("neuron", "monkey", "bird")
ROUNDS = 20
BUILDS = Counts(1, 3, 5)
LEAST = Counts(50, 500, 7000)
WITHIN = Fraction(1, 1000)  # relative to the radius: polygons of 72 corners
PARTS = (Fraction(1, 300), Fraction(7, 300), Fraction(1, 15))  # radii relative to the box's length
TOLERANCE = 1e-3  # CGAL's approximated offset, relative to the radius
EXACT_SECONDS = 40.0


@dataclass
class Looked:
    counts: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    misfits: list[str] = field(default_factory=list)  # between polygons

    def add(self, other: Looked) -> None:
        self.counts.update(other.counts)
        self.faults += other.faults
        self.misfits += other.misfits


def compare_at(index: _core.DiscIndex, P: _core.PolygonSet, square: Fraction, looked: Looked,
               where: str) -> None:  # fmt: skip
    text = str(square)
    static = _core.offset(P, text)
    looked.counts["at events" if index.at_event(text) else "between events"] += 1
    looked.counts["holes"] += static.holes
    same = index.canonical_json(text) == static.canonical_json()
    same &= index.counts(text) == (static.components, static.holes)
    for (low, high), (least, most) in zip(
        index.measures(text), (static.area, static.length), strict=True
    ):
        same &= low <= most and least <= high
    if not same:
        looked.faults.append(f"{where}, squared radius {square}")
    told = sandwich(P, square, index.counts(text), index.measures(text)[0], WITHIN)
    looked.counts["with as many holes by polygons in and around the disc"] += told.same_holes
    looked.misfits += [f"{where}, squared radius {square}: {fault}" for fault in told.faults]


def squares(index: _core.DiscIndex, P: _core.PolygonSet, wanted: int,
            source: random.Random) -> list[Fraction]:  # fmt: skip
    """Squared radii: half come from random gaps between events, half from events with rational
    squares, as far as these exist."""
    bounds = index.radii()
    rational = [
        Fraction(square)
        for _, square, _, _, _, _ in _core.diagram_events(P).rows(0, 10**9)
        if square is not None
    ]
    found = source.sample(rational, min(wanted // 2, len(rational)))
    while bounds and len(found) < wanted:
        gap = source.randint(0, len(bounds))
        low = Fraction(bounds[gap - 1][1]) if gap > 0 else Fraction(0)
        high = Fraction(bounds[gap][0]) if gap < len(bounds) else 2 * low + 1
        if low < high:
            part = Fraction(source.randint(1, 99), 100)
            near = (low + (high - low) * part).limit_denominator(int(100 / (high - low)) + 1000)
            found.append(near**2 if near > 0 else high**2 / 4)
    return found


def of_grid(number: int) -> Looked:
    looked = Looked()
    source = random.Random(f"minkref disc index {SEED}:{number}")
    P = grid_set(source)
    if P.is_empty:
        return looked
    index = _core.disc_index(P)
    looked.counts["sets"] += 1
    for square in squares(index, P, 6, source):
        compare_at(index, P, square, looked, f"grid {number}")
    return looked


def of_model(task: tuple[str, int, int]) -> Looked:
    name, part, count = task
    looked = Looked()
    P = operand(name).set
    index = _core.disc_index(P)
    for square in squares(index, P, count, random.Random(f"minkref disc index {name}:{part}")):
        compare_at(index, P, square, looked, name)
    return looked


def run(findings: Findings, size: Size) -> None:
    tell_absent(findings, *LARGE)
    all_looked = Looked()
    models = LARGE[-1:] if size is Size.QUICK else LARGE
    count = size.of(RADII) // 20
    tasks = [(name, part, count) for name in models for part in range(size.of(PORTIONS))]
    speeds = [_speed(name, size, findings) for name in models]
    for looked in in_processes(of_grid, range(size.of(SETS)), each=20):
        all_looked.add(looked)
    for looked in in_processes(of_model, tasks, each=1):
        all_looked.add(looked)
    counts = all_looked.counts
    findings.none("radii at which what is read off is not the static sum", all_looked.faults)
    findings.none(
        "radii at which it does not fit between polygons in and around the disc", all_looked.misfits
    )
    looked_at = counts["at events"] + counts["between events"]
    wanted = size.of(LEAST)
    findings.law("radii compared", looked_at >= wanted, f"{wanted:,}", f"{looked_at:,}")
    findings.note(
        f"seed {SEED}: {counts['sets']:,} sets of cells and {len(models)} large polygons, "
        f"{counts['between events']:,} radii between events, {counts['at events']:,} at events; "
        f"{counts['holes']:,} holes in all; at "
        f"{counts['with as many holes by polygons in and around the disc']:,} radii sums with "
        "polygons in and around the disc have one number of holes, that of the disc"
    )
    findings.figures = {"counts": dict(counts), "speed": speeds}


def _speed(name: str, size: Size, findings: Findings) -> dict[str, Any]:
    known, P = operand(name).name, operand(name).set
    builds = [_core.disc_index(P, 2) for _ in range(size.of(BUILDS))]
    build = statistics.median(index.seconds for index in builds)
    index = builds[0]
    again = min(_core.disc_index(P, 2, index.places()).seconds for _ in builds)
    bounds = [low for low, _ in index.radii()]
    radii = [bounds[k * (len(bounds) - 1) // 100] * 1.0000001 for k in range(100)]
    query = min(index.seconds_of_queries(radii, ROUNDS) for _ in range(5)) / len(radii)
    findings.note(
        f"{known} ({P.vertices:,} vertices): {len(index):,} radii of events, {index.parts:,} parts "
        f"of the diagram; built in {build:.3f} s on two threads, proven again from a file in "
        f"{again:.3f} s; a query of all vertices {query * 1e6:.1f} µs in the mean of 100 radii"
    )
    if name == "neuron":
        findings.target(f"{known}: seconds to build the index, two threads", build <= 0.3,
                        "at most 0.3", f"{build:.3f}")  # fmt: skip
    xmin, ymin, xmax, ymax = P.bounding_box()
    length = max(xmax - xmin, ymax - ymin)
    radii_of_cgal = [Fraction(round(float(length * part) * 1000), 1000) for part in PARTS]
    return {
        "model": known, "build": build, "again": again, "query": query, "events": len(index),
        "parts": index.parts,
        "beside cgal": [
            _beside_cgal(known, P, index, radius, size, findings)
            for radius in (radii_of_cgal if size is Size.FULL else radii_of_cgal[:1])
        ],
    }  # fmt: skip


def _beside_cgal(name: str, P: _core.PolygonSet, index: _core.DiscIndex, radius: Fraction,
                 size: Size, findings: Findings) -> dict[str, Any]:  # fmt: skip
    """Times a query and CGAL's offsets at one radius."""
    one = min(index.seconds_of_queries([float(radius)], ROUNDS) for _ in range(5))
    points, _ = index.vertices(float(radius))
    rings = json.loads(P.canonical_json())
    with OffsetJudge(EXACT_SECONDS if size is Size.FULL else 20.0) as judge:
        near = judge.seconds_near(rings, radius, TOLERANCE * float(radius))
    with OffsetJudge(EXACT_SECONDS) as judge:
        exact = judge.offset(rings, radius).seconds if size is Size.FULL else None
    findings.note(
        f"{name}, radius {radius}: a query of all {len(points):,} vertices {one * 1e6:.1f} µs, the "
        f"largest bound of an error {max((float(p[2]) for p in points), default=0):.1g}; CGAL's "
        f"approximated offset {_told(near, one)}, its exact one {_told(exact, one)}"
    )
    if name.startswith("neuron") and size is Size.FULL:
        for what, theirs, wanted in (("approximated", near, 10_000), ("exact", exact, 500_000)):
            ratio = None if theirs is None else theirs / one
            findings.target(f"{name}: CGAL's {what} offset over a query at radius {radius}",
                            ratio is not None and ratio >= wanted, f"{wanted:,}",
                            "no answer" if ratio is None else f"{ratio:,.0f}")  # fmt: skip
    return {"radius": str(radius), "query": one, "vertices": len(points), "cgal_near": near,
            "cgal_exact": exact}  # fmt: skip


def _told(seconds: float | None, query: float) -> str:
    if seconds is None:
        return "has no answer"
    return f"{seconds:.2f} s, {seconds / query:,.0f} queries"
