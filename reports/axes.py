"""Axes of a picture, with round and exact numbers; overlong numbers become offsets from a named
base."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from minkref.plane.exact_frame import Frame

LONGEST = 7  # characters of a number at an axis
LONGEST_BASE = 24
LETTER = 7.0  # a letter's width, in picture units
APART = (60.0, 36.0)  # of numbers across and up, at the least

Area = tuple[float, float, float, float]


@dataclass(frozen=True)
class Axis:
    """`ticks`: values and labels. `base`: the number to add to each label; empty for 0."""

    ticks: list[tuple[Fraction, str]]
    base: str = ""


def axis(low: Fraction, high: Fraction, most: int) -> Axis:
    """The multiples of 1, 2 or 5 times a power of ten from `low` to `high`: at most `most`."""
    if low == high:
        return Axis([(low, rounded(low))])
    step, power = _step((high - low) / most)
    values = [step * k for k in range(math.ceil(low / step), math.floor(high / step) + 1)]
    texts = [_text(value, power) for value in values]
    if all(len(text) <= LONGEST for text in texts):
        return Axis(list(zip(values, texts, strict=True)))
    coarse = _power(power + 2)
    base = math.floor(low / coarse) * coarse
    offsets = [_text(value - base, power) for value in values]
    return Axis(list(zip(values, offsets, strict=True)), _base(base, power + 2))


def rounded(value: Fraction, digits: int = 6) -> str:
    """A number of any size, to so many digits."""
    try:
        return f"{float(value):.{digits}g}"
    except OverflowError:
        power = (
            math.floor(math.log10(abs(value.numerator)) - math.log10(value.denominator)) - digits
        )
        return _text(Fraction(int(value / _power(power + 1))) * _power(power + 1), power + 1)


def _power(exponent: int) -> Fraction:
    return Fraction(10) ** exponent


def _step(least: Fraction) -> tuple[Fraction, int]:
    """The smallest step not below `least`, and the exponent of its power of ten."""
    power = math.floor(math.log10(least.numerator) - math.log10(least.denominator)) - 1
    while True:
        for factor in (1, 2, 5):
            if factor * _power(power) >= least:
                return factor * _power(power), power
        power += 1


def _text(value: Fraction, power: int, small: int = 4) -> str:
    """A multiple of a power of ten: 0.25, 1200, 3e-9; with more than `small` decimals as the
    last."""
    units = int(value / _power(power))
    if not units:
        return "0"
    while units % 10 == 0:
        units, power = units // 10, power + 1
    sign, digits = "-" if units < 0 else "", str(abs(units))
    if 0 <= power <= 5 and len(digits) + power <= LONGEST - 1:
        return sign + digits + "0" * power
    if -small <= power < 0:
        digits = digits.rjust(1 - power, "0")
        return f"{sign}{digits[:power]}.{digits[power:]}"
    point = f".{digits[1:]}" if len(digits) > 1 else ""
    return f"{sign}{digits[0]}{point}e{power + len(digits) - 1}"


def _base(value: Fraction, power: int) -> str:
    text = _text(value, power, LONGEST_BASE // 2)
    return text if len(text) <= LONGEST_BASE else f"{rounded(value)} (rounded)"


def room_of_numbers(seen: Area, frame: Frame) -> float:
    """The width of the numbers at the left."""
    texts = [text for _, text in _axis_of(seen, frame, 1, 8).ticks]
    return LETTER * max(map(len, texts), default=1)


def drawn_axes(area: Area, seen: Area, frame: Frame) -> str:
    """SVG: the area's outline, grid lines, numbers outside. `area`: left, top, right, bottom in the
    picture; `seen`: left, bottom, right, top of the same area in the frame."""
    left, top, right, bottom = area
    lines, texts = "", []
    bases = []
    for k, name in enumerate("xy"):
        length = (right - left, bottom - top)[k]
        found = _axis_of(seen, frame, k, int(length / APART[k]))
        if found.base:
            bases.append(f"{name} = {found.base} + …")
        start = (frame.left, frame.bottom)[k]
        for value, text in found.ticks:
            part = (float((value - start) * frame.factor) - seen[k]) / (seen[k + 2] - seen[k])
            if k == 0:
                x = left + part * length
                lines += f"M{x:.2f} {top:.2f}V{bottom:.2f}"
                texts.append(
                    f'<text x="{x:.2f}" y="{bottom + 13:.2f}" text-anchor="middle">{text}</text>'
                )
            else:
                y = bottom - part * length
                lines += f"M{left:.2f} {y:.2f}H{right:.2f}"
                texts.append(
                    f'<text x="{left - 4:.2f}" y="{y + 4:.2f}" text-anchor="end">{text}</text>'
                )
    texts += [
        f'<text x="{left + 4:.2f}" y="{top + 14 * (row + 1):.2f}">{text}</text>'
        for row, text in enumerate(bases)
    ]
    outline = f"M{left:.2f} {top:.2f}H{right:.2f}V{bottom:.2f}H{left:.2f}Z"
    return f'<path class="grid" d="{lines}"/><path class="axis" d="{outline}"/>{"".join(texts)}'


def _axis_of(seen: Area, frame: Frame, k: int, most: int) -> Axis:
    start = (frame.left, frame.bottom)[k]
    low, high = (start + Fraction(seen[end]) / frame.factor for end in (k, k + 2))
    return axis(low, high, max(most, 2))
