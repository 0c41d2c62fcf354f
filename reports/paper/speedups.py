"""Single re-scalings by the paper's own program, against the events that they process, the
intersections that they update, and how far the scale changes (Fig. 7 and 8 of the paper). Events of
pairs alone, no lists stored in between, and both sides of each ratio in one arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from statistics import correlation, median

from minkref import _core
from minkref.reports.bench.pairs import Pair
from minkref.reports.bench.rescalings import rescalings

REPETITIONS = 5
SEED = 1
#: All formulas in their right form: printed ones lose most of the intersections.
READINGS = {name: corrected for name, _, corrected, _ in _core.paper_readings()}


@dataclass(frozen=True)
class Rescaling:
    """From a scale to another. `events`: insertions and deletions on the way. `updated`:
    intersections at the end of it, which get a new place. `ours` and `theirs`: seconds of the
    update, and of a search among all pairs of edges, in each repetition."""

    start: str
    scale: str
    events: int
    updated: int
    ours: tuple[float, ...]
    theirs: tuple[float, ...]

    @property
    def factor(self) -> float:
        """By how much the scale changes, up or down; at least 1."""
        factor = Fraction(self.scale) / Fraction(self.start)
        return float(max(factor, 1 / factor))

    @property
    def seconds(self) -> list[float]:
        """Seconds of the update in each repetition, sorted."""
        return sorted(self.ours)

    @property
    def update_seconds(self) -> float:
        return median(self.ours)

    @property
    def ratios(self) -> list[float]:
        """The ratio of each repetition, sorted."""
        return sorted(b / a for a, b in zip(self.ours, self.theirs, strict=True))

    @property
    def speedup(self) -> float:
        return median(self.ratios)


@dataclass(frozen=True)
class Speedups:
    """Speed-ups of one pair in one arithmetic. `pairs` of edges are looked at. `preprocessing`:
    seconds in which the critical regions of all pairs are found and their events sorted."""

    pair: str
    arithmetic: str
    pairs: int
    preprocessing: float
    rescalings: Sequence[Rescaling]

    def correlation_of(
        self, value: Callable[[Rescaling], float], other: Callable[[Rescaling], float]
    ) -> float:
        """The correlation of the ranks of two values (Spearman)."""
        return correlation(*(_ranks([what(one) for one in self.rescalings])
                             for what in (value, other)))  # fmt: skip

    @property
    def search(self) -> float:
        """Seconds of one search, the median."""
        return median(t for one in self.rescalings for t in one.theirs)

    @property
    def update(self) -> float:
        return median(t for one in self.rescalings for t in one.ours)

    @property
    def break_even(self) -> float:
        """From how many queries on it pays to have found all events: the pre-processing over what a
        re-scaling saves, both medians."""
        return self.preprocessing / (self.search - self.update)


def speedups(pair: Pair, arithmetic: str, count: int, tell: Callable[[str], None]) -> Speedups:
    """`count` random re-scalings, each timed in every repetition: the update and the search in
    turn, so that a slow moment of the machine meets both."""
    about = f"{pair.name}, {arithmetic}"
    tell(f"{about}: all events of pairs")
    scales = rescalings(SEED, count + 1)
    walk = _core.PaperUpdate(pair.P.set, pair.Q.set, scales[0], arithmetic, READINGS)
    steps = list(pairwise(scales))
    events, updated = [0] * count, [0] * count
    ours: list[list[float]] = [[] for _ in steps]
    theirs: list[list[float]] = [[] for _ in steps]
    for repetition in range(REPETITIONS):
        tell(f"{about}: repetition {repetition + 1} of {REPETITIONS}")
        walk.move_to(scales[0])
        for i, (_, scale) in enumerate(steps):
            did = walk.move_to(scale)
            updated[i], seconds = walk.place_intersections()
            events[i] = did["insertions"] + did["deletions"]
            ours[i].append(did["seconds"] + seconds)
            theirs[i].append(walk.search_intersections(scale)[1])
    return Speedups(
        pair.name,
        arithmetic,
        walk.counts()["pairs"],
        walk.seconds,
        [
            Rescaling(*steps[i], events[i], updated[i], tuple(ours[i]), tuple(theirs[i]))
            for i in range(count)
        ],
    )


def _ranks(values: list[float]) -> list[float]:
    """From the least on; equal values share the mean of their ranks."""
    order = sorted(range(len(values)), key=values.__getitem__)
    ranks = [0.0] * len(values)
    first = 0
    while first < len(order):
        last = first
        while last + 1 < len(order) and values[order[last + 1]] == values[order[first]]:
            last += 1
        for i in order[first : last + 1]:
            ranks[i] = (first + last) / 2
        first = last + 1
    return ranks
