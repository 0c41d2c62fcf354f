"""Section 8.1's experiment: the convolution intersections of an environment of 12 scaled copies, by
the paper's own program, against finding them from scratch in the same arithmetic."""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from statistics import median

from minkref import _core
from minkref.plane.operand import read_operand

COPIES = 12  # as the paper has
REPETITIONS = 7
SEED = 11
MODELS = ("g1", "g2", "g3", "g4")
#: Widths of the models: each makes further shapes.
WIDTHS = ("1", "3/2", "2/3")
#: How many shapes the copies share; the paper does not say.
SHARED_BY = (1, 3, 12)
ROBOT, ROBOT_SCALE = "g4", "1/5"
LEAST, MOST = 3, 20  # tenths: scales of the copies
STEP = 190  # between neighbours, before they are moved a little
#: All formulas corrected: printed formulas lose most intersections.
READINGS = {name: corrected for name, _, corrected, _ in _core.paper_readings()}


@dataclass(frozen=True)
class PlacedCopy:
    shape: int
    scale: str
    place: tuple[str, str]


@dataclass(frozen=True)
class Environment:
    """`turned_robot`: the robot after a half-turn, the second operand of each sum."""

    shapes: tuple[_core.PolygonSet, ...]
    turned_robot: _core.PolygonSet
    copies: tuple[PlacedCopy, ...]


def environment(shapes: int) -> Environment:
    """12 copies of so many shapes; the places, which change no intersection, are for a picture."""
    dice = random.Random(f"minkref repeated obstacles {SEED} {shapes}")
    robot = read_operand(ROBOT).set.scaled(f"-{ROBOT_SCALE}")
    stretched = [
        read_operand(model).set.scaled(f"{width},1") for width in WIDTHS for model in MODELS
    ]
    copies = []
    for number in range(COPIES):
        column, row = number % 4, number // 4
        x, y = (Fraction(STEP * at + dice.randint(-STEP // 6, STEP // 6)) for at in (column, row))
        scale = Fraction(dice.randint(LEAST, MOST), 10)
        copies.append(PlacedCopy(number % shapes, str(scale), (str(x), str(y))))
    return Environment(tuple(stretched[:shapes]), robot, tuple(copies))


@dataclass(frozen=True)
class Timed:
    """Seconds for all copies together, a value for each repetition. `orders`: seconds by
    order; `preprocessing`: of all shapes; `intersections`: placed at the copies' scales."""

    shapes: int
    arithmetic: str
    edges: int
    events: int
    intersections: int
    preprocessing: float
    scratch: tuple[float, ...]
    orders: dict[str, tuple[float, ...]]

    def speedup(self, order: str) -> list[float]:
        """Each repetition's ratio, sorted."""
        return sorted(a / b for a, b in zip(self.scratch, self.orders[order], strict=True))

    def pays_after(self, order: str) -> float:
        """How many copies make up for the pre-processing."""
        saved = (median(self.scratch) - median(self.orders[order])) / COPIES
        return self.preprocessing / saved if saved > 0 else float("inf")


AS_LISTED, SORTED, FROM_ONE = "as listed", "sorted by scale", "each from 1"


def timed(shapes: int, arithmetic: str, tell: Callable[[str], None]) -> Timed:
    """Each repetition takes the orders and the searches in turn, so that a slow moment of the
    machine affects all."""
    scene = environment(shapes)
    tell(f"12 copies of {shapes}, {arithmetic}: all events of pairs")
    began = time.process_time()
    walks = [
        _core.PaperUpdate(shape, scene.turned_robot, "1", arithmetic, READINGS)
        for shape in scene.shapes
    ]
    preprocessing = time.process_time() - began
    orders: dict[str, list[float]] = {order: [] for order in (AS_LISTED, SORTED, FROM_ONE)}
    scratch, placed = [], 0
    for repetition in range(REPETITIONS):
        tell(f"12 copies of {shapes}, {arithmetic}: repetition {repetition + 1} of {REPETITIONS}")
        for order, seconds in orders.items():
            taken, placed = 0.0, 0
            for walk, scale in _steps(scene, walks, order):
                taken += walk.move_to(scale)["seconds"]
                count, placing = walk.place_intersections()
                placed += count
                taken += placing
            seconds.append(taken)
        scratch.append(
            sum(walks[copy.shape].search_intersections(copy.scale)[1] for copy in scene.copies)
        )
    counts = [walk.counts() for walk in walks]
    return Timed(
        shapes, arithmetic,
        sum(count["edges"] for count in counts),
        sum(len(walk.events()) for walk in walks),
        placed, preprocessing, tuple(scratch),
        {order: tuple(seconds) for order, seconds in orders.items()},
    )  # fmt: skip


def _steps(
    scene: Environment, walks: list[_core.PaperUpdate], order: str
) -> Iterator[tuple[_core.PaperUpdate, str]]:
    """The walk and the scale of each copy; what leads back to the scale 1 is not timed."""
    for walk in walks:
        walk.move_to("1")
    copies = list(scene.copies)
    if order == SORTED:
        copies.sort(key=lambda copy: Fraction(copy.scale))
    for copy in copies:
        walk = walks[copy.shape]
        if order == FROM_ONE:
            walk.move_to("1")
        yield walk, copy.scale


@cache
def placed_sums(shapes: int) -> tuple[tuple[_core.PolygonSet, _core.PolygonSet], ...]:
    """Each placed obstacle, and its sum with the turned robot; exact."""
    scene = environment(shapes)
    found = []
    for copy in scene.copies:
        shape = scene.shapes[copy.shape]
        total = _core.minkowski_sum(shape, scene.turned_robot, copy.scale).region
        found.append(
            (shape.scaled(copy.scale).translated(*copy.place), total.translated(*copy.place))
        )
    return tuple(found)
