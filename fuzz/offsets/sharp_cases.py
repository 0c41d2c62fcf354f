"""Sets to grow or erode with sharp corners, by turns: before any two moved parts meet, and at any
radius."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.manner import SHARP, Manner
from minkref.fuzz.offsets.offset_cases import PATIENCE, drawn_shape
from minkref.fuzz.offsets.radii import drawn_inward, drawn_radius
from minkref.fuzz.offsets.sharp_front import front_of, is_free
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import is_valid, shape_text

FAMILY, GRID = "sharp-joins", "-grid"
FAMILIES = {
    FAMILY: "sets to grow or erode with sharp corners, before their moved sides meet and after",
    FAMILY + GRID: "the same on a grid of 24 bits",
}
BITS = 24
EIGHTHS = (1, 2, 4, 6, 7)  # of the time of the first meeting


def drawn_sharp(name: CaseName, family: str, seed: int, index: int) -> AskedOffset:
    """The same one for the same numbers: to grow and to erode by turns. RuntimeError if none is
    drawn."""
    dice = Dice(f"minkref {family} {seed} {index}")
    turn, inward = divmod(index, 2)
    on_grid = family.endswith(GRID)
    for _ in range(PATIENCE):
        shape, size = drawn_shape(dice, index, on_grid)
        if turn % 4:
            shape = shape[:1]  # a library may take one polygon only
        text = shape_text(shape)
        if not is_valid(text):
            continue
        P = _core.PolygonSet.from_json(text)
        radius, where = (drawn_inward if inward else drawn_radius)(dice, P, size)
        case = AskedOffset(name, P, radius, family, where, (), Manner(SHARP))
        first = front_of(case).meeting
        if first and turn % 2 == 0:
            radius = first * Fraction(dice.choice(EIGHTHS), -8 if inward else 8)
        if on_grid:
            radius = rounded(radius, unit_for(abs(radius), BITS))
        case = replace(case, radius=radius)
        when = "before parts meet" if is_free(case, Fraction(0)) else f"parts meet, {where}"
        return replace(case, position=f"{'eroded' if inward else 'grown'}, {when}")
    raise RuntimeError(f"{family}:{seed}:{index} draws nothing valid")
