"""Compares written numbers with true numbers: units in the last place, printed digits."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from functools import lru_cache
from typing import Any

import gmpy2

BITS = 1500
Real = Any  # an exact mpq, or an mpfr with BITS bits
LEAST = gmpy2.mpq(1, 2**1074)  # the subnormal doubles' unit
TIE = gmpy2.mpq(1, 2**900)  # relative: closer values of 1,500 bits count as equal
MOST_EXPONENT = 20_000
PRINTED = re.compile(r"[-+−]?(\d+)(?:\.(\d*))?(?:[eE]([-+]?\d+))?")


def use_bits() -> None:
    """Make roots and angles of this process have BITS bits."""
    gmpy2.set_context(gmpy2.context(precision=BITS))


@lru_cache(maxsize=20_000)
def exact(text: str) -> Any:
    """The rational number that a text names: an integer, a fraction, a decimal."""
    if (
        len(text) > 12
        and (found := PRINTED.fullmatch(text))
        and abs(int(found[3] or 0)) > MOST_EXPONENT
    ):
        raise ValueError(f"the exponent of {text[:40]} is too large")
    value = Fraction(text.replace("−", "-"))
    return gmpy2.mpq(value.numerator, value.denominator)


def exact_double(value: float) -> Any:
    """The double as a rational number. Raises ValueError for NaN and infinity."""
    if not math.isfinite(value):
        raise ValueError(f"{value} is no number")
    return gmpy2.mpq(value)


def unit(true: Real) -> Any:
    """The unit in the last place of the doubles about a number, as if doubles had no greatest."""
    if true == 0:
        return LEAST
    exponent = gmpy2.get_exp(gmpy2.mpfr(true)) - 53
    return max(gmpy2.mpq(2) ** exponent, LEAST)


def units_off(written: Any, true: Real) -> float:
    """Distance between a rational number and a true number, divided by `unit(true)`."""
    return float(abs(written - true) / unit(true))


def is_double_of(written: Any, true: Real) -> bool:
    """Whether a written number lies within one unit in the true number's last place."""
    return bool(abs(written - true) <= unit(true) * (1 + TIE))


def last_digit(text: str) -> Any:
    """The value of a one in a printed number's last digit."""
    found = PRINTED.fullmatch(text)
    if not found:
        raise ValueError(f"{text!r} is no printed number")
    places = len(found[2] or "")
    return gmpy2.mpq(10) ** (int(found[3] or 0) - places)


def is_rounded(text: str, true: Real) -> bool:
    """Whether a printed number equals the true number, or a double within a unit, rounded to the
    printed digits."""
    return bool(abs(exact(text) - true) <= (last_digit(text) / 2 + unit(true)) * (1 + TIE))
