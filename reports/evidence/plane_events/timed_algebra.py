"""Computer algebra's event scales, timed: `python -m … gmpy2|fractions COUNT TRIPLES`, with the
rationals of gmpy2, or with Python's own in their place."""

from __future__ import annotations

import fractions
import json
import sys
import time
import types

SEED = 5


def replace_gmpy2() -> None:
    """Puts Python's fractions where gmpy2's rationals are imported from. Call before the import."""
    module = types.ModuleType("gmpy2")
    module.mpq = fractions.Fraction  # type: ignore[attr-defined]
    sys.modules["gmpy2"] = module


def timed(count: int, triples: int) -> dict[str, float]:
    """Processor seconds for the intervals of pairs, and for the events of pairs and triples."""
    from minkref.fuzz.judges.plane import event_comparison, interval_comparison

    began = time.process_time()
    intervals = interval_comparison.compare_intervals(SEED, count)
    between = time.process_time()
    events = event_comparison.compare(SEED, count, triples)
    return {
        "intervals": between - began,
        "events": time.process_time() - between,
        "differences": intervals.differences + events.differences,
    }


if __name__ == "__main__":
    if sys.argv[1] == "fractions":
        replace_gmpy2()
    json.dump(timed(int(sys.argv[2]), int(sys.argv[3])), sys.stdout)
