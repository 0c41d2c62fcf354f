"""Fig. 9: facet intersections, updated by events from scale to scale, against finding them from
scratch."""

from __future__ import annotations

import os
import random
import time
from collections.abc import Callable
from itertools import pairwise
from statistics import median

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.reports.bench.space_pairs import EVENT_PAIRS, TimedPair
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.plots import speedup_plot, time_plot
from minkref.reports.paper.speedup_entries import LEAST_FOR_RANKS
from minkref.reports.paper.speedups import Rescaling, Speedups

COMMAND = "minkref report paper"
WINDOW = ("1/5", "2")
STEPS, QUICK_STEPS = 24, 12
REPETITIONS = 3
UNIT = 9973  # scales are multiples of 1/UNIT; events there are unlikely
PAIR, QUICK_PAIR = EVENT_PAIRS[2], EVENT_PAIRS[0]


def figure_9(quick: bool, seed: int, tell: Callable[[str], None]) -> Entry:
    pair = QUICK_PAIR if quick else PAIR
    tell(f"events of {pair.name}")
    found, counts, seconds = _followed(pair, seed, QUICK_STEPS if quick else STEPS)
    speed = [one.speedup for one in found.rescalings]
    threads = min(2, os.cpu_count() or 1)
    why = (
        f"The models are not published with the paper; ours are a torus knot and a clutch or a "
        f"sphere ({pair.name}). {counts['facets']:,} facets of the convolution have "
        f"{counts['events']:,} events of two facets, exact, on the paper's window [1/5, 2], found "
        f"in {seconds:.1f} s on {threads} threads. The paper has 8,427,881 events in some 65 "
        f"minutes; what it counts is not told, so that rates compare no equal work (pairs of its "
        f"size are a part of the evidence: `make evidence ONLY=space_costs/events`). As in (b), "
        f"the list of facets that meet is updated by the events, and found from scratch by boxes "
        f"and the same exact tests, without the places where they meet on either side, at "
        f"{len(speed)} random re-scalings, each timed {REPETITIONS} times: {min(speed):,.0f} to "
        f"{max(speed):,.0f} times faster, median {median(speed):,.0f}. "
        f"Not compared: (a), the whole update. What follows the intersections, their order and "
        f"collision detection, is not done from scale to scale here."
    )
    claims = [
        Claim("updating the intersections is faster than finding them from scratch",
              f"at least {min(speed):,.1f} times", min(speed) > 1)
    ]  # fmt: skip
    if len(speed) >= LEAST_FOR_RANKS:
        falls = found.correlation_of(lambda one: one.speedup, lambda one: one.events)
        claims.append(Claim("the speed-up falls with the number of events",
                            f"rank correlation {falls:+.2f}", falls < 0))  # fmt: skip
    label = "events processed"
    pictures = [
        Picture("(b) speed-up of the intersections",
                speedup_plot(found.rescalings, "events", label)),
        Picture("time of the update", time_plot(found.rescalings, "events", label)),
    ]  # fmt: skip
    columns = ["from", "to", "events", "meeting", "update (s)", "from scratch (s)", "speedup"]
    rows = [[one.start, one.scale, one.events, one.updated, round(one.update_seconds, 7),
             round(median(one.theirs), 6), round(one.speedup, 2)]
            for one in found.rescalings]  # fmt: skip
    return Entry("Fig. 9", "Knot and clutch, uniform scaling in space", why, COMMAND, claims,
                 pictures=pictures, tables=[Table("figure9", columns, rows)])  # fmt: skip


def _followed(pair: TimedPair, seed: int, steps: int) -> tuple[Speedups, dict[str, int], float]:
    P, Q = map(core_polyhedron, pair.solids())
    began = time.perf_counter()
    events = _core.space_events(P, Q, *WINDOW, threads=min(2, os.cpu_count() or 1))
    seconds = time.perf_counter() - began
    dice = random.Random(f"minkref figure 9 {seed}")
    first, last = UNIT // 5 + 1, 2 * UNIT - 1
    scales = [f"{dice.randint(first, last)}/{UNIT}" for _ in range(steps + 1)]
    crossing = _core.CrossingFacets(events, scales[0])
    rescalings = []
    for start, scale in pairwise(scales):
        ours, theirs = [], []
        for repetition in range(REPETITIONS):
            if repetition:
                crossing.move_to(start)
            count, spent = crossing.move_to(scale)
            ours.append(spent)
            pairs, spent = _core.meeting_facets(events, scale)
            theirs.append(spent)
        if crossing.pairs() != pairs:
            raise AssertionError(f"the facets that meet at {scale} are not those from scratch")
        rescalings.append(Rescaling(start, scale, count, len(pairs), tuple(ours), tuple(theirs)))
    counts = {"facets": dict(events.counts())["facets"], "events": len(events)}
    return Speedups(pair.name, "rational", counts["facets"], seconds, rescalings), counts, seconds
