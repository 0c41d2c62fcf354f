"""Times of many runs, condensed for printing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean, median, quantiles


@dataclass(frozen=True)
class Spread:
    count: int
    mean: float
    lower: float  # quartiles
    median: float
    upper: float

    def in_words(self, digits: int = 1) -> str:
        """The median and, of several values, the quartiles."""
        if self.count == 1:
            return f"{self.median:,.{digits}f}"
        quartiles = f"{self.lower:,.{digits}f} to {self.upper:,.{digits}f}"
        return f"median {self.median:,.{digits}f} (quartiles {quartiles})"


def spread(values: Sequence[float]) -> Spread:
    """Spread from at least one value."""
    ordered = sorted(values)
    if len(ordered) == 1:
        return Spread(1, ordered[0], ordered[0], ordered[0], ordered[0])
    lower, _, upper = quantiles(ordered, n=4, method="inclusive")
    return Spread(len(ordered), fmean(ordered), lower, median(ordered), upper)


def least(passes: Sequence[Sequence[float]]) -> list[float]:
    """The least time of each run over several passes."""
    return [min(times) for times in zip(*passes, strict=True)]
