"""Numbers between text and arithmetic: exact both ways, never through a double."""

from __future__ import annotations

import re
from fractions import Fraction
from math import gcd

NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?")
FRACTION = re.compile(r"([+-]?\d+)/(\d+)")
MOST_DIGITS = 4_000  # an interpreter converts 4,300, unless it is set otherwise

Point = tuple[Fraction, Fraction]
Vector = tuple[int, int]


class InputError(ValueError):
    """The input gives no operand, no scale, or no readable file; the text says why."""


def number(text: str) -> Fraction:
    """Read a number from text: integer, decimal, power of ten, or fraction of integers, without
    white space."""
    if len(text) > MOST_DIGITS:
        raise InputError(f"a number of more than {MOST_DIGITS} letters: {text[:40]}...")
    if not text.isascii():
        raise InputError(f"{text!r} is not a number")
    ratio = FRACTION.fullmatch(text)
    if ratio:
        if not ratio[2].strip("0"):
            raise InputError(f"{text}: the denominator is zero")
        return fraction(text)
    if not NUMBER.fullmatch(text):
        raise InputError(f"{text!r} is not a number")
    exponent = re.search(r"[eE](.*)", text)
    if exponent and abs(int(exponent[1])) > MOST_DIGITS:
        raise InputError(f"{text[:60]}: the exponent is beyond {MOST_DIGITS}")
    return fraction(text)


def fraction(text: str) -> Fraction:
    try:
        return Fraction(text)
    except ValueError as error:  # more digits than the interpreter is set to convert
        raise InputError(f"a number of {len(text)} letters: {error}") from error


def positive(text: str) -> Fraction:
    """Read a scale, a positive number."""
    value = number(text.strip())
    if value <= 0:
        raise InputError(f"a scale is positive, and {text} is not")
    return value


def text_of(value: Fraction) -> str:
    """Write `n`, or `n/d` in lowest terms with d > 1."""
    return str(value)


def primitive(dx: int, dy: int) -> Vector:
    """Return the shortest integer vector along (dx, dy), which must not be zero."""
    common = gcd(dx, dy)
    return dx // common, dy // common


def cross(u: Vector, v: Vector) -> int:
    return u[0] * v[1] - u[1] * v[0]


def dot(u: Vector, v: Vector) -> int:
    return u[0] * v[0] + u[1] * v[1]
