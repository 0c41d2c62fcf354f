"""Fig. 9 on the paper's own terms: an update of the crossings in space, all of them placed, and one
of the whole sum, against finding them from scratch in the same arithmetic."""

from __future__ import annotations

import datetime
import random
import time
from collections.abc import Callable, Sequence
from itertools import pairwise
from statistics import median
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.reports.bench.space_pairs import EVENT_PAIRS, UPDATE_PAIRS, TimedPair
from minkref.reports.bench.spread import spread
from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.paper.space_times import FILE, Step, Timed, Times, as_text

MINUTES = Minutes(None, None, 6)
ALONE = True

SEED = 9
CORRECTED = {name: corrected for name, _, corrected, _ in _core.space_update_readings()}
WINDOW = (200, 2000)  # thousandths: the paper's [0.2, 2]
THREADS = 2
STEPS = 16
BEST_OF, SEARCHES = 5, 2  # of updates, of searches among facets whose boxes meet
TRIES = 20  # random scales for each step with an event
PATIENCE = 8.0  # processor seconds for searches among all pairs, and for sums
MPFR, DOUBLE = "mpfr:53", "double"
PAIRS = {DOUBLE: (*UPDATE_PAIRS, EVENT_PAIRS[1]), MPFR: UPDATE_PAIRS}


def run(findings: Findings, size: Size) -> None:
    runs = []
    for arithmetic, pairs in PAIRS.items():
        for pair in pairs:
            timed = time_pair(pair, arithmetic)
            runs.append(timed)
            _tell(timed, findings)
    if size is Size.FULL:
        today = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
        times = Times(today, "[1/5, 2]", BEST_OF, SEARCHES, tuple(runs))
        (ROOT / "reports" / "paper" / FILE).write_text(as_text(times), encoding="utf-8")


def time_pair(pair: TimedPair, arithmetic: str) -> Timed:
    P, Q = map(core_polyhedron, pair.solids())
    began = time.process_time()
    update = _core.PaperSpaceUpdate(P, Q, "1", arithmetic, CORRECTED, threads=THREADS)
    preparation = time.process_time() - began
    counts = dict(update.counts())
    scales = _scales(update, f"{pair.name} {SEED}")
    searches = _patiently(scales, lambda scale: _seconds(update.search_intersections, scale))
    steps = [_step(update, start, scale) for start, scale in pairwise(scales)]
    sums = _patiently(scales[1:], lambda scale: _whole(update, scale))
    timed = Timed(
        pair.name, arithmetic, counts["facets"], counts["crossings"], counts["events"],
        preparation, median(searches),
        tuple(
            Step(**step, whole=sums[k] if k < len(sums) else None) for k, step in enumerate(steps)
        ),
    )  # fmt: skip
    print(timed, flush=True)
    return timed


def _scales(update: _core.PaperSpaceUpdate, seed: str) -> list[str]:
    """Random scales of the window, with an event at least between each and the next."""
    dice = random.Random(f"minkref figure 9 {seed}")
    scales = [f"{dice.randint(*WINDOW)}/1000"]
    update.move_to(scales[0])
    for _ in range(TRIES * STEPS):
        if len(scales) > STEPS:
            break
        scale = f"{dice.randint(*WINDOW)}/1000"
        if _events(update.move_to(scale)[0]):
            scales.append(scale)
        else:
            update.move_to(scales[-1])
    return scales


def _events(counts: dict[str, int]) -> int:
    return counts["insertions"] + counts["deletions"]


def _step(update: _core.PaperSpaceUpdate, start: str, scale: str) -> dict[str, Any]:
    """A step's fields, but for the whole sum."""
    updates, placings = [], []
    for _ in range(BEST_OF):
        update.move_to(start)
        counts, seconds = update.move_to(scale)
        updates.append(seconds)
        crossings, seconds = update.place_intersections()
        placings.append(seconds)
    return {
        "start": start,
        "scale": scale,
        "events": _events(counts),
        "crossings": crossings,
        "update": min(updates),
        "placing": min(placings),
        "near": min(_seconds(update.search_intersections, scale, True) for _ in range(SEARCHES)),
    }


def _whole(update: _core.PaperSpaceUpdate, scale: str) -> float:
    update.move_to(scale)
    return _seconds(update.sum)


def _seconds(work: Callable[..., object], *given: object) -> float:
    """This thread's processor seconds for some work: others may have the machine."""
    began = time.thread_time()
    work(*given)
    return time.thread_time() - began


def _patiently(scales: Sequence[str], seconds: Callable[[str], float]) -> list[float]:
    """The first scale's, and those of more while patience lasts."""
    found = [seconds(scales[0])]
    for scale in scales[1:]:
        if sum(found) > PATIENCE:
            break
        found.append(seconds(scale))
    return found


def _tell(timed: Timed, findings: Findings) -> None:
    where = f"{timed.name}, {timed.arithmetic}"
    figures = {
        "facets": timed.facets,
        "events": timed.events,
        "seconds for the events": round(timed.preparation, 2),
        "seconds for a search among all pairs": round(timed.search, 3),
        "steps": len(timed.steps),
        "(d): times faster": spread(timed.intersections()).in_words(),
        "(d), against all pairs": spread(timed.intersections(True)).in_words(),
        "(c): times faster": spread(timed.total()).in_words(3),
        "(c), against all pairs": spread(timed.total(True)).in_words(3),
    }
    findings.figures[where] = figures
    findings.note(f"{where}: " + "; ".join(f"{name}: {value}" for name, value in figures.items()))
    least = timed.intersections()[0]
    findings.target(
        f"{where}: crossings are updated faster than found from scratch",
        least > 1, "more than 1 time", f"{least:,.1f} times at least",
    )  # fmt: skip
    findings.law(f"{where}: steps have events", bool(timed.steps), "at least 1", len(timed.steps))
