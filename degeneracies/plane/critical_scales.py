"""Critical scales that lie close together, near zero or far out, or are numbers of some kind."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

from minkref.degeneracies.draft import Draft, Facts, Family
from minkref.degeneracies.shapes import changed, framed, number
from minkref.fuzz.families.drawing import Ring, box


def _rooms(widths: list[Fraction], heights: list[Fraction]) -> list[Ring]:
    """Boxes side by side."""
    rooms: list[Ring] = []
    x = Fraction(0)
    for width, height in zip(widths, heights, strict=True):
        rooms.append(box(x, 0, width, height))
        x += width + max(Fraction(1), width / 8)
    return rooms


def _rooms_for(dice: Random, widths: list[Fraction], scale: Fraction) -> Draft:
    """A box of width 1 in rooms that are higher than they are wide: the one of width w closes to a
    segment at the scale w."""
    heights = [width * number(dice, 3, 5) for width in widths]
    P = box(0, 0, 1, number(dice, 1, 4, (4, 5)))
    margin = dice.randint(1, 3)
    return Draft([[P]], [framed(_rooms(widths, heights), margin)], scale)


def _close(bits: int) -> Callable[[Random, int], Draft]:
    def draw(dice: Random, size: int) -> Draft:
        width = number(dice, 1, 6)
        near = width * Fraction(dice.randint(1, 9), 2 ** (bits + 8))
        widths = [width, width + near, width - near / 3][: dice.randint(2, 3)]
        dice.shuffle(widths)
        return changed(dice, _rooms_for(dice, widths, width))

    return draw


def _is_close(bits: int) -> Callable[[Facts], bool]:
    def belongs(facts: Facts) -> bool:
        return bool(facts.topology) and facts.gap > bits

    return belongs


def _no_float(dice: Random, size: int) -> Draft:
    width = Fraction(dice.randint(1, 999), dice.choice((3, 7, 9, 11, 49, 99, 186, 1001)))
    return changed(dice, _rooms_for(dice, [width], width))


def _is_no_float(facts: Facts) -> bool:
    return bool(facts.topology) and not _is_binary(facts.scale)


def _float(dice: Random, size: int) -> Draft:
    bits = dice.randint(1, 52)
    width = Fraction(2 * dice.randrange(2**bits) + 1, 2 ** dice.randint(0, bits))
    draft = changed(dice, _rooms_for(dice, [width], width))
    return draft if _is_binary(draft.scale) else _rooms_for(dice, [width], width)


def _is_binary(value: Fraction) -> bool:
    return value.denominator & (value.denominator - 1) == 0


def _is_float(facts: Facts) -> bool:
    return bool(facts.topology) and Fraction(float(facts.scale)) == facts.scale


def _many(dice: Random, sign: int) -> Draft:
    step = dice.choice((8, 16, 30))
    widths = [Fraction(2) ** (sign * step * k) for k in range(1, dice.randint(3, 5))]
    return changed(dice, _rooms_for(dice, widths, widths[-1]))


def _near_zero(dice: Random, size: int) -> Draft:
    return _many(dice, -1)


def _far_out(dice: Random, size: int) -> Draft:
    return _many(dice, 1)


def _is_tiny(facts: Facts) -> bool:
    return bool(facts.topology) and facts.scale < Fraction(1, 2**10)


def _is_large(facts: Facts) -> bool:
    return bool(facts.topology) and facts.scale > 2**10


FAMILIES = (
    Family(
        "scales-within-60-bits",
        "event scales that differ by less than 2^-60",
        ("event", "hole-closes", "close-scales", "parallel-edges", "overlap", "tight-passage"),
        _close(60),
        _is_close(60),
    ),
    Family(
        "scales-within-200-bits",
        "event scales that differ by less than 2^-200",
        ("event", "hole-closes", "close-scales", "parallel-edges", "overlap", "tight-passage"),
        _close(200),
        _is_close(200),
    ),
    Family(
        "scale-is-no-float",
        "an event scale that is no binary fraction",
        ("event", "hole-closes", "scale-is-no-float", "parallel-edges", "overlap", "tight-passage"),
        _no_float,
        _is_no_float,
    ),
    Family(
        "scale-is-a-float",
        "an event scale that is a double",
        ("event", "hole-closes", "parallel-edges", "overlap", "tight-passage"),
        _float,
        _is_float,
    ),
    Family(
        "scales-near-zero",
        "event scales that accumulate near zero",
        ("event", "hole-closes", "magnitudes", "parallel-edges", "overlap", "tight-passage"),
        _near_zero,
        _is_tiny,
    ),
    Family(
        "scales-far-out",
        "event scales that accumulate far out",
        ("event", "hole-closes", "magnitudes", "parallel-edges", "overlap", "tight-passage"),
        _far_out,
        _is_large,
    ),
)
