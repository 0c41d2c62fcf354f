"""Numbers on their way to a target and back, as its declaration says."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.number_text import GRAMMAR, LONGEST_NUMBER, is_number
from minkref.fuzz.targets.declaration import Declaration

MOST_VERTICES = 400_000  # per answer, comparable in time


class Unreadable(ValueError):
    """An unreadable answer; the text says why."""


def double(text: str) -> float:
    """Returns the nearest double. OverflowError without one, also for a nonzero number that would
    become zero."""
    exact = Fraction(text)
    value = float(exact)
    if math.isinf(value) or (value == 0 and exact != 0):
        raise OverflowError(text[:40])
    return value


def received(number: Any, declaration: Declaration) -> str:
    """A number of an answer as `n` or `n/d`."""
    if isinstance(number, bool) or not isinstance(number, int | float | str):
        raise Unreadable(f"{json.dumps(number)[:40]} is no number")
    if isinstance(number, float):
        if declaration.numbers == "text":
            what = "numbers are texts n or n/d and JSON integers, unless `double` is declared"
            raise Unreadable(f"{number!r}: {what}")
        if not math.isfinite(number):
            raise Unreadable("a number is not finite")
        return str(Fraction(number))
    if isinstance(number, int):
        if declaration.numbers == "double":
            try:
                return str(Fraction(float(number)))
            except OverflowError as error:
                raise Unreadable("a number is beyond the range of doubles") from error
        return str(number)
    if declaration.numbers == "double":
        raise Unreadable(f"{number[:40]!r}: numbers are JSON numbers where `double` is declared")
    if len(number) > LONGEST_NUMBER:
        raise Unreadable(f"a number has more than {LONGEST_NUMBER:,} characters")
    if not is_number(number):
        raise Unreadable(f"{number[:40]!r} is not a number: {GRAMMAR}")
    return number


def list_in(value: dict[str, Any], field: str) -> list[Any]:
    found = value.get(field)
    if not isinstance(found, list):
        raise Unreadable(f"{field} is not a list")
    return found


def sent_number(number: Fraction, declaration: Declaration) -> str | float:
    return str(number) if declaration.numbers == "text" else double(str(number))


def received_scale(value: Any, declaration: Declaration) -> Fraction:
    """Reads a scale, which may be a text also for targets with doubles."""
    if isinstance(value, str):
        declaration = replace(declaration, numbers="text")
    return Fraction(received(value, declaration))


def sent_scale(text: str) -> str | list[str]:
    """A scale as a text; with a factor for each axis, their list."""
    parts = text.split(",")
    return text if len(parts) == 1 else parts
