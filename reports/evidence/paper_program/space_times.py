"""Fig. 9 on the paper's own terms: an update of the crossings in space, all of them placed, and one
of the whole sum, against finding them from scratch in the same arithmetic."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.reports.bench.space_pairs import EVENT_PAIRS, TimedPair
from minkref.reports.bench.spread import spread
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, None, 40)
ALONE = True

SEED = 9
CORRECTED = {name: corrected for name, _, corrected, _ in _core.space_update_readings()}
WINDOW = (200, 2000)  # thousandths: the paper's [0.2, 2]
STEPS = 12
BEST_OF = 3
SUMS = 2  # of a pair, timed whole


@dataclass(frozen=True)
class Step:
    """Seconds, the best of several."""

    events: int
    crossings: int
    update: float
    placing: float
    scratch: float


def timed_steps(update: _core.PaperSpaceUpdate, name: str, searches: int) -> list[Step]:
    """Random re-scalings; the search from scratch is repeated so many times at each."""
    dice = random.Random(f"minkref figure 9 {name} {SEED}")
    chosen = [f"{dice.randint(*WINDOW)}/1000" for _ in range(STEPS + 1)]
    steps = []
    update.move_to(chosen[0])
    for start, scale in pairwise(chosen):
        updates, placings = [], []
        for _ in range(BEST_OF):
            update.move_to(start)
            counts, seconds = update.move_to(scale)
            updates.append(seconds)
            placed, seconds = update.place_intersections()
            placings.append(seconds)
        scratch = min(update.search_intersections(scale)[1] for _ in range(searches))
        events = counts["insertions"] + counts["deletions"]
        steps.append(Step(events, placed, min(updates), min(placings), scratch))
    return steps


def run(findings: Findings, size: Size) -> None:
    pair, smaller = EVENT_PAIRS[2] if size is Size.FULL else EVENT_PAIRS[0], EVENT_PAIRS[1]
    for chosen, arithmetic in ((pair, "double"), (smaller, "double"), (smaller, "mpfr:53")):
        if arithmetic != "double" and size is not Size.FULL:
            continue
        _time(chosen, arithmetic, findings)


def _time(pair: TimedPair, arithmetic: str, findings: Findings) -> None:
    P, Q = map(core_polyhedron, pair.solids())
    update = _core.PaperSpaceUpdate(P, Q, "1", arithmetic, CORRECTED, threads=2)
    steps = timed_steps(update, pair.name, 1 if arithmetic != "double" else 2)
    counts = dict(update.counts())
    whole = [_whole(update, scale) for scale in ("1/2", "3/2")[:SUMS]]
    figures = {
        "facets": counts["facets"],
        "events": counts["events"],
        "seconds for the events": round(update.seconds, 1),
        "events crossed": _spread(steps, lambda s: s.events, ""),
        "crossings placed": _spread(steps, lambda s: s.crossings, ""),
        "update with placing, µs": _spread(steps, lambda s: 1e6 * (s.update + s.placing), ""),
        "placing, µs": _spread(steps, lambda s: 1e6 * s.placing, ""),
        "ns for an event": _spread(
            [s for s in steps if s.events], lambda s: 1e9 * s.update / s.events, ""
        ),
        "from scratch, s": _spread(steps, lambda s: s.scratch, ""),
        "(d): times faster, crossings alone": _spread(
            steps, lambda s: s.scratch / (s.update + s.placing), ""
        ),
        "(c): times faster, with arrangements and collision detection": [
            round((steps[0].scratch + seconds) / (steps[0].update + steps[0].placing + seconds), 3)
            for seconds in whole
        ],
        "arrangements and collision detection, s": [round(seconds, 2) for seconds in whole],
    }
    findings.figures[f"{pair.name}, {arithmetic}"] = figures
    findings.note(f"{pair.name}, {arithmetic}: " + "; ".join(
        f"{name}: {value}" for name, value in figures.items()))  # fmt: skip
    faster = min(s.scratch / (s.update + s.placing) for s in steps)
    findings.target(
        f"{pair.name}, {arithmetic}: crossings are updated faster than found from scratch",
        faster > 1, "more than 1 time", f"{faster:,.1f} times at least",
    )  # fmt: skip


def _whole(update: _core.PaperSpaceUpdate, scale: str) -> float:
    update.move_to(scale)
    return float(update.sum().seconds)


def _spread(steps: list[Step], value: Callable[[Step], float], unit: str) -> Any:
    return spread([value(step) for step in steps]).in_words() + unit
