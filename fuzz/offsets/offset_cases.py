"""Sets to grow or erode, small ones first: two thirds of degenerate kinds in turn, a third of any
shape."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.geometry.plane import Point, Shape, extent, mapped, moved, scaled
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.degenerate_insets import KINDS as INSET_KINDS
from minkref.fuzz.offsets.degenerate_insets import degenerate_inset
from minkref.fuzz.offsets.degenerate_offsets import KINDS, degenerate_set
from minkref.fuzz.offsets.radii import drawn_inward, drawn_radius
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import convex, is_valid, shape_text
from minkref.fuzz.plane.families.holed_pairs import plate
from minkref.fuzz.plane.families.integer_rings import scattered, untangled

FAMILY, GRID = "offsets", "-grid"  # `offset` is a family of pairs
INSETS = "insets"
FAMILIES = {
    FAMILY: "sets to grow by a disc: degenerate ones, and any, at and beside their events",
    FAMILY + GRID: "the same on a grid of 24 bits",
}
INWARD = {
    INSETS: "sets to erode by a disc, likewise: necks about to open, parts about to vanish",
    INSETS + GRID: "the same on a grid of 24 bits",
}
GENERAL = "general"
FACTORS = tuple(map(Fraction, ("1", "1", "1/3", "7/5", "1000/7", "1/1000000", "10000000000/3")))
SHIFTS = tuple(map(Fraction, ("0", "0", "0", "1/3", "-22/7", "1234567", "1/1000000007")))
TURNS: tuple[Point, ...] = ((1, 0), (1, 0), (Fraction(3, 5), Fraction(4, 5)), (2, 1))
BITS = 24
PATIENCE = 200
REGIONS = tuple(kind for kind in KINDS if kind != "a point or a segment")


def drawn_offset(name: CaseName, family: str, seed: int, index: int) -> AskedOffset:
    """The same one for the same numbers. RuntimeError if nothing valid is drawn."""
    dice = Dice(f"minkref {family} {seed} {index}")
    turn, which = divmod(index, 3)
    inward = family in INWARD
    kinds = tuple(INSET_KINDS if inward else KINDS)
    kind = GENERAL if which == 2 else kinds[(2 * turn + which) % len(kinds)]
    degenerate = degenerate_inset if inward else degenerate_set
    on_grid = family.endswith(GRID)
    for _ in range(PATIENCE):
        shape = _general(dice, index) if which == 2 else degenerate(dice, kind)
        shape = _on_grid(dice, shape) if on_grid else _in_fractions(dice, shape)
        text = shape_text(shape)
        if not is_valid(text):
            continue
        P = _core.PolygonSet.from_json(text)
        _, _, wide, high = extent([p for polygon in shape for p in polygon[0]])
        radius, position = (drawn_inward if inward else drawn_radius)(
            dice, P, Fraction(max(wide, high, 1))
        )
        if on_grid:
            radius = rounded(radius, unit_for(abs(radius), BITS))
        return AskedOffset(name, P, radius, family, f"{kind}, {position}")
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing valid")


def drawn_shape(dice: Dice, index: int, on_grid: bool) -> tuple[Shape, Fraction]:
    """A set of a degenerate kind or of any shape, perhaps not valid, and its size."""
    shape = (
        _general(dice, index) if dice.random() < 0.5 else degenerate_set(dice, dice.choice(REGIONS))
    )
    shape = _on_grid(dice, shape) if on_grid else _in_fractions(dice, shape)
    _, _, wide, high = extent([p for polygon in shape for p in polygon[0]])
    return shape, Fraction(max(wide, high, 1))


def _general(dice: Dice, index: int) -> Shape:
    """Convex sets, outlines of any shape, plates with holes; perhaps two of them apart."""
    reach = dice.choice((12, 40, 1000))
    most = 4 + min(index // 30, 12)
    shape: Shape = []
    for k in range(dice.choice((1, 1, 2))):
        way = dice.randrange(3)
        if way == 0:
            own: Shape = [[convex(dice, dice.randint(3, most), reach)]]
        elif way == 1:
            ring = untangled(scattered(dice, dice.randint(4, most + 2), reach, reach))
            own = [[[*ring]]] if ring else [[convex(dice, 5, reach)]]
        else:
            own = scaled([plate(dice, dice.randint(1, 3), 3)], max(1, reach // 12))
        shift = 0 if not k else reach * 2 + dice.randint(1, reach)
        shape += moved(own, shift, dice.randint(-reach // 2, reach // 2))
    return shape


def _in_fractions(dice: Dice, shape: Shape) -> Shape:
    """Turned, perhaps by an irrational angle and grown by a root, then scaled and moved."""
    c, s = dice.choice(TURNS)
    turned = mapped(shape, lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1]))
    factor, dx, dy = dice.choice(FACTORS), dice.choice(SHIFTS), dice.choice(SHIFTS)
    return moved(scaled(turned, factor), dx, dy)


def _on_grid(dice: Dice, shape: Shape) -> Shape:
    """Scales by a power of two: few bits stay few."""
    return scaled(shape, Fraction(2) ** dice.choice((0, 0, 0, 7, -3, 30, -40)))
