"""Sets and lines to grow with other joins and caps: corners of all angles, no side much shorter
than the radius, no corner nearly straight."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.join_pieces import is_plain
from minkref.fuzz.offsets.line_cases import any_lines, comb, cross, drawn_width, exact_lines, spiral
from minkref.fuzz.offsets.lines import segments_of
from minkref.fuzz.offsets.manner import BEVEL, CAPS, FLAT, MITRE, ROUND, SQUARE, Manner
from minkref.fuzz.offsets.offset_cases import PATIENCE, drawn_shape
from minkref.fuzz.offsets.radii import drawn_radius
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import is_valid, shape_text

FAMILY, GRID = "joins", "-grid"
FAMILIES = {
    FAMILY: "sets and lines to grow with mitred, bevelled, squared corners, flat, square ends",
    FAMILY + GRID: "the same on a grid of 24 bits",
}
BITS = 24
SEGMENT = ((Fraction(0), Fraction(0)), (Fraction(4), Fraction(3)))
LIMITS = tuple(map(Fraction, ("2", "5/2", "3", "5", "10")))
OF_SETS = (MITRE, BEVEL, SQUARE, MITRE)
OF_LINES = ((ROUND, FLAT), (ROUND, SQUARE), (MITRE, FLAT), (BEVEL, SQUARE), (SQUARE, SQUARE),
            (BEVEL, FLAT), (MITRE, ROUND))  # fmt: skip


def manner_of(dice: Dice, index: int, is_line: bool) -> Manner:
    """Each in turn."""
    turn = index // 2
    join, cap = (
        OF_LINES[turn % len(OF_LINES)] if is_line else (OF_SETS[turn % len(OF_SETS)], CAPS[0])
    )
    return Manner(join, cap, dice.choice(LIMITS) if join == MITRE else None)


def drawn_joins(name: CaseName, family: str, seed: int, index: int) -> AskedOffset:
    """The same one for the same numbers: sets and lines in turn. RuntimeError if none is drawn."""
    dice = Dice(f"minkref {family} {seed} {index}")
    on_grid = family.endswith(GRID)
    for _ in range(PATIENCE):
        found = (_lines if index % 2 else _set)(dice, name, family, index, on_grid)
        if found is not None and is_plain(found):
            return found
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing plain")


def _lines(dice: Dice, name: CaseName, family: str, index: int, on_grid: bool) -> AskedOffset:
    rough = [line for line in dice.choice((any_lines, any_lines, comb, cross, spiral))(dice)
             if len(line) > 1]  # fmt: skip
    factor = Fraction(1) if on_grid else Fraction(dice.randint(1, 9), dice.choice((1, 7)))
    lines = exact_lines(dice, rough, factor)
    lines = tuple(line for line in lines if line[0] != line[-1]) or (SEGMENT,)
    radius, position = drawn_width(dice, lines)
    radius = rounded(radius, unit_for(radius, BITS)) if on_grid else radius
    manner = manner_of(dice, index, True)
    where = f"lines, {manner}, {position}"
    return AskedOffset(name, segments_of(lines), radius, family, where, lines, manner)


def _set(dice: Dice, name: CaseName, family: str, index: int, on_grid: bool) -> AskedOffset | None:
    shape, size = drawn_shape(dice, index, on_grid)
    text = shape_text(shape)
    if not is_valid(text):
        return None
    P = _core.PolygonSet.from_json(text)
    radius, position = drawn_radius(dice, P, size)
    radius = rounded(radius, unit_for(radius, BITS)) if on_grid else radius
    manner = manner_of(dice, index, False)
    return AskedOffset(name, P, radius, family, f"a set, {manner}, {position}", (), manner)
