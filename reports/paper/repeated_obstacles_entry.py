"""The entry on Fig. 11: an environment of 12 scaled copies of obstacles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from statistics import median

from minkref import _core
from minkref.reports.bench.repeated_obstacles import (
    AS_LISTED,
    COPIES,
    REPETITIONS,
    ROBOT,
    ROBOT_SCALE,
    SHARED_BY,
    Timed,
    placed_sums,
    timed,
)
from minkref.reports.drawing import Layer, picture
from minkref.reports.paper.entry import Claim, Entry, Picture, Table

COMMAND = "minkref report paper"
TITLE = "An environment with repeated obstacles"
DOUBLE, MPFR = "double", "mpfr:53"
STATED = 38.8  # times faster
DRAWN = 3  # shapes, of the environment in the pictures


def figure_11(quick: bool, tell: Callable[[str], None]) -> Entry:
    """Times the program on each environment, in MPFR and in doubles."""
    kinds = [(DOUBLE, DRAWN)] if quick else [(a, k) for a in (MPFR, DOUBLE) for k in SHARED_BY]
    return entry([timed(shapes, arithmetic, tell) for arithmetic, shapes in kinds])


def entry(runs: Sequence[Timed]) -> Entry:
    """The entry for the runs, at least one."""
    why = (
        f"The paper's own program, each formula in its right form, with events of pairs of edges "
        f"alone, one program for each distinct shape, begun at the scale 1: stepping to the scale "
        f"of each of {COPIES} copies and placing all intersections, against the search of all "
        f"pairs of edges for each copy in the same arithmetic. No union is part of it, nor are "
        f"loops or collision detection; places of copies change no intersection. {REPETITIONS} "
        "repetitions, which take both sides in turn. Neither the number of copies of a shape nor "
        "the order of the walk is given in the paper: both are varied. The exact union of such "
        "copies, from end to end, stands beside CGAL and GEOS in the evidence (scenes/times)."
    )
    unlike = [
        f"the environment: models of ours, stretched, and {ROBOT} at {ROBOT_SCALE} as the robot",
        "the scales of the copies, at random from 0.3 to 2: the paper gives none",
    ]
    columns = ["shapes", "arithmetic", "edges", "events", "intersections", "from scratch (ms)",
               "order", "update (ms)", "speed-up", "least", "greatest", "pre-processing (ms)",
               "copies that pay it back"]  # fmt: skip
    rows = [row for run in runs for row in _rows(run)]
    return Entry("Fig. 11", TITLE, why, COMMAND, _claims(runs), unlike, _pictures(),
                 [Table("figure11", columns, rows)])  # fmt: skip


def _rows(run: Timed) -> list[list[object]]:
    rows: list[list[object]] = []
    for order, seconds in run.orders.items():
        ratios = run.speedup(order)
        rows.append([
            run.shapes, run.arithmetic, run.edges, run.events, run.intersections,
            f"{1e3 * median(run.scratch):.2f}", order, f"{1e3 * median(seconds):.3f}",
            f"{median(ratios):.1f}", f"{ratios[0]:.1f}", f"{ratios[-1]:.1f}",
            f"{1e3 * run.preprocessing:.1f}", f"{run.pays_after(order):.0f}",
        ])  # fmt: skip
    return rows


def _claims(runs: Sequence[Timed]) -> list[Claim]:
    """In the first arithmetic, the paper's own if it was timed."""
    arithmetic = runs[0].arithmetic
    mine = [run for run in runs if run.arithmetic == arithmetic]
    speeds = [(run, run.speedup(AS_LISTED)) for run in mine]
    fast = [median(ratios) >= STATED for _, ratios in speeds]
    soon = [run.pays_after(AS_LISTED) <= COPIES for run in mine]
    return [
        Claim("a speed-up factor of 38.8 over recomputing the intersections from scratch",
              "Sec. 8.1",
              f"{arithmetic}, copies as listed: the median speed-up is at least {STATED}",
              "; ".join(
                  f"{_copies(run)} {median(r):,.1f} times ({r[0]:,.1f} to {r[-1]:,.1f})"
                  for run, r in speeds
              ), any(fast), not all(fast)),
        Claim("Very few scaling requests are necessary to make up the difference caused by "
              "pre-processing", "Sec. 8.1",
              f"{arithmetic}: the {COPIES} copies themselves make up for it",
              "copies that do so: "
              + "; ".join(f"{_copies(run)} {run.pays_after(AS_LISTED):.0f}" for run in mine),
              any(soon), not all(soon)),
    ]  # fmt: skip


def _copies(run: Timed) -> str:
    return f"of {run.shapes} shape{'s' * (run.shapes > 1)}"


def _pictures() -> list[Picture]:
    found = placed_sums(DRAWN)
    region, components, holes = _core.combined("union", [total for _, total in found])
    obstacles = [shape.approximate_rings() for shape, _ in found]
    blocked = region.approximate_rings()
    drawn = [ring for rings in obstacles for ring in rings]
    return [
        Picture("(a) the obstacles, 12 copies of three shapes",
                picture([Layer("first", drawn)], "obstacles", 420)),
        Picture(f"(b) the places that the robot may not take: {components} components, {holes} "
                "holes; the obstacles within",
                picture([Layer("sum", blocked), Layer("first", drawn)], "C-space", 420)),
    ]  # fmt: skip
