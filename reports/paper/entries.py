"""All entries, in the paper's order."""

from __future__ import annotations

import time
from collections.abc import Callable

from minkref import _core
from minkref.reports.bench import table1, table2
from minkref.reports.bench.pairs import LARGE, SMALL, Pair, pairs
from minkref.reports.paper import speedup_entries
from minkref.reports.paper.crossing_facets import figure_9
from minkref.reports.paper.drawn_entries import drawn_entries
from minkref.reports.paper.entry import Entry
from minkref.reports.paper.growing_disc_entry import figure_12
from minkref.reports.paper.judged_entry import judged_entries
from minkref.reports.paper.program_entry import kept, program_entry
from minkref.reports.paper.repeated_obstacles_entry import figure_11
from minkref.reports.paper.space_times import kept as kept_space_times
from minkref.reports.paper.space_times_entry import space_times_entry
from minkref.reports.paper.speedups import Speedups, speedups
from minkref.reports.paper.table_entries import first_table, second_table

Tell = Callable[[str], None]
COMMAND = "minkref report paper"
DOUBLE, MPFR = "double", "mpfr:53"
#: Re-scalings per figure. A search with MPFR takes seconds, for monkey and bird minutes.
COUNTS = {("disc", DOUBLE): 60, ("disc", MPFR): 8, ("monkey", DOUBLE): 16}
QUICK_COUNTS = {("disc", DOUBLE): 12}
#: Re-scalings per pair from Table 1.
SMALL_COUNTS, QUICK_SMALL_COUNTS = {DOUBLE: 100, MPFR: 5}, {DOUBLE: 10}
ABSENT_MODELS = (
    "the polygons: the paper's models were not at hand (MINKREF_MODELS), and look-alikes of the "
    "same sizes stand for them"
)


def entries(quick: bool, seed: int, tell: Tell, done: Callable[[], None]) -> list[Entry]:
    """All entries. Tells `tell` about its progress, and calls `done` after each timed pair."""
    all_pairs, notes = pairs(quick)
    large = [pair for pair in all_pairs if not pair.small]
    absent = " ".join([ABSENT_MODELS] * bool(notes))
    table = table1.run(quick, seed, tell, done, only_small=True)
    walks = _walks([pair for pair in all_pairs if pair.small], quick, tell)
    figures = []
    for pair in large:
        figures.append(_figure(pair, quick, tell))
        done()
    exact = [(pair, exact_seconds(pair)) for pair in large]
    space = figure_9(quick, seed, tell)
    solids = table2.run(quick, seed, tell, done)
    obstacles = figure_11(quick, tell)
    return [
        *drawn_entries(large[0], absent),
        program_entry(kept()),
        *judged_entries(),
        first_table(table, walks),
        *sorted((speedup_entries.figure(pair, runs, absent)
                 for pair, runs in zip(large, figures, strict=True)), key=lambda one: one.place),
        *(entry(pair, absent) for pair in large
          for entry in (speedup_entries.sizes, speedup_entries.events)),
        speedup_entries.times([run for runs in figures for run in runs], exact),
        space,
        space_times_entry(kept_space_times()),
        second_table(solids),
        obstacles,
        figure_12(quick, tell),
    ]  # fmt: skip


def exact_seconds(pair: Pair) -> float:
    """Processor seconds of all pair events, exact."""
    began = time.process_time()
    _core.pair_events(pair.P.set, pair.Q.set, kind="pair")
    return time.process_time() - began


def _figure(pair: Pair, quick: bool, tell: Tell) -> list[Speedups]:
    which = "disc" if speedup_entries.is_disc(pair.name) else "monkey"
    counts = QUICK_COUNTS if quick else COUNTS
    return [
        speedups(pair, arithmetic, count, tell)
        for (name, arithmetic), count in counts.items()
        if name == which
    ]


def _walks(small: list[Pair], quick: bool, tell: Tell) -> dict[str, dict[str, Speedups]]:
    counts = QUICK_SMALL_COUNTS if quick else SMALL_COUNTS
    return {
        arithmetic: {pair.name: speedups(pair, arithmetic, count, tell) for pair in small}
        for arithmetic, count in counts.items()
    }


def steps(quick: bool) -> int:
    """The number of calls to `done`."""
    return len(SMALL) ** 2 + len(LARGE[:1] if quick else LARGE) + table2.pair_count()
