"""Discs on paths, in containers and in traps, and parts that keep a distance, before a judge of all
pairs; the time of a large one beside CGAL's approximated offsets."""

from __future__ import annotations

import json
import time
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import minkref
from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge
from minkref.fuzz.judges.motion.clear_brackets import bracket_case, bracket_faults
from minkref.fuzz.judges.motion.disc_comparison import clearance_faults, disc_faults, fit_faults
from minkref.fuzz.judges.motion.disc_draws import disc_case, rings_of
from minkref.fuzz.motion.path_cases import path_case
from minkref.plane.operand import read_operand
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.5, 6)
ALONE = True  # it measures time

SEED = 3180
CASES = Counts(12, 60, 500)
CLEARANCES = Counts(6, 30, 200)
FITS = Counts(2, 20, 200)
BRACKETS = Counts(4, 20, 200)
MODEL = "glyph1204"
RUNS = 5  # the shortest counts
HALVINGS = Counts(1, 4, 20)  # of a bracket as wide as the radius; 20 lead to a millionth of it
TOLERANCE = 1e-7  # of CGAL's offset, relative to the radius
TARGET_SECONDS = 0.01
TARGET_RATIO = 100.0


def run(findings: Findings, size: Size) -> None:
    cases, clearances = size.of(CASES), size.of(CLEARANCES)
    tally: Counter[str] = Counter()
    faults: list[str] = []
    counts = {
        "disc": cases, "clear": clearances, "fit": size.of(FITS), "bracket": size.of(BRACKETS),
    }  # fmt: skip
    tasks = [(kind, index) for kind, count in counts.items() for index in range(count)]
    for found in in_processes(judge, tasks, 50, "discs and clearances"):
        tally.update(found["tally"])
        faults += found["faults"]
    findings.none("answers that differ from a judge of all pairs", faults)
    findings.equal("paths of discs", cases, tally["paths"])
    findings.equal("containers with two places", cases, tally["ways"])
    findings.equal("rooms for parts with a clearance", counts["bracket"], tally["brackets"])
    findings.law("ways through a neck", tally["ways, neck"] > 0, "some", tally["ways, neck"])
    findings.law("traps with a neck", tally["traps, neck"] > 0, "some", tally["traps, neck"])
    findings.note(_told(tally))
    findings.figures["discs"] = dict(tally)
    _speed(findings, size.of(HALVINGS))


def _told(tally: Counter[str]) -> str:
    return (
        f"seed {SEED}: {tally['paths']:,} paths of discs ({tally['paths that meet the set']:,} of "
        f"them meet the set), {tally['places']:,} places in containers, {tally['ways']:,} ways "
        f"({tally['ways, neck']:,} with a neck, {tally['ways, apart']:,} between rooms), "
        f"{tally['traps']:,} places among obstacles ({tally['traps, neck']:,} traps with a neck, "
        f"{tally['traps, apart']:,} closed): squared radii exact; {tally['clearances']:,} paths "
        f"of parts with a clearance, {tally['ends']:,} ends ({tally['ends with a root']:,} with "
        f"roots), {tally['scales']:,} scales decided at and beside them; {tally['fits']:,} fits "
        f"with a clearance, {tally['scales of fits']:,} scales; {tally['brackets']:,} rooms for "
        f"parts with a clearance, {tally['grids']:,} brackets on a grid, {tally['exact ends']:,} "
        f"with an exact end, {tally['traps']:,} traps"
    )


def judge(task: tuple[str, int]) -> dict[str, Any]:
    """One case."""
    kind, index = task
    tally: Counter[str] = Counter()
    if kind == "disc":
        found = disc_faults(disc_case(SEED, index), tally)
    elif kind == "clear":
        found = clearance_faults(path_case(SEED, index), tally, index)
    elif kind == "bracket":
        found = bracket_faults(bracket_case(SEED, index), tally)
    else:
        found = fit_faults(disc_case(SEED, index), tally, index)
    return {"faults": list(found), "tally": tally}


def _speed(findings: Findings, halvings: int) -> None:
    """A path around a set of many edges, and CGAL's offsets at the radii of a search, without what
    a search has to ask them."""
    obstacles = read_operand(MODEL).set
    path = _way_around(obstacles)
    found = minkref.valid_radii(obstacles, path)
    assert found.high is not None
    ours = _shortest(lambda: _core.disc_on_path(obstacles, path))
    trap = _shortest(lambda: minkref.trapped_radii(obstacles, path[0]))
    radius = Fraction(found.high.bounds[0])
    theirs = _cgal(obstacles, radius, halvings)
    told = "no answer" if theirs is None else f"{theirs:.3g} s"
    findings.note(
        f"{MODEL} ({obstacles.vertices:,} vertices), a path of {len(path) - 1} segments: the exact "
        f"radius in {ours * 1e3:.3g} ms; CGAL's approximated offsets at {halvings} of the "
        f"20 radii of a search to a millionth {told}; whether a disc is trapped, with the diagram, "
        f"in {trap:.3g} s"
    )
    findings.figures["speed"] = {"path": ours, "trap": trap, "cgal": theirs}
    findings.target(f"{MODEL}: seconds for the radius of a path", ours <= TARGET_SECONDS,
                    f"{TARGET_SECONDS}", f"{ours:.3g}")  # fmt: skip
    ratio = None if theirs is None else theirs / ours
    findings.target(f"{MODEL}: CGAL's offsets over it",
                    ratio is not None and ratio >= TARGET_RATIO, f"{TARGET_RATIO:,.0f}",
                    "no answer" if ratio is None else f"{ratio:,.0f}")  # fmt: skip


def _way_around(obstacles: _core.PolygonSet) -> list[tuple[str, str]]:
    """A hundred segments around the box of a set, at a fifth of its width."""
    corners = [p for ring in rings_of(obstacles) for p in ring]
    xs, ys = [x for x, _ in corners], [y for _, y in corners]
    far = (max(xs) - min(xs)) / 5
    low_x, high_x, low_y, high_y = min(xs) - far, max(xs) + far, min(ys) - far, max(ys) + far
    steps = 25
    sides = [
        ((low_x, low_y), (high_x, low_y)),
        ((high_x, low_y), (high_x, high_y)),
        ((high_x, high_y), (low_x, high_y)),
        ((low_x, high_y), (low_x, low_y)),
    ]
    places = [
        (a[0] + (b[0] - a[0]) * Fraction(k, steps), a[1] + (b[1] - a[1]) * Fraction(k, steps))
        for a, b in sides
        for k in range(steps)
    ]
    return [(str(x), str(y)) for x, y in [*places, places[0]]]


def _shortest(act: Callable[[], object]) -> float:
    seconds = []
    for _ in range(RUNS):
        began = time.perf_counter()
        act()
        seconds.append(time.perf_counter() - began)
    return min(seconds)


def _cgal(obstacles: _core.PolygonSet, radius: Fraction, halvings: int) -> float | None:
    """Seconds of CGAL's functions; None if it has no answer."""
    P = json.loads(obstacles.to_json())
    total = 0.0
    low, high = radius / 2, 2 * radius
    with OffsetJudge(300) as oracle:
        for _ in range(halvings):
            middle = (low + high) / 2
            seconds = oracle.seconds_near(P, middle, float(radius) * TOLERANCE)
            if seconds is None:
                return None
            total += seconds
            low, high = (middle, high) if middle <= radius else (low, middle)
    return total
