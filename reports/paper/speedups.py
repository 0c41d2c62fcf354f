"""Single re-scalings by the paper's own program, against the number of processed events, updated
intersections, and the change of scale (Fig. 7 and 8 of the paper). Uses pair events only, stores no
lists between re-scalings, and measures both sides of each ratio in one arithmetic."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from statistics import median

from minkref import _core
from minkref.reports.bench.pairs import Pair
from minkref.reports.bench.rank_correlation import Interval, rank_correlation, stronger_by
from minkref.reports.bench.rescalings import rescalings
from minkref.reports.bench.spread import Spread, spread

REPETITIONS = 5
SEED = 1
#: All formulas corrected: printed formulas lose most intersections.
READINGS = {name: corrected for name, _, corrected, _ in _core.paper_readings()}


@dataclass(frozen=True)
class Rescaling:
    """A step from one scale to another. `events`: insertions and deletions on the way. `updated`:
    intersections at the end, which get a new place. `ours` and `theirs`: seconds for the update,
    and for a search among all edge pairs, per repetition. `stepping`: seconds of `ours` for
    stepping through the events, without placing intersections."""

    start: str
    scale: str
    events: int
    updated: int
    ours: tuple[float, ...]
    theirs: tuple[float, ...]
    stepping: tuple[float, ...] = ()

    @property
    def factor(self) -> float:
        """By how much the scale changes, up or down; at least 1."""
        factor = Fraction(self.scale) / Fraction(self.start)
        return float(max(factor, 1 / factor))

    @property
    def seconds(self) -> list[float]:
        """Update seconds of all repetitions, sorted."""
        return sorted(self.ours)

    @property
    def update_seconds(self) -> float:
        return median(self.ours)

    @property
    def ratios(self) -> list[float]:
        """Each repetition's ratio, sorted."""
        return sorted(b / a for a, b in zip(self.ours, self.theirs, strict=True))

    @property
    def speedup(self) -> float:
        return median(self.ratios)

    @property
    def best(self) -> float:
        """Either side's least time, as a ratio."""
        return min(self.theirs) / min(self.ours)


Value = Callable[[Rescaling], float]


@dataclass(frozen=True)
class Speedups:
    """A pair's speed-ups in one arithmetic. `pairs` counts the examined edge pairs.
    `preprocessing`: processor seconds for finding the critical regions of all pairs and sorting
    their events; `nodes`: processor seconds of each search."""

    pair: str
    arithmetic: str
    pairs: int
    preprocessing: float
    rescalings: Sequence[Rescaling]
    nodes: Sequence[float] = ()

    def correlation_of(self, value: Value, other: Value) -> Interval:
        """The rank correlation between two values."""
        return rank_correlation(self._each(value), self._each(other))

    def predicted_better(self, value: Value, first: Value, second: Value) -> Interval:
        """By how much stronger the first predictor's rank correlation with the value is."""
        return stronger_by(self._each(value), self._each(first), self._each(second))

    def _each(self, value: Value) -> list[float]:
        return [value(one) for one in self.rescalings]

    @property
    def speed(self) -> Spread:
        """Single re-scalings, each with the median of its repetitions, as a spread."""
        return spread(self._each(lambda one: one.speedup))

    @property
    def density(self) -> Spread:
        """Events processed over intersections updated, as a spread."""
        return spread(self._each(lambda one: one.events / max(one.updated, 1)))

    @property
    def search(self) -> float:
        """Median processor seconds for a search."""
        return median(self.nodes)

    @property
    def update(self) -> float:
        return median(t for one in self.rescalings for t in one.ours)

    @property
    def break_even(self) -> float:
        """From how many queries on it pays to have found all events: the pre-processing over what a
        re-scaling saves, both medians (the clock's for the update, which is short)."""
        return self.preprocessing / (self.search - self.update)


def speedups(pair: Pair, arithmetic: str, count: int, tell: Callable[[str], None]) -> Speedups:
    """Times `count` random re-scalings: each repetition alternates between update and search, so
    that a slow moment of the machine affects both."""
    about = f"{pair.name}, {arithmetic}"
    tell(f"{about}: all events of pairs")
    scales = rescalings(SEED, count + 1)
    began = time.process_time()
    walk = _core.PaperUpdate(pair.P.set, pair.Q.set, scales[0], arithmetic, READINGS)
    preprocessing = time.process_time() - began
    nodes = []
    steps = list(pairwise(scales))
    events, updated = [0] * count, [0] * count
    ours: list[list[float]] = [[] for _ in steps]
    theirs: list[list[float]] = [[] for _ in steps]
    stepping: list[list[float]] = [[] for _ in steps]
    for repetition in range(REPETITIONS):
        tell(f"{about}: repetition {repetition + 1} of {REPETITIONS}")
        walk.move_to(scales[0])
        for i, (_, scale) in enumerate(steps):
            did = walk.move_to(scale)
            updated[i], seconds = walk.place_intersections()
            events[i] = did["insertions"] + did["deletions"]
            ours[i].append(did["seconds"] + seconds)
            stepping[i].append(did["seconds"])
            began = time.process_time()
            theirs[i].append(walk.search_intersections(scale)[1])
            nodes.append(time.process_time() - began)
    return Speedups(
        pair.name,
        arithmetic,
        walk.counts()["pairs"],
        preprocessing,
        [
            Rescaling(
                *steps[i],
                events[i],
                updated[i],
                tuple(ours[i]),
                tuple(theirs[i]),
                tuple(stepping[i]),
            )
            for i in range(count)
        ],
        nodes,
    )
