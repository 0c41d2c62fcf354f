"""Coordinates a + b s of tracks in doubles, for all scales at which they are near the picture."""

from __future__ import annotations

from fractions import Fraction

from minkref.errors import Refusal

NEAR = 16  # times the picture; beyond it a and b s cancel


def double(number: Fraction, what: str) -> float:
    """The double next to a number; a refusal where there is none."""
    try:
        return float(number)
    except OverflowError:
        raise out_of_range(what) from None


def out_of_range(what: str) -> Refusal:
    return Refusal(
        f"{what} is beyond the range of doubles, which a browser draws with",
        "view",
        "scale the operands, or choose a narrower window",
        "limit",
    )


def linear(a: Fraction, b: Fraction, last_scale: Fraction, reach: Fraction) -> list[float]:
    """[r, m, c] with a + b s = r + m (s - c). It depends on a and b only, so coordinates that are
    equal at all scales are equal in doubles. c is 0 unless a or b s is far greater than `reach`,
    the size of the picture: then it is near the zero of a + b s, and r is small."""
    if abs(a) <= NEAR * reach and abs(b) * last_scale <= NEAR * reach:
        return [double(a, "a coordinate"), double(b, "a coordinate"), 0.0]
    centre = double(-a / b, "a coordinate") if b else 0.0
    rest = a + b * Fraction(centre)
    return [double(rest, "a coordinate"), double(b, "a coordinate"), centre]
