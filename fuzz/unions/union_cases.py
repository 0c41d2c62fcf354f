"""Sets to unite, small ones first: a third degenerate in turn, a third in general position, a third
placed sums of a scene."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded
from minkref.fuzz.cases.verbs import UNION
from minkref.fuzz.geometry.plane import Shape, mapped, moved, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import convex, is_valid, shape_text
from minkref.fuzz.plane.families.holed_pairs import plate
from minkref.fuzz.plane.families.integer_rings import scattered, untangled
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.degenerate_unions import KINDS, Sets, degenerate_sets
from minkref.fuzz.unions.placed_sums import scene_sets

GRID = "-grid"
FAMILIES = {
    UNION: "sets to unite: degenerate ones, any, and placed sums of scenes, in rational numbers",
    UNION + GRID: "the same on a grid of 24 bits",
}
GENERAL, SCENE = "general", "placed sums"
POSITIONS = (*KINDS, GENERAL, SCENE)
FACTORS = tuple(
    map(Fraction, ("1", "1", "1/3", "7/5", "1000/7", "1/10000000000", "100000000000000000000/3"))
)
SHIFTS = tuple(map(Fraction, ("0", "0", "1/3", "-22/7", "123456789123456789123", "1/1000000007")))
UNIT = Fraction(1, 64)
TINY = Fraction(1, 10**30)
PATIENCE = 200
MOST_SETS, GROWTH = 8, 100


def drawn_union(name: CaseName, family: str, seed: int, index: int) -> AskedUnion:
    """The same one for the same numbers. RuntimeError if nothing valid is drawn."""
    kind, draw = _draw_of(index)
    dice = Dice(f"minkref {family} {seed} {index}")
    change = _on_grid if family.endswith(GRID) else _in_fractions
    for _ in range(PATIENCE):
        texts = [shape_text(shape) for shape in change(dice, kind, draw(dice))]
        if all(map(is_valid, texts)):
            sets = tuple(map(_core.PolygonSet.from_json, texts))
            return AskedUnion(name, sets, family, kind)
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing valid")


def _draw_of(index: int) -> tuple[str, Callable[[Dice], Sets]]:
    turn, which = divmod(index, 3)
    if which == 0:
        kind = tuple(KINDS)[turn % len(KINDS)]
        return kind, lambda dice: degenerate_sets(dice, kind)
    if which == 1:
        return GENERAL, lambda dice: _general(dice, min(MOST_SETS, 3 + index * 5 // GROWTH))
    return SCENE, scene_sets


def _general(dice: Dice, most: int) -> Sets:
    """Convex sets, outlines of any shape, and plates with holes, over each other."""
    reach = dice.choice((12, 40, 1000))
    sets: Sets = []
    for _ in range(dice.randint(2, most)):
        way = dice.randrange(4)
        if way < 2:
            shape: Shape = [[convex(dice, dice.randint(3, 8), reach)]]
        elif way == 2:
            ring = untangled(scattered(dice, dice.randint(4, 9), reach, reach))
            shape = [[[*ring]]] if ring else [[convex(dice, 5, reach)]]
        else:
            shape = scaled([plate(dice, dice.randint(1, 3), 3)], max(1, reach // 12))
        dx, dy = (dice.randint(-reach // 2, reach // 2) for _ in "xy")
        sets.append(moved(shape, dx, dy))
    if dice.random() < 0.05:
        sets.append([])
    return sets


def _in_fractions(dice: Dice, kind: str, sets: Sets) -> Sets:
    """Scales and moves all sets together: common points stay common."""
    factor, dx, dy = dice.choice(FACTORS), dice.choice(SHIFTS), dice.choice(SHIFTS)
    sets = [moved(scaled(shape, factor), dx, dy) for shape in sets]
    if kind == "nearly equal" and dice.random() < 0.5:
        sets[-1] = moved(sets[0], TINY, 0)
    return sets


def _on_grid(dice: Dice, kind: str, sets: Sets) -> Sets:
    """By a power of two: few bits stay few. Crossings among the vertices of placed sums are rounded
    to the grid."""
    if kind == SCENE:
        sets = [
            mapped(shape, lambda p: (rounded(p[0], UNIT), rounded(p[1], UNIT))) for shape in sets
        ]
    factor = Fraction(2) ** dice.choice((0, 0, 0, 7, -3, 30, -40))
    return [scaled(shape, factor) for shape in sets]
