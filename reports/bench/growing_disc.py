"""Section 8.2's experiment: the convolution's intersections with a disc at 20 diameters, by the
Appendix's own program, against finding them from scratch in the same arithmetic."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from statistics import median

from minkref import _core
from minkref.plane.operand import read_operand

COUNT = 20
REPETITIONS = 7
BEETLE = "beetle"
LEAST, MOST = Fraction(1, 20), Fraction(1)  # the paper's diameters, Fig. 12 (d)
#: All sentences corrected: printed ones lose most intersections.
READINGS = {name: corrected for name, _, corrected, _ in _core.appendix_readings()}


def diameters() -> list[Fraction]:
    """Evenly spaced, from the least to the most."""
    return [LEAST + (MOST - LEAST) * k / (COUNT - 1) for k in range(COUNT)]


def squared_radii() -> list[str]:
    return [str((diameter / 2) ** 2) for diameter in diameters()]


@dataclass(frozen=True)
class Timed:
    """Seconds for all diameters together, a value for each repetition. `stepped`: of the steps
    alone; `update`: with the places of all intersections; `scratch`: of the searches among all
    pairs, places left out; `intersections`: over all diameters."""

    arithmetic: str
    curves: int
    events: int
    intersections: int
    preprocessing: float
    stepped: tuple[float, ...]
    update: tuple[float, ...]
    scratch: tuple[float, ...]

    def speedup(self) -> list[float]:
        """Each repetition's ratio, sorted."""
        return sorted(a / b for a, b in zip(self.scratch, self.update, strict=True))

    def pays_after(self) -> float:
        """How many diameters make up for the pre-processing."""
        saved = (median(self.scratch) - median(self.update)) / COUNT
        return self.preprocessing / saved if saved > 0 else float("inf")


def timed(arithmetic: str, tell: Callable[[str], None]) -> Timed:
    """Each repetition takes the walk and the searches in turn, so that a slow moment of the machine
    affects both. A walk goes upwards from the least diameter; the way back is not timed."""
    P, squares = read_operand(BEETLE).set, squared_radii()
    tell(f"{BEETLE}, {arithmetic}: all events of pairs")
    began = time.process_time()
    walk = _core.DiscUpdate(P, squares[0], str(MOST / 4), arithmetic, READINGS)
    preprocessing = time.process_time() - began
    stepped, update, scratch = [], [], []
    found = 0
    for repetition in range(REPETITIONS):
        tell(f"{BEETLE}, {arithmetic}: repetition {repetition + 1} of {REPETITIONS}")
        walk.move_to(squares[0])
        found, steps, places = 0, 0.0, 0.0
        for square in squares:
            steps += walk.move_to(square)["seconds"]
            count, placing = walk.place_intersections()
            found, places = found + count, places + placing
        stepped.append(steps)
        update.append(steps + places)
        searches = [walk.search_intersections(square) for square in squares]
        scratch.append(sum(seconds for _, seconds in searches))
        if arithmetic != "double" and sum(count for count, _ in searches) != found:
            raise AssertionError("the search found other intersections than the walk has")
    counts = walk.counts()
    return Timed(arithmetic, counts["segments"] + counts["arcs"], len(walk.events()), found,
                 preprocessing, tuple(stepped), tuple(update), tuple(scratch))  # fmt: skip
