"""Drawn sets: kinds with many ties in turn, then shifted a little."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import bits_of, rounded, unit_for
from minkref.fuzz.features.asked_features import AskedFeatures
from minkref.fuzz.features.feature_draws import KINDS, shifted
from minkref.fuzz.geometry.plane import Shape, box, extent, moved, scaled
from minkref.fuzz.offsets.degenerate_offsets import closing_pocket, neck, on_a_circle
from minkref.fuzz.offsets.radii import drawn_radius
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import is_valid, shape_text

FAMILY, GRID = "features", "-grid"
FAMILIES = {
    FAMILY: "concave features of sets with ties, and nearly so; radii at and beside their events",
    FAMILY + GRID: "the same on a grid of 24 bits",
}
MOST = 32  # vertices
BITS = 24
FACTORS = tuple(map(Fraction, ("1", "1", "1/3", "7/5", "1/1000000", "10000000000/3")))
POWERS = (0, 0, 0, 7, -3, 30, -40)
PATIENCE = 400


def pinched(dice: Dice) -> Shape:
    """Boxes, each touching the next at a corner, perhaps framed."""
    x = y = 0
    found: Shape = []
    for _ in range(dice.randint(2, 4)):
        wide, high = dice.randint(1, 3), dice.randint(1, 3)
        found.append([box(x, y, wide, high)])
        x, y = x + wide, y + high
    if dice.random() < 0.5:
        rings = [polygon[0][::-1] for polygon in found]
        return [[box(-2, -2, x + 4, y + 4), *rings]]
    return found


OF_CASES: dict[str, Callable[[Dice], Shape]] = {
    **KINDS,
    **{each.__name__: each for each in (pinched, on_a_circle, closing_pocket, neck)},
}


def drawn_features(name: CaseName, family: str, seed: int, index: int) -> AskedFeatures:
    """The same one for the same numbers. RuntimeError if nothing valid is drawn."""
    dice = Dice(f"minkref {family} {seed} {index}")
    turn, which = divmod(index, len(OF_CASES))
    kind = list(OF_CASES)[which]
    for _ in range(PATIENCE):
        shape = OF_CASES[kind](dice)
        if turn % 2:
            shape = shifted(dice, shape)
        on_grid = family.endswith(GRID)
        shape = _on_grid(dice, shape) if on_grid else _in_fractions(dice, shape)
        text = shape_text(shape)
        if not 3 <= sum(len(r) for p in shape for r in p) <= MOST or not is_valid(text):
            continue
        P = _core.PolygonSet.from_json(text)
        _, _, wide, high = extent([p for polygon in shape for p in polygon[0]])
        radius, position = drawn_radius(dice, P, Fraction(max(wide, high)))
        if on_grid:
            radius = rounded(radius, unit_for(radius, BITS))
        return AskedFeatures(name, P, radius, family, f"{kind}, {position}")
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing valid")


def _in_fractions(dice: Dice, shape: Shape) -> Shape:
    shift = [Fraction(dice.choice(("0", "0", "1/3", "-22/7", "1234567"))) for _ in range(2)]
    return moved(scaled(shape, dice.choice(FACTORS)), *shift)


def _on_grid(dice: Dice, shape: Shape) -> Shape:
    """Rounded if off the grid, and scaled by a power of two."""
    numbers = [Fraction(x) for polygon in shape for ring in polygon for p in ring for x in p]
    bits = bits_of(numbers)
    if bits is None or bits > BITS:
        unit = unit_for(max(map(abs, numbers)), BITS - 8)
        shape = [[[(rounded(x, unit), rounded(y, unit)) for x, y in ring] for ring in polygon]
                 for polygon in shape]  # fmt: skip
    return scaled(shape, Fraction(2) ** dice.choice(POWERS))
