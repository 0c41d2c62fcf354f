"""Times of features of a growing disc: read off the index at 20 diameters, beside CGAL's offsets
and our own static route at each."""

from __future__ import annotations

import json
import time
from dataclasses import dataclass
from fractions import Fraction
from statistics import median
from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.8, 2)
ALONE = True

MODELS: Counts[tuple[str, ...]] = Counts(
    ("bird",), ("bird", "neuron"), ("bird", "monkey", "neuron")
)
DIAMETERS = 20
LEAST, MOST = Fraction(1, 500), Fraction(1, 10)  # of the box's longer side
REPETITIONS = Counts(3, 3, 7)
TOLERANCE = 1e-3  # CGAL's approximated offset, relative to the radius
LIMIT = 60.0  # seconds for an offset
READ, BUILT = 10_000, 10  # times faster than CGAL's offsets


@dataclass(frozen=True)
class Spread:
    """Seconds of all repetitions."""

    seconds: list[float]

    @property
    def median(self) -> float:
        return median(self.seconds)

    def __str__(self) -> str:
        low, high = min(self.seconds), max(self.seconds)
        return f"{self.median:.3g} s ({low:.3g} to {high:.3g})"


def run(findings: Findings, size: Size) -> None:
    models: tuple[str, ...] = MODELS[size]
    tell_absent(findings, *models)
    for name in models:
        _times(findings, name, size)


def _times(findings: Findings, name: str, size: Size) -> None:
    known, P = operand(name).name, operand(name).set
    diameters = diameters_of(P)
    builds: list[float] = []
    firsts: list[float] = []
    reads: list[float] = []
    given = [float(diameter) for diameter in diameters]
    for _ in range(size.of(REPETITIONS)):
        found: Any = None  # what it frees would be sorted within the next one's first reading
        began = time.perf_counter()
        found = _core.features(P, 2)
        builds.append(time.perf_counter() - began)
        for repeated in range(size.of(REPETITIONS)):
            began = time.perf_counter()
            bridges = [len(found.near(diameter)[0]) for diameter in given]
            (reads if repeated else firsts).append(time.perf_counter() - began)
    built, first, read = Spread(builds), Spread(firsts), Spread(reads)
    began = time.perf_counter()
    exact = sum(len(feature[4]) for d in diameters for feature in found.at(str(d)))
    in_roots = time.perf_counter() - began
    findings.law(f"{known}: the bridges in doubles are as many as the exact ones",
                 sum(bridges) == exact, f"{exact:,}", f"{sum(bridges):,}")  # fmt: skip
    static = [_core.offset(P, str((d / 2) ** 2), 2).seconds for d in diameters]
    cgal = _cgal(P, diameters)
    findings.note(
        f"{known} ({P.vertices:,} vertices): features of {DIAMETERS} diameters from "
        f"{float(LEAST):g} to {float(MOST):g} of its size, {bridges[0]:,} to {bridges[-1]:,} "
        f"bridges: read in {read}, the first time after a build in {first}, with exact feet in "
        f"{in_roots:.3g} s; index, tree and bars built in {built}; our static route "
        f"{sum(static):.3g} s, CGAL's approximated offsets {_told(cgal)}"
    )
    if known != "neuron":
        return
    for what, mine, wanted in (
        (f"{DIAMETERS} readings of features", read.median, READ),
        ("the same with the build", first.median + built.median, BUILT),
    ):
        ratio = None if cgal is None else cgal / mine
        findings.target(f"{known}: CGAL's approximated offsets over {what}",
                        ratio is not None and ratio >= wanted, f"{wanted:,}",
                        "no answer" if ratio is None else f"{ratio:,.0f}")  # fmt: skip


def diameters_of(P: _core.PolygonSet) -> list[Fraction]:
    """Evenly spaced, with few digits."""
    xmin, ymin, xmax, ymax = P.bounding_box()
    length = max(xmax - xmin, ymax - ymin)
    return [
        Fraction(round(length * (LEAST + (MOST - LEAST) * k / (DIAMETERS - 1)) * 1000), 1000)
        for k in range(DIAMETERS)
    ]


def _cgal(P: _core.PolygonSet, diameters: list[Fraction]) -> float | None:
    """Seconds of all offsets; None if one has no answer."""
    rings = json.loads(P.canonical_json())
    total = 0.0
    with OffsetJudge(LIMIT) as judge:
        for diameter in diameters:
            seconds = judge.seconds_near(rings, diameter / 2, TOLERANCE * float(diameter / 2))
            if seconds is None:
                return None
            total += seconds
    return total


def _told(seconds: float | None) -> str:
    return "have no answer" if seconds is None else f"{seconds:.3g} s"
