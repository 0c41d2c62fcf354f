"""Ranges of scales, as values that answer paths, fits and traps; and the reading of their
arguments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref.argument_types import coordinates, number, text_of
from minkref.errors import Refusal, choice

CONTACTS = ("allowed", "forbidden")
PATH_ROUTES = ("pieces", "contacts", "index")
Number = str | int | Fraction


@dataclass(frozen=True)
class ScaleRange:
    """Scales from one to another; each end belongs to the range or not. `high` is None without an
    end. A single scale is a range with equal ends."""

    low: Fraction
    high: Fraction | None
    low_in: bool
    high_in: bool

    def __contains__(self, scale: Number) -> bool:
        value = Fraction(number("scale", scale))
        above = value > self.low or (self.low_in and value == self.low)
        return above and (
            self.high is None or value < self.high or (self.high_in and value == self.high)
        )

    def __str__(self) -> str:
        high = "inf" if self.high is None else str(self.high)
        return f"{'[' if self.low_in else '('}{self.low}, {high}{']' if self.high_in else ')'}"


@dataclass(frozen=True)
class ScalesInRanges:
    """Scales as `ranges`, ascending."""

    ranges: tuple[ScaleRange, ...]

    def __contains__(self, scale: Number) -> bool:
        return any(scale in one for one in self.ranges)

    @property
    def largest(self) -> Fraction | None:
        """The least number that no scale exceeds; None without such a number, or without scales."""
        return self.ranges[-1].high if self.ranges else None

    @property
    def smallest(self) -> Fraction | None:
        """The greatest number at most equal to every scale; None without scales."""
        return self.ranges[0].low if self.ranges else None


def ranges_of(window: ScaleRange, valid: Sequence[ScaleRange]) -> list[tuple[ScaleRange, bool]]:
    """Split a window into consecutive ranges: the given valid ranges, ascending, and the invalid
    ranges between them."""
    parts: list[tuple[ScaleRange, bool]] = []
    low, low_in = window.low, window.low_in
    for one in valid:
        gap = ScaleRange(low, one.low, low_in, not one.low_in)
        if gap.low < one.low or (gap.low_in and gap.high_in):
            parts.append((gap, False))
        parts.append((one, True))
        if one.high is None:
            return parts
        low, low_in = one.high, not one.high_in
    rest = ScaleRange(low, window.high, low_in, window.high_in)
    if rest.high is None or low < rest.high or (low_in and rest.high_in):
        parts.append((rest, False))
    return parts


def range_values(rows: Sequence[Any]) -> tuple[ScaleRange, ...]:
    return tuple(
        ScaleRange(Fraction(low), None if high is None else Fraction(high), low_in, high_in)
        for low, low_in, high, high_in in rows
    )


def word_of(name: str, value: Any, known: Sequence[str]) -> str:
    word = text_of(name, value)
    if word not in known:
        raise Refusal(f"there is no {name} {word!r}", name, choice(word, known))
    return word


def window_of(from_scale: Any, to_scale: Any) -> tuple[str | None, str | None]:
    low, high = (
        None if bound is None else number(name, bound)
        for name, bound in (("from_scale", from_scale), ("to_scale", to_scale))
    )
    return low, high


def path_of(path: Any, count: int, name: str = "path") -> list[list[str]]:
    if isinstance(path, str | bytes) or not isinstance(path, Sequence):
        raise TypeError(f"{name} has to be a list of points, and is of type {type(path).__name__}")
    return [coordinates(name, place, count) for place in path]
