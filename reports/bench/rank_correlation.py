"""Rank correlations (Spearman) with intervals by bootstrap."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import StatisticsError, correlation

SEED = 2012
RESAMPLES = 2000
HOW = (
    f"95 % intervals by bootstrap: {RESAMPLES:,} resamples of the re-scalings, seed {SEED}, 2.5 to "
    "97.5 percentile"
)


@dataclass(frozen=True)
class Interval:
    """A value, and its resamples' 2.5 and 97.5 percentiles."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:+.2f} ({self.low:+.2f} to {self.high:+.2f})"


def rank_correlation(xs: Sequence[float], ys: Sequence[float]) -> Interval:
    """Spearman's correlation; raises StatisticsError for constant values."""
    values = [
        _correlated([xs[i] for i in chosen], [ys[i] for i in chosen])
        for chosen in _resamples(len(xs))
    ]
    return _interval(_correlated(xs, ys), values)


def stronger_by(ys: Sequence[float], first: Sequence[float], second: Sequence[float]) -> Interval:
    """By how much the correlation of `ys` with `first` is stronger, of either sign, than that with
    `second`; the same resamples serve both."""

    def gain(chosen: Sequence[int]) -> float | None:
        of_y = [ys[i] for i in chosen]
        strengths = [_correlated(of_y, [xs[i] for i in chosen]) for xs in (first, second)]
        return None if None in strengths else abs(strengths[0] or 0) - abs(strengths[1] or 0)

    return _interval(gain(range(len(ys))), [gain(chosen) for chosen in _resamples(len(ys))])


def _resamples(count: int) -> list[list[int]]:
    dice = random.Random(f"minkref bootstrap {SEED}")
    return [[dice.randrange(count) for _ in range(count)] for _ in range(RESAMPLES)]


def _interval(value: float | None, resampled: Sequence[float | None]) -> Interval:
    """Resamples with a constant value have no correlation and are left out."""
    if value is None:
        raise StatisticsError("a constant value has no rank correlation")
    kept = sorted(one for one in resampled if one is not None)
    last = len(kept) - 1
    return Interval(value, kept[round(0.025 * last)], kept[round(0.975 * last)])


def _correlated(xs: Sequence[float], ys: Sequence[float]) -> float | None:
    try:
        return correlation(ranks(xs), ranks(ys))
    except StatisticsError:
        return None


def ranks(values: Sequence[float]) -> list[float]:
    """From the least on; equal values share the mean of their ranks."""
    order = sorted(range(len(values)), key=values.__getitem__)
    found = [0.0] * len(values)
    first = 0
    while first < len(order):
        last = first
        while last + 1 < len(order) and values[order[last + 1]] == values[order[first]]:
            last += 1
        for i in order[first : last + 1]:
            found[i] = (first + last) / 2
        first = last + 1
    return found
