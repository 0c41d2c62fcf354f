"""Table 1 of Behar & Lien 2012: dynamic update against finding the same afresh."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from statistics import fmean, median
from typing import Any

from minkref import _core
from minkref.errors import refusing
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.reports.bench.baselines import (
    CGAL,
    INTERSECTIONS,
    PAIRWISE,
    Baseline,
    NoTimeError,
    baselines,
)
from minkref.reports.bench.pairs import Pair, pairs
from minkref.reports.bench.rescalings import WINDOW, rescalings
from minkref.reports.bench.spread import Spread, least, spread

PAPER_MEAN = 150.68  # over its 25 pairs
COUNT, QUICK_COUNT = 100, 10
PASSES = 3
SLOW = 0.05  # seconds a call: a slower baseline is timed at every tenth re-scaling, once
CGAL_SECONDS = 60.0

Row = dict[str, Any]
Tell = Callable[[str], None]


@dataclass
class Table1:
    seed: int
    rescalings: int
    rows: list[Row] = field(default_factory=list)
    pairs: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)  # sums that differ from the static ones

    def mean_ratio(self, baseline: str) -> float | None:
        """The mean of the ratios of mean times over the small pairs, if all were timed."""
        return self._mean(baseline, lambda row: float(row["ratio"]))

    def mean_of_ratios(self, baseline: str) -> float | None:
        """The mean of the mean ratios of single re-scalings, over the same pairs."""
        return self._mean(baseline, lambda row: float(row["ratios"]["mean"]))

    def _mean(self, baseline: str, value: Callable[[Row], float]) -> float | None:
        values = [value(r) for r in self.rows if r["small"] and r["baseline"] == baseline]
        small = sum(pair["small"] for pair in self.pairs)
        return fmean(values) if values and len(values) == small else None


@dataclass(frozen=True)
class Ours:
    """Seconds at each re-scaling of the update, and of the update and the sum."""

    update: list[float]
    total: list[float]


def run(
    quick: bool, seed: int, tell: Tell, done: Callable[[], None], *, only_small: bool = False
) -> Table1:
    """Times all pairs, or the 25. Tells `tell` about its progress, and calls `done` after each."""
    count = QUICK_COUNT if quick else COUNT
    table = Table1(seed, count)
    chosen, table.notes = pairs(quick)
    if only_small:
        chosen = [pair for pair in chosen if pair.small]
    oracle = cgal_oracle(table.notes)
    try:
        for pair in chosen:
            _time_pair(table, pair, oracle, rescalings(seed, count + 1), tell)
            done()
    finally:
        if oracle is not None:
            oracle.close()
    return table


def pair_count(quick: bool) -> int:
    return len(pairs(quick)[0])


def cgal_oracle(notes: list[str]) -> CgalOracle | None:
    """CGAL's reduced convolution; if absent, a note says why."""
    entry = next((e for e in ALL_TARGETS.entries() if e.name == CGAL), None)
    if entry is None or not entry.available:
        reason = entry.reason if entry is not None else "no such target"
        notes.append(f"{CGAL} is left out: {reason}")
        return None
    return CgalOracle("reduced", seconds=CGAL_SECONDS)


def _time_pair(
    table: Table1, pair: Pair, oracle: CgalOracle | None, scales: list[str], tell: Tell
) -> None:
    """Times a pair; updates start from the first scale."""
    start, *scales = scales
    tell(f"{pair.name}: all events")
    moving = refusing(
        pair.name, lambda: _core.DynamicSum(pair.P.set, pair.Q.set, WINDOW[0], WINDOW[1])
    )
    counts = dict(moving.counts())
    crossed = _crossed(moving, start, scales)
    tell(f"{pair.name}: dynamic update")
    ours = _ours(moving, start, scales)
    table.pairs.append(
        {
            "name": pair.name,
            "small": pair.small,
            "edges": counts["s_edges"] + counts["t_edges"],
            "events": counts["pair_events"] + counts["triple_events"],
            "preprocessing_seconds": moving.seconds,
            "event_scales_per_step": fmean(row["groups"] for row in crossed),
            "changes_per_step": fmean(
                row["insertions"] + row["deletions"] + row["swaps"] for row in crossed
            ),
            "update": asdict(spread(ours.update)),
            "update_and_sum": asdict(spread(ours.total)),
        }
    )
    for baseline in baselines(pair, oracle):
        tell(f"{pair.name}: {baseline.name}")
        try:
            which, theirs = _theirs(baseline, scales)
        except NoTimeError as error:
            table.notes.append(f"{pair.name}: {baseline.name} gave no answer: {error}")
            continue
        mine = ours.update if baseline.measure == INTERSECTIONS else ours.total
        table.rows.append(
            _row(pair, baseline, [mine[i] for i in which], theirs, moving.seconds, len(scales))
        )
    tell(f"{pair.name}: check")
    _check(table, pair, moving, scales)


def _crossed(moving: _core.DynamicSum, start: str, scales: list[str]) -> list[dict[str, Any]]:
    moving.move_to(start)
    return [dict(moving.move_to(scale)) for scale in scales]


def _ours(moving: _core.DynamicSum, start: str, scales: list[str]) -> Ours:
    """The least of some passes over the same re-scalings."""
    updates, totals = [], []
    for _ in range(PASSES):
        moving.update(start)
        updates.append([moving.update(scale) for scale in scales])
    for _ in range(PASSES):
        moving.update(start)
        moving.sum()
        totals.append([moving.update(scale) + moving.sum().seconds for scale in scales])
    return Ours(least(updates), least(totals))


def _theirs(baseline: Baseline, scales: list[str]) -> tuple[list[int], list[float]]:
    """The timed re-scalings, and their seconds: as ours, except for slow baselines."""
    slow = min(baseline.seconds(scales[0]) for _ in range(PASSES)) > SLOW
    every = 10 if slow and len(scales) > 10 else 1
    passes = 1 if slow and len(scales) > 10 else PASSES
    which = list(range(0, len(scales), every))
    return which, least([[baseline.seconds(scales[i]) for i in which] for _ in range(passes)])


def _row(
    pair: Pair,
    baseline: Baseline,
    ours: list[float],
    theirs: list[float],
    preprocessing: float,
    rescalings: int,
) -> Row:
    """`ours` and `theirs` at the same re-scalings."""
    ratios = [b / a for a, b in zip(ours, theirs, strict=True)]
    mine, other = spread(ours), spread(theirs)
    return {
        "name": pair.name,
        "small": pair.small,
        "measure": baseline.measure,
        "ours_s": mine.median,
        "baseline": baseline.name,
        "baseline_s": other.median,
        "ratio": other.mean / mine.mean,
        "ratios": asdict(spread(ratios)),
        "ours": asdict(mine),
        "theirs": asdict(other),
        "rescalings_timed": len(ours),
        "rescalings": rescalings,
        "preprocessing_seconds": preprocessing,
        "break_even": _break_even(preprocessing, mine, other),
    }


def _break_even(preprocessing: float, ours: Spread, theirs: Spread) -> int | None:
    """The number of queries from which finding all events pays; None if never."""
    saved = theirs.mean - ours.mean
    return math.ceil(preprocessing / saved) if saved > 0 else None


def _check(table: Table1, pair: Pair, moving: _core.DynamicSum, scales: list[str]) -> None:
    """Checks, at some scales, that updated sums equal static sums."""
    for scale in scales[:3]:
        moving.update(scale)
        got = moving.sum().region.canonical_json()
        if got != _core.minkowski_sum(pair.P.set, pair.Q.set, scale).region.canonical_json():
            table.wrong.append(f"{pair.name} at {scale}")


def summary(table: Table1) -> dict[str, Any]:
    """The mean ratios over the small pairs, and the paper's."""
    names = list(dict.fromkeys(row["baseline"] for row in table.rows))
    small = [row["ratio"] for row in table.rows if row["small"] and row["baseline"] == PAIRWISE]
    return {
        "mean_ratios": {name: table.mean_ratio(name) for name in names},
        "means_of_ratios": {name: table.mean_of_ratios(name) for name in names},
        "median_ratio": median(small) if small else None,
        "paper_mean_ratio": PAPER_MEAN,
    }
