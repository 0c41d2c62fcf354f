"""Speed-ups of single re-scalings, against the events that they process and the intersections that
they update (Fig. 7 and 8 of the paper)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from statistics import correlation, median
from typing import Any

from minkref import _core
from minkref.reports.bench.pairs import Pair
from minkref.reports.bench.rescalings import WINDOW, rescalings

REPETITIONS = 5
SEED = 1


@dataclass(frozen=True)
class Rescaling:
    """From a scale to another. `events`: insertions, deletions and swaps of nodes on the way.
    `updated`: intersections at the end of it, which get a new place. `ours` and `theirs`: seconds
    of the update, and of a search among all pairs of edges, in each repetition."""

    start: str
    scale: str
    events: int
    updated: int
    ours: tuple[float, ...]
    theirs: tuple[float, ...]

    @property
    def ratios(self) -> list[float]:
        """Of each repetition, sorted."""
        return sorted(b / a for a, b in zip(self.ours, self.theirs, strict=True))

    @property
    def speedup(self) -> float:
        return median(self.ratios)


@dataclass(frozen=True)
class Speedups:
    """Of one pair. `preprocessing`: seconds in which all events in the window are found."""

    pair: str
    preprocessing: float
    rescalings: list[Rescaling]

    def correlation_with(self, what: Callable[[Rescaling], float]) -> float:
        """Of the ranks of the speed-up and of something else (Spearman)."""
        xs = _ranks([what(one) for one in self.rescalings])
        ys = _ranks([one.speedup for one in self.rescalings])
        return correlation(xs, ys)

    @property
    def break_even(self) -> float:
        """From how many queries on it pays to have found all events: the pre-processing over what a
        re-scaling saves, both medians."""
        ours = median(t for one in self.rescalings for t in one.ours)
        theirs = median(t for one in self.rescalings for t in one.theirs)
        return self.preprocessing / (theirs - ours)


def speedups(pair: Pair, count: int, tell: Callable[[str], None]) -> Speedups:
    """`count` random re-scalings, each timed in every repetition: ours and the search in turn, so
    that a slow moment of the machine meets both."""
    tell(f"{pair.name}: all events")
    moving = _core.DynamicSum(pair.P.set, pair.Q.set, *WINDOW)
    search = _core.PairwiseSearch(pair.P.set, pair.Q.set)
    contacts = _core.ContactSearch(pair.P.set, pair.Q.set)
    scales = rescalings(SEED, count + 1)
    steps = list(pairwise(scales))
    moving.move_to(scales[0])
    crossed = [dict(moving.move_to(scale)) for scale in scales[1:]]
    ours: list[list[float]] = [[] for _ in steps]
    theirs: list[list[float]] = [[] for _ in steps]
    for repetition in range(REPETITIONS):
        tell(f"{pair.name}: repetition {repetition + 1} of {REPETITIONS}")
        moving.update(scales[0])
        for i, (_, scale) in enumerate(steps):
            ours[i].append(moving.update(scale))
            theirs[i].append(search.run(scale)[1])
    return Speedups(
        pair.name,
        moving.seconds,
        [
            Rescaling(
                *steps[i],
                _events(crossed[i]),
                contacts.run(steps[i][1])[0],
                tuple(ours[i]),
                tuple(theirs[i]),
            )
            for i in range(len(steps))
        ],
    )


def _events(crossed: dict[str, Any]) -> int:
    return int(crossed["insertions"] + crossed["deletions"] + crossed["swaps"])


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
