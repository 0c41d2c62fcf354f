"""Coordinates that are large, small, or both, and an event that depends on their last digit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import gcd, lcm
from random import Random

from minkref.degeneracies.plane.contacts import FAMILIES as CONTACTS
from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.holes import FAMILIES as HOLES
from minkref.fuzz.geometry.plane import Point, Shape, mapped, moved, scaled

BASES = tuple(
    family
    for family in (*HOLES, *CONTACTS)
    if family.name
    in ("hole-to-segment", "hole-to-polyline", "fits-hole", "fits-notch", "fits-slot")
)
LARGEST_DOUBLE = Fraction(2) ** 1024 - Fraction(2) ** 971
LEAST_NORMAL = Fraction(1, 2**1022)
LEAST_DOUBLE = Fraction(1, 2**1074)
INTEGERS = (
    (-(2**31), 2**31 - 1),
    (-(2**53), 2**53),  # beyond, doubles leave out integers
    (-(2**62), 2**62),  # the difference 2^63 does not fit into 64 bits
    (-(2**63), 2**63 - 1),
)


def _base(dice: Random, size: int) -> Draft:
    return dice.choice(BASES).draw(dice, size)


def _mixed(dice: Random, size: int) -> Draft:
    """P tiny, and the scale large, or the other way round."""
    draft = _base(dice, size)
    factor = Fraction(10) ** (dice.choice((-1, 1)) * dice.randint(9, 30))
    return replace(draft, P=scaled(draft.P, factor), scale=draft.scale / factor)


def _far(dice: Random, size: int) -> Draft:
    draft = _base(dice, size)
    far = [dice.choice((-1, 1)) * (10 ** dice.randint(12, 20) + dice.randint(0, 9)) for _ in "xyxy"]
    return replace(draft, P=moved(draft.P, far[0], far[1]), Q=moved(draft.Q, far[2], far[3]))


def _doubles(dice: Random, size: int) -> Draft:
    """Whole multiples of the least double, or of the step from the largest to the next below."""
    kind = dice.randrange(3)
    if kind == 0:
        reach = 2 ** dice.choice((0, 12, 24, 36, 48))
        unit, low, high, ends = LEAST_DOUBLE, 1, 2**20 + 2 * reach, (1, 1)
    else:
        most = LEAST_NORMAL if kind == 1 else LARGEST_DOUBLE
        reach = 2**52 if kind == 1 else 2**53 - 1
        unit, low, high = most / reach, -reach, reach
        ends = dice.choice(((low, high), (high, low)))
    P, Q = _placed(dice, _base(dice, size), low, high, ends, reach)
    unit *= dice.choice((1, -1))
    return Draft(scaled(P, unit), scaled(Q, unit), Fraction(1))


def _integers(dice: Random, size: int) -> Draft:
    turn = dice.randrange(2)
    low, high = dice.choice(INTEGERS)
    ends = ((low, high), (high, low))[turn]
    P, Q = _placed(dice, _base(dice, size), low, high, ends, high)
    return Draft(P, Q, Fraction(1))


def _placed(
    dice: Random, draft: Draft, low: int, high: int, ends: tuple[int, int], reach: int
) -> tuple[Shape, Shape]:
    """Moves a draft to the scale 1 and whole coordinates between `low` and `high`. Along each axis
    both operands are stretched, the longer operand to more than a quarter of `reach` unless longer
    already; one operand goes to the axis's end, and the other has points on the same side of 0, so
    that the sum reaches further."""
    shapes = [scaled(draft.P, draft.scale), draft.Q]
    for axis, end in enumerate(ends):
        rows = [[Fraction(p[axis]) for polygon in s for ring in polygon for p in ring]
                for s in shapes]  # fmt: skip
        step = _measure([c - min(row) for row in rows for c in row])
        lengths = [int((max(row) - min(row)) / step) for row in rows]
        most = max(1, reach // max(lengths))
        stretch = dice.randint((most + 1) // 2, most)
        first = dice.randrange(2)
        for k, (row, length) in enumerate(zip(rows, lengths, strict=True)):
            least, last = low, high - stretch * length
            if k == first:
                least = last = low if end == low else last
            elif end > 0:
                least = max(low, 1 - stretch * length)
            else:
                last = min(last, -1)
            start = dice.randint(least, last)
            shapes[k] = _along(shapes[k], axis, min(row), stretch / step, start)
    return shapes[0], shapes[1]


def _measure(lengths: list[Fraction]) -> Fraction:
    """Returns the largest number that divides all lengths."""
    below = lcm(*(length.denominator for length in lengths))
    return Fraction(gcd(*(int(length * below) for length in lengths)), below)


def _along(shape: Shape, axis: int, least: Fraction, factor: Fraction, start: int) -> Shape:
    """With `least` at `start`, and lengths along this axis multiplied."""

    def change(p: Point) -> Point:
        c = (p[axis] - least) * factor + start
        return (c, p[1]) if axis == 0 else (p[0], c)

    return mapped(shape, change)


def _is(condition: Callable[[Facts], bool]) -> Callable[[Facts], bool]:
    """Adds the condition that the arrangement has an event at the scale."""
    return lambda facts: bool(facts.arrangement) and condition(facts)


def _ratio(facts: Facts) -> Fraction:
    """The less extreme ratio: between the operands' sizes, or between the scale and 1."""
    p, q = (max(abs(c) for v in vs for c in v) for vs in (facts.vertices.P, facts.vertices.Q))
    return min(max(p / q, q / p), max(facts.scale, 1 / facts.scale))


def _are_doubles(facts: Facts) -> bool:
    """Whether all coordinates are doubles, and either subnormal with the least double among them;
    or the largest or the least normal double occurs in both directions."""
    values = {abs(c) for c in facts.coordinates}
    if max(values) > LARGEST_DOUBLE or any(Fraction(float(c)) != c for c in values):
        return False
    if max(values) < LEAST_NORMAL:
        return min(values - {0}) == LEAST_DOUBLE
    return any(_goes_beyond(facts, -most, most) for most in (LEAST_NORMAL, LARGEST_DOUBLE))


def _are_integers(facts: Facts) -> bool:
    return all(c.denominator == 1 for c in facts.coordinates) and any(
        _goes_beyond(facts, Fraction(low), Fraction(high)) for low, high in INTEGERS
    )


def _goes_beyond(facts: Facts, low: Fraction, high: Fraction) -> bool:
    """The operands go from the one to the other exactly, the sum further both ways."""
    values = facts.coordinates
    least, most = (
        [extreme(p[axis] for p in facts.vertices.P) * facts.scale
         + extreme(q[axis] for q in facts.vertices.Q) for axis in (0, 1)]
        for extreme in (min, max)
    )  # fmt: skip
    return (min(values), max(values)) == (low, high) and min(least) < low and max(most) > high


FAMILIES = (
    Family(
        "mixed-magnitudes",
        "operands of very different size that meet at a scale as different",
        _mixed,
        _is(lambda facts: _ratio(facts) > 10**6),
    ),
    Family(
        "large-translation",
        "operands far from the origin",
        _far,
        _is(lambda facts: min(map(abs, facts.coordinates)) > 10**11),
    ),
    Family(
        "limits-of-float64",
        "doubles up to the largest, up to the least normal, or down to the least",
        _doubles,
        _is(_are_doubles),
    ),
    Family(
        "limits-of-integers",
        "integers from limit to limit of 32, 53, 62 or 64 bits, and a sum beyond",
        _integers,
        _is(_are_integers),
    ),
)
