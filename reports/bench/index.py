"""The index of all scales: the cost of building, keeping and asking it, against CGAL's sums."""

from __future__ import annotations

import math
import random
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, replace
from fractions import Fraction
from itertools import cycle
from pathlib import Path
from statistics import fmean
from typing import Any

from minkref import _core
from minkref.errors import refusing
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.plane.families.drawing import reflected
from minkref.model_catalogue import VARIABLE, all_models, or_look_alike
from minkref.plane.operand import Operand, read_operand
from minkref.reports.bench.baselines import CGAL, NoTimeError, by_cgal
from minkref.reports.bench.pairs import SMALL, Pair
from minkref.reports.bench.rescalings import WINDOW
from minkref.reports.bench.spread import Spread, spread
from minkref.reports.bench.table1 import cgal_oracle

#: The large pairs, as model names; `-` reflects a model through the origin.
LARGE = (("monkey", "bird"), ("neuron", "disc1"), ("neuron", "disc5"), ("monkey", "-monkey"))
QUICK_LARGE = LARGE[1:2]
FORMS = ("double", "homogeneous", "rational", "track", "area")
COUNT, QUICK_COUNT = 60, 10
CGAL_COUNT, QUICK_CGAL_COUNT = 10, 3
PASSES, CGAL_PASSES, BUILDS = 7, 3, 3
LONG_BUILD = 2.0  # seconds; longer builds are timed once

Row = dict[str, Any]
Tell = Callable[[str], None]


@dataclass
class IndexTable:
    seed: int
    queries: int
    rows: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)  # sums that differ from the static ones

    def mean_ratio(self, form: str) -> float | None:
        """CGAL over a query, over the small pairs, all of which must have been timed."""
        small = [row for row in self.rows if row["small"]]
        ratios = [row["forms"][form]["cgal_ratio"] for row in small]
        known = [ratio for ratio in ratios if ratio is not None]
        return fmean(known) if known and len(known) == len(small) == len(SMALL) ** 2 else None


def pair_count(quick: bool) -> int:
    return len(_pairs(quick, []))


def run(quick: bool, seed: int, tell: Tell, done: Callable[[], None]) -> IndexTable:
    """Times all pairs, on one core. Tells `tell` about its progress, and calls `done` after each
    pair."""
    table = IndexTable(seed, QUICK_COUNT if quick else COUNT)
    oracle = cgal_oracle(table.notes)
    try:
        for pair in _pairs(quick, table.notes):
            _time_pair(table, pair, oracle, quick, tell)
            done()
    finally:
        if oracle is not None:
            oracle.close()
    return table


def _pairs(quick: bool, notes: list[str]) -> list[Pair]:
    models = all_models()

    def operand(name: str) -> Operand:
        plain = name.removeprefix("-")
        alike = or_look_alike(plain, models)
        note = f"{VARIABLE} does not provide {plain}: our {alike} stands for it"
        if alike != plain and note not in notes:
            notes.append(note)
        found = read_operand(alike)
        if name == plain:
            return found
        return replace(found, name=f"-{found.name}", set=reflected(found.set))

    large = [
        Pair(operand(first), operand(second), small=False)
        for first, second in (QUICK_LARGE if quick else LARGE)
    ]
    small = [read_operand(name) for name in SMALL]
    return large + [Pair(P, Q, small=True) for P in small for Q in small]


def query_scales(seed: int, count: int) -> list[str]:
    """Seeded, spread evenly over the logarithm of the window; denominators up to 1000."""
    numbers = random.Random(seed)
    low, high = (math.log(float(Fraction(bound))) for bound in WINDOW)
    first, last = Fraction(WINDOW[0]), Fraction(WINDOW[1])
    scales = []
    for _ in range(count):
        scale = Fraction(math.exp(numbers.uniform(low, high))).limit_denominator(1000)
        scales.append(str(min(max(scale, first), last)))
    return scales


def _time_pair(
    table: IndexTable, pair: Pair, oracle: CgalOracle | None, quick: bool, tell: Tell
) -> None:
    tell(f"{pair.name}: build")
    builds: list[float] = []
    while len(builds) < (1 if quick else BUILDS):
        index = refusing(pair.name, lambda: _core.ScaleIndex(pair.P.set, pair.Q.set, *WINDOW))
        builds.append(index.seconds)
        if index.seconds > LONG_BUILD:
            break
    scales = query_scales(table.seed, table.queries)
    tell(f"{pair.name}: queries")
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "index")
        index.save(path)
        timed = _core.timed_index_queries(path, scales, PASSES)
    tell(f"{pair.name}: {CGAL}")
    theirs = _cgal(table, pair, oracle, scales[: QUICK_CGAL_COUNT if quick else CGAL_COUNT])
    tell(f"{pair.name}: lazily")
    lazy = _lazily(pair, scales, theirs)
    counts = dict(index.counts())
    build = min(builds)
    table.rows.append(
        {
            "name": pair.name,
            "small": pair.small,
            "edges": counts["s_edges"] + counts["t_edges"],
            "boundary_events": counts["boundary_events"],
            "build_seconds": build,
            "builds": len(builds),
            "bytes": counts["bytes"],
            "vertices": fmean(row[2] for row in timed["double"]),
            "cgal": None if theirs is None else asdict(theirs),
            "build_in_cgal_calls": None if theirs is None else build / theirs.mean,
            "lazy": lazy,
            "forms": {form: _form(timed[form], theirs, build) for form in FORMS},
        }
    )
    tell(f"{pair.name}: check")
    wrong = index.first_difference(scales[:2])
    if wrong:
        table.wrong.append(f"{pair.name} at {wrong}")


def _lazily(pair: Pair, scales: list[str], theirs: Spread | None) -> Row:
    """A lazy index, asked for doubles until it is built, and once more: the seconds of all queries
    up to each one, and from which number on CGAL's sums take as long."""
    totals: list[float] = []
    begin = time.perf_counter()
    index = refusing(
        pair.name, lambda: _core.ScaleIndex(pair.P.set, pair.Q.set, *WINDOW, lazy=True)
    )
    single = 0
    for scale in cycle(scales):
        is_built = index.is_built
        index.rings(scale)
        totals.append(time.perf_counter() - begin)
        if is_built:
            break
        single += not index.is_built
    return {
        "single_sums": single,
        "first_seconds": totals[0],
        "seconds_when_built": totals[-2],
        "pays_from": None if theirs is None else pays_from(totals, theirs.mean),
    }


def pays_from(totals: list[float], theirs: float) -> int | None:
    """The least number of queries from which on, for ever, ours together take no longer than as
    many of theirs. `totals`: of the first queries, two at least; all further ones are taken to cost
    as much as the last."""
    saved = theirs - (totals[-1] - totals[-2])
    slower = [k for k, total in enumerate(totals, 1) if total > k * theirs]
    if saved < 0 or (saved == 0 and slower and slower[-1] == len(totals)):
        return None
    if not slower or slower[-1] < len(totals):
        return slower[-1] + 1 if slower else 1
    return len(totals) + math.ceil((totals[-1] - len(totals) * theirs) / saved)


def _form(rows: list[tuple[float, float, int]], theirs: Spread | None, build: float) -> Row:
    ours = spread([row[0] for row in rows])
    floor = fmean(row[1] for row in rows)
    saved = None if theirs is None else theirs.mean - ours.mean
    return {
        "query": asdict(ours),
        "floor_ratio": ours.mean / floor if floor > 0 else None,
        "cgal_ratio": None if theirs is None else theirs.mean / ours.mean,
        "break_even": math.ceil(build / saved) if saved is not None and saved > 0 else None,
    }


def _cgal(
    table: IndexTable, pair: Pair, oracle: CgalOracle | None, scales: list[str]
) -> Spread | None:
    """CGAL's times at scales with an answer; notes record the failures."""
    if oracle is None:
        return None
    seconds = []
    for scale in scales:
        try:
            times = [
                by_cgal(oracle, pair, scale) for _ in range(1 if not pair.small else CGAL_PASSES)
            ]
        except NoTimeError as error:
            table.notes.append(f"{pair.name} at {scale}: {CGAL} gave no answer: {error}")
            continue
        seconds.append(min(times))
    return spread(seconds) if seconds else None


def summary(table: IndexTable) -> dict[str, Any]:
    """The mean ratios over the small pairs."""
    return {"mean_ratios": {form: table.mean_ratio(form) for form in FORMS}}
