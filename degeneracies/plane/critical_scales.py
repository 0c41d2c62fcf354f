"""Critical scales that lie close together, near zero or far out, or belong to a special kind of
number."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

from minkref import _core
from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.shapes import changed, framed, number
from minkref.fuzz.geometry.plane import Ring, box

FAR, FARTHEST = Fraction(2) ** 10, Fraction(2) ** 200
APART = 8  # scales that accumulate: each this many times the one before, at least


def _rooms(widths: list[Fraction], heights: list[Fraction]) -> list[Ring]:
    """Boxes side by side."""
    rooms: list[Ring] = []
    x = Fraction(0)
    for width, height in zip(widths, heights, strict=True):
        rooms.append(box(x, 0, width, height))
        x += width + max(Fraction(1), width / 8)
    return rooms


def _rooms_for(dice: Random, widths: list[Fraction], scale: Fraction) -> Draft:
    """A box with width 1 in rooms higher than wide: the room with width w closes to a segment at
    the scale w."""
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
    widths = [Fraction(2) ** (sign * step * k) for k in range(1, dice.randint(3, 5) + 1)]
    return changed(dice, _rooms_for(dice, widths, dice.choice(widths[1:])))


def _near_zero(dice: Random, size: int) -> Draft:
    return _many(dice, -1)


def _far_out(dice: Random, size: int) -> Draft:
    return _many(dice, 1)


def _is_tiny(facts: Facts) -> bool:
    return facts.scale < 1 / FAR and _accumulates(facts, 1 / FARTHEST, Fraction(1))


def _is_large(facts: Facts) -> bool:
    return facts.scale > FAR and _accumulates(facts, Fraction(1), FARTHEST)


def _accumulates(facts: Facts, low: Fraction, high: Fraction) -> bool:
    """Whether the scale belongs to a chain of at least three scales in this interval at which a
    hole of the sum dies, each at least APART times the scale before."""
    events = _core.DynamicSum(facts.P, facts.Q, str(low), str(high)).topology_events()
    deaths = {
        Fraction(scale)
        for scale, feature, change, *_ in events
        if (feature, change) == ("hole", "death")
    }
    if facts.scale not in deaths:
        return False
    found = [facts.scale]
    for scale in sorted(deaths):
        if scale >= APART * found[-1]:
            found.append(scale)
    for scale in sorted(deaths, reverse=True):
        if APART * scale <= found[0]:
            found.insert(0, scale)
    return len(found) >= 3


FAMILIES = (
    Family(
        "scales-within-60-bits",
        "event scales that differ by less than 2^-60",
        _close(60),
        _is_close(60),
    ),
    Family(
        "scales-within-200-bits",
        "event scales that differ by less than 2^-200",
        _close(200),
        _is_close(200),
    ),
    Family(
        "scale-is-no-float", "an event scale that is no binary fraction", _no_float, _is_no_float
    ),
    Family("scale-is-a-float", "an event scale that is a double", _float, _is_float),
    Family("scales-near-zero", "event scales that accumulate near zero", _near_zero, _is_tiny),
    Family("scales-far-out", "event scales that accumulate far out", _far_out, _is_large),
)
