"""Features of random sets before all judges.

`python -m minkref.fuzz.judges.disc.features_before_judges SEED FIRST COUNT` compares sets from
feature_draws.py, prints the table as JSON and exits with 1 on a fault."""

from __future__ import annotations

import json
import random
import sys
import time
from collections.abc import Sequence

from minkref import _core
from minkref.fuzz.features.feature_comparison import feature_faults
from minkref.fuzz.features.feature_draws import drawn_set, set_of
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, DiagramJudge
from minkref.fuzz.judges.disc.cut_comparison import cut_faults
from minkref.fuzz.judges.disc.feature_shape_laws import (
    Table,
    count,
    diagram_faults,
    reference_bars,
    rounded_bars,
    sum_faults,
)
from minkref.oracle.features import Judge

SECONDS = 60.0  # for a diagram


def compare(seed: int, numbers: Sequence[int]) -> Table:
    """Compares sets by number; libraries that are not built count as unanswered."""
    table = Table()
    with DiagramJudge(CGAL, SECONDS) as cgal, DiagramJudge(BOOST, SECONDS) as boost:
        for number in numbers:
            name, shape = drawn_set(seed, number)
            begun = time.process_time()
            judge = Judge(shape)
            table.seconds += time.process_time() - begun
            count(name, judge, table.counts)
            dice = random.Random(f"minkref feature laws {seed}:{number}")
            P = set_of(shape)
            faults = feature_faults(judge, _core.features(P), dice, table.counts)
            faults += sum_faults(shape, judge, dice, table.counts)
            faults += cut_faults(shape, judge, P, dice, table.counts)
            table.faults += [f"{name}: {fault}" for fault in faults]
            for library in (cgal, boost):
                diagram_faults(name, P, rounded_bars(judge), library, table)
    return table


def compare_bars(name: str, P: _core.PolygonSet) -> Table:
    """Compares bars of a set too large for the judge with those along diagrams."""
    table = Table()
    bars = reference_bars(_core.features(P))
    table.counts["bars"] = len(bars)
    for library in (CGAL, BOOST):
        with DiagramJudge(library, SECONDS) as diagram:
            diagram_faults(name, P, bars, diagram, table)
    return table


def main(arguments: list[str]) -> int:
    seed, first, sets = map(int, arguments)
    table = compare(seed, range(first, first + sets))
    print(json.dumps(vars(table), indent=1))
    return 1 if table.faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
