"""Exact numbers as texts: reads scales, writes sets, takes digests. No float decides anything
here."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Iterable, Sequence
from decimal import Context, Decimal
from fractions import Fraction
from typing import Any

from minkref.errors import Refusal

LONGEST_SCALE = 1000  # characters
LARGEST_EXPONENT = 1000

_DECIMAL = re.compile(r"[+-]?(\d+(?:\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_FRACTION = re.compile(r"([+-]?\d+)/(\d+)", re.ASCII)


def read_scale(text: str, option: str = "--scale") -> str:
    """The scale in lowest terms, `n` or `n/d`, as `exact_scale` reads it."""
    return str(exact_scale(text, option))


def exact_scale(text: str, option: str) -> Fraction:
    """Read a scale. Decimals and fractions count exactly. Refuses anything but a finite positive
    number."""
    told = text if text.strip() else f'"{text}"'
    where = f"{option} {told[:40]}{'...' if len(told) > 40 else ''}"
    mend = "give a positive number, for example 1, 7/5, 0.25 or 541/186"
    if len(text) > LONGEST_SCALE:
        raise Refusal(f"the scale has more than {LONGEST_SCALE} characters", where, mend, "limit")
    text = text.strip()
    if text.lower().lstrip("+-") in ("nan", "inf", "infinity"):
        raise Refusal("the scale is not a finite number", where, mend, "scale-not-finite")
    if "," in text:
        raise Refusal(
            "this takes one scale, the same for all axes",
            where,
            "give one positive number; `minkref sum`, `convolution`, `certify` and `sweep` take a "
            "factor for each axis",
            "scale-not-uniform",
        )
    value = read_number(text, "scale", where, mend)
    if value == 0:
        raise Refusal("the scale is zero", where, mend, "scale-zero")
    if value < 0:
        raise Refusal("the scale is negative", where, mend, "scale-negative")
    return value


def text_of_bounds(*bounds: Fraction | None) -> list[str | None]:
    """The bounds of a window as the extension module takes them; None for an absent bound."""
    return [None if bound is None else str(bound) for bound in bounds]


def read_point(text: str, option: str = "--point") -> tuple[str, str]:
    """Read `x,y` in lowest terms, both numbers like scales. Refuses anything but two finite
    numbers."""
    mend = "give two numbers, for example 1/3,-0.25"
    x, y = _coordinates(text, option, 2, "point-not-two-numbers", mend)
    return x, y


def read_points(texts: Sequence[str], option: str) -> list[tuple[str, str]]:
    """Several of them."""
    return [read_point(text, option) for text in texts]


def read_space_point(text: str, option: str) -> tuple[str, str, str]:
    """Read `x,y,z` likewise."""
    mend = "give three numbers, for example 1/3,-0.25,2"
    x, y, z = _coordinates(text, option, 3, "point-not-three-numbers", mend)
    return x, y, z


def _coordinates(text: str, option: str, count: int, code: str, mend: str) -> list[str]:
    where = f"{option} {text[:40]}{'...' if len(text) > 40 else ''}"
    parts = text.split(",")
    if len(text) > count * LONGEST_SCALE:
        raise Refusal("the point has too many characters", where, mend, "limit")
    if len(parts) != count:
        raise Refusal("this is not a point", where, mend, code)
    return [str(read_number(part.strip(), "point", where, mend)) for part in parts]


def read_number(text: str, what: str, where: str, mend: str) -> Fraction:
    """Read a decimal or a fraction exactly; refusals call the number `what`."""
    fraction = _FRACTION.fullmatch(text)
    if fraction:
        if int(fraction[2]) == 0:
            raise Refusal("the denominator is zero", where, mend, f"{what}-not-a-number")
        return Fraction(int(fraction[1]), int(fraction[2]))
    decimal = _DECIMAL.fullmatch(text)
    if not decimal:
        raise Refusal(f"the {what} is not a number", where, mend, f"{what}-not-a-number")
    if decimal[2] and abs(int(decimal[2][1:])) > LARGEST_EXPONENT:
        raise Refusal(
            f"the exponent is beyond {LARGEST_EXPONENT}",
            where,
            f"give a number between 1e-{LARGEST_EXPONENT} and 1e{LARGEST_EXPONENT}",
            "limit",
        )
    return Fraction(text)


def approximate(number: str) -> float:
    """Round an exact number `n` or `n/d` of any length to the nearest double; infinite beyond the
    range of doubles."""
    numerator, _, denominator = number.partition("/")
    above, below = _integer(numerator), _integer(denominator or "1")
    try:
        return above / below  # integers: rounded once, half to even
    except OverflowError:
        return math.inf if above > 0 else -math.inf


def _integer(text: str) -> int:
    """Read an integer of any length: int() refuses more than 4,300 digits."""
    return int(text) if len(text) < 4000 else int(Decimal(text))


def in_double_range(number: str) -> float | None:
    """Round an exact number to the nearest double; None if the double is infinite, or zero for a
    nonzero number."""
    value = approximate(number)
    return None if math.isinf(value) or (value == 0 and number != "0") else value


def rounded(number: str, digits: int = 10) -> str:
    """Round an exact number of any size once to `digits` digits, half to even: 17964.13541,
    1.23e-400."""
    value = _divided(number, digits).normalize(Context(prec=digits, Emax=10**9, Emin=-(10**9)))
    if -5 <= value.adjusted() < digits:
        return f"{value:f}"
    return f"{value:e}".replace("e+", "e")


def scientific(number: str) -> str:
    """Round an exact number of any size to seven digits: 1.234567e2000."""
    return f"{_divided(number, 7):.6e}".replace("e+", "e")


def _divided(number: str, digits: int) -> Decimal:
    numerator, _, denominator = number.partition("/")
    context = Context(prec=digits, Emax=10**9, Emin=-(10**9))
    return context.divide(Decimal(numerator), Decimal(denominator or "1"))


def power_of_ten_below(value: Fraction) -> Fraction:
    """Return the greatest power of ten at most equal to a positive number."""
    power = Fraction(10) ** (len(str(value.numerator)) - len(str(value.denominator)))
    return power if power <= value else power / 10


def set_json(polygons: Iterable[tuple[Sequence[Any], Iterable[Sequence[Any]]]]) -> str:
    """Write a polygon set as JSON, from (outer ring, holes) with coordinates that print exactly."""
    return json.dumps(
        {
            "polygons": [
                {"holes": [_ring(hole) for hole in holes], "outer": _ring(outer)}
                for outer, holes in polygons
            ]
        },
        separators=(",", ":"),
    )


def _ring(ring: Sequence[Any]) -> list[list[str]]:
    return [[str(x), str(y)] for x, y in ring]


def digest(canonical_json: str) -> str:
    """Compute the SHA-256 of canonical JSON: equal iff the sets are equal (docs/definitions.md)."""
    return hashlib.sha256(canonical_json.encode("utf-8")).hexdigest()
