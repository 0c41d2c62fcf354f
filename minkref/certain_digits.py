"""Numbers for tables: shows only certain digits."""

from __future__ import annotations

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction

DIGITS = 10


def between(low: float | None, high: float | None, digits: int = DIGITS) -> str:
    """Write a number between two doubles with as many digits as both doubles share when rounded, at
    most `digits`: the number itself rounds to these digits. None means a bound beyond the range of
    doubles."""
    if low is None or high is None or not (math.isfinite(low) and math.isfinite(high)):
        return "beyond doubles"
    for count in range(digits, 0, -1):
        text = f"{low:.{count}g}"
        if text == f"{high:.{count}g}":
            return text
    return f"between {low:.3g} and {high:.3g}"


def enclosing(low: str, high: str, digits: int = 6) -> str:
    """Write the bounds of a number, exact texts of any size, rounded away from the number."""
    texts = []
    for number, way in ((low, ROUND_FLOOR), (high, ROUND_CEILING)):
        exact = Fraction(number)
        context = Context(prec=digits, rounding=way, Emax=10**9, Emin=-(10**9))
        near = context.divide(Decimal(exact.numerator), Decimal(exact.denominator))
        near = near.normalize(context)
        small = -5 <= near.adjusted() < digits
        texts.append(f"{near:f}" if small else f"{near:e}".replace("e+", "e"))
    return texts[0] if texts[0] == texts[1] else f"between {texts[0]} and {texts[1]}"


def root(square: Fraction, digits: int) -> str:
    """Write a rational number's square root, rounded to `digits` digits, for any size."""
    wide = Context(prec=digits + 20, Emax=10**9, Emin=-(10**9))
    near = wide.sqrt(wide.divide(Decimal(square.numerator), Decimal(square.denominator)))
    rounded = Context(prec=digits, Emax=10**9, Emin=-(10**9)).plus(near)
    value = float(rounded)
    is_double = math.isfinite(value) and (value != 0 or rounded == 0)
    return f"{value:.{digits}g}" if is_double else str(rounded).replace("E", "e")
