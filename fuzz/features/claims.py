"""Bars and bridges as answers write them: radii, chords, counts."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref.fuzz.features.exact_radius import ExactRadius
from minkref.fuzz.geometry.surds import root_bounds
from minkref.fuzz.offsets.distance import Exact
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import MOST_VERTICES, Unreadable, list_in, received

WIDEST = Fraction(1, 10**9)  # of itself: an enclosure of a radius
ROOT_BITS = 200
Chord = tuple[Exact, Exact]


@dataclass(frozen=True)
class Claim:
    """A radius from `low` to `high`; with `square`, its exact square."""

    low: Fraction
    high: Fraction
    square: Fraction | None = None

    @classmethod
    def of(cls, value: Any) -> Claim | None:
        """Reads text, two texts, or square; None is infinity."""
        if value is None:
            return None
        if isinstance(value, dict):
            square = Fraction(value["square"])
            return cls(*root_bounds(square, ROOT_BITS), square)
        low, high = value if isinstance(value, list) else (value, value)
        return cls(Fraction(low), Fraction(high))

    def is_near(self, truth: ExactRadius, half: Fraction) -> bool:
        """Whether some enclosed radius differs by at most `half`."""
        if self.square is not None and not half:
            return truth.compare_square(self.square) == 0
        low, high = max(self.low - half, Fraction(0)), self.high + half
        if high < 0:
            return False
        return truth.compare_square(low**2) >= 0 >= truth.compare_square(high**2)

    @property
    def text(self) -> str:
        if self.square is not None:
            return f"sqrt({self.square})"
        return str(self.low) if self.low == self.high else f"{float(self.low)!r} or so"


@dataclass(frozen=True)
class ClaimedBar:
    birth: Claim
    death: Claim | None

    def is_longer(self, length: Fraction) -> bool:
        return self.death is None or self.death.low - self.birth.high > length

    @property
    def text(self) -> str:
        return f"from {self.birth.text} to {self.death.text if self.death else 'infinity'}"


@dataclass(frozen=True)
class ClaimedFeatures:
    """An answer's JSON, written by `features_text`."""

    text: str

    @cached_property
    def value(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(self.text)
        return found

    @cached_property
    def bars(self) -> list[ClaimedBar]:
        found = []
        for birth, death in self.value["bars"]:
            begun = Claim.of(birth)
            assert begun is not None
            found.append(ClaimedBar(begun, Claim.of(death)))
        return found

    @cached_property
    def bridges(self) -> list[Chord] | None:
        given = self.value.get("bridges")
        if given is None:
            return None
        ends = [[(Fraction(x), Fraction(y)) for x, y in chord] for chord in given]
        return [(first, second) for first, second in ends]


def features_text(value: dict[str, Any], declaration: Declaration) -> str:
    """Writes members as text, bars and bridges sorted. Raises Unreadable."""
    bars = list_in(value, "bars")
    if len(bars) > MOST_VERTICES:
        raise Unreadable(f"{len(bars):,} bars, more than {MOST_VERTICES:,}")
    found: dict[str, Any] = {"bars": sorted((_bar(bar, declaration) for bar in bars), key=str)}
    if "bridges" in value:
        chords = (_chord(chord, declaration) for chord in list_in(value, "bridges"))
        found["bridges"] = sorted(chords)
    for word in ("components", "holes"):
        if word not in value:
            continue
        if isinstance(value[word], bool) or not isinstance(value[word], int):
            raise Unreadable(f"{word} is not a whole number")
        found[word] = value[word]
    return json.dumps(found, separators=(",", ":"))


def _bar(bar: Any, declaration: Declaration) -> list[Any]:
    if not isinstance(bar, list) or len(bar) != 2:
        raise Unreadable("a bar is not a pair of radii")
    birth, death = (None if each is None else _radius(each, declaration) for each in bar)
    if birth is None:
        raise Unreadable("a bar's birth is null")
    return [birth, death]


def _radius(value: Any, declaration: Declaration) -> Any:
    if isinstance(value, dict):
        if set(value) != {"square"}:
            raise Unreadable('a radius is a number, two numbers, or {"square": number}')
        square = _number(value["square"], declaration)
        if Fraction(square) < 0:
            raise Unreadable("a square is negative")
        return {"square": square}
    if not isinstance(value, list):
        return _number(value, declaration)
    if len(value) != 2:
        raise Unreadable("a radius between bounds has two numbers")
    low, high = (_number(each, declaration) for each in value)
    if not 0 <= Fraction(high) - Fraction(low) <= WIDEST * abs(Fraction(high)):
        raise Unreadable("the bounds of a radius differ by more than a billionth of it")
    return [low, high]


def _chord(chord: Any, declaration: Declaration) -> list[list[str]]:
    if not isinstance(chord, list) or len(chord) != 2:
        raise Unreadable("a bridge is not a pair of points")
    if not all(isinstance(point, list) and len(point) == 2 for point in chord):
        raise Unreadable("an end of a bridge is not a pair of numbers")
    return sorted([_number(x, declaration) for x in point] for point in chord)


def _number(value: Any, declaration: Declaration) -> str:
    return str(Fraction(received(value, declaration)))
