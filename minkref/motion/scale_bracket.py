"""Brackets of the scale up to which a question holds that never holds above it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref.exact import approximate

TOLERANCE = Fraction(1, 10**9)
Told = Callable[[Fraction, Fraction], None]


@dataclass(frozen=True)
class Room:
    """The greatest distance that a part keeps at one scale, with the best choice of its way.
    `order`: the sign of this distance less the requested distance, exact; `near`: the distance
    rounded; `cause`: its limit, as in DiscRadii; `place`: where the limit is, rounded."""

    order: int
    near: float
    cause: str
    place: tuple[float, float] | None = None


@dataclass(frozen=True)
class ScaleBracket:
    """Two scales around the end of the scales at which a question holds. The question holds at all
    scales up to `holds_to` (0: at no scale that was asked) and at no scale from `fails_from` on
    (None: it held at every scale asked). Both were decided exactly. `is_exact`: they are equal, and
    this scale is the end itself; it belongs to the scales iff `end_in`. `cause` and `place`: what
    limits the distance at `holds_to`; `decisions`: the number of scales asked."""

    holds_to: Fraction
    fails_from: Fraction | None
    is_exact: bool
    end_in: bool
    cause: str
    place: tuple[float, float] | None
    decisions: int

    @property
    def is_empty(self) -> bool:
        """Tell whether the question holds at no scale above 0."""
        return self.is_exact and self.holds_to == 0


@dataclass(frozen=True)
class BracketSearch:
    """Finds a bracket for the question whether a part keeps a `clearance`.

    `room_at` answers for a scale; at 0 for the part shrunk to a point. Its distance never grows
    with the scale; if `strict`, it shrinks. `allowed`: the distance itself is enough. The bracket's
    width is at most `tolerance` times its upper end.

    Doubles only choose the scales to ask. Each chosen scale is a simple fraction near a secant's
    root, so that a rational end is met: equality there makes the answer exact if `strict`."""

    room_at: Callable[[Fraction], Room]
    clearance: Fraction
    allowed: bool
    strict: bool
    tolerance: Fraction = TOLERANCE
    told: Told | None = None  # hears each bracket on the way

    def holds(self, room: Room) -> bool:
        return room.order > 0 or (room.order == 0 and self.allowed)

    def between(self, low: Fraction, high: Fraction) -> ScaleBracket:
        """Search the scales from `low` (0: above 0) up to `high`."""
        first = self.room_at(low)
        if low == 0 and first.order == 0 and (self.strict or not self.allowed):
            return self._ended(Fraction(0), first, 1)
        if first.order < 0 or (low > 0 and not self.holds(first)):
            return self._failed(low, first)
        last = self.room_at(high)
        if last.order == 0 and self.strict:
            return self._ended(high, last, 2)
        if self.holds(last):
            return ScaleBracket(high, None, False, self.allowed, last.cause, last.place, 2)
        return self._narrowed(low, first, high, last)

    def _narrowed(self, low: Fraction, first: Room, high: Fraction, last: Room) -> ScaleBracket:
        probe = _Probe(self, low, high)
        probe.at_low, probe.at_high = first.near, last.near
        best, decisions = first, 2
        least = self.tolerance * high
        while not probe.is_narrow:
            if probe.low == 0 and first.order == 0 and probe.high < least:
                break  # perhaps at no scale at all
            scale = probe.next_scale()
            room = self.room_at(scale)
            decisions += 1
            if room.order == 0 and self.strict:
                return self._ended(scale, room, decisions)
            if self.holds(room):
                best = room
            probe.learn(scale, room.near, self.holds(room))
            if self.told is not None:
                self.told(probe.low, probe.high)
        return ScaleBracket(
            probe.low, probe.high, False, self.allowed, best.cause, best.place, decisions
        )

    def _ended(self, scale: Fraction, room: Room, decisions: int) -> ScaleBracket:
        is_in = self.allowed and scale > 0
        return ScaleBracket(scale, scale, True, is_in, room.cause, room.place, decisions)

    def _failed(self, low: Fraction, room: Room) -> ScaleBracket:
        is_exact = low == 0
        return ScaleBracket(Fraction(0), low, is_exact, False, room.cause, room.place, 1)


class _Probe:
    """A shrinking bracket. Rounded distances at both ends choose the next scale: a little before or
    behind a secant's root, in turn, so that both ends come near to the end sought."""

    def __init__(self, search: BracketSearch, low: Fraction, high: Fraction) -> None:
        self.tolerance, self.clearance = search.tolerance, approximate(str(search.clearance))
        self.low, self.high = low, high
        self.at_low = self.at_high = 0.0  # distances
        self.before: tuple[Fraction, float] | None = None  # a scale below the lower end
        self.expected: bool | None = None  # of the next scale
        self.caution = Fraction(1, 8)  # more after a surprise
        self.widths = [high - low]

    @property
    def is_narrow(self) -> bool:
        return self.high - self.low <= self.tolerance * self.high

    def learn(self, scale: Fraction, distance: float, holds: bool) -> None:
        if holds:
            self.before = self.low, self.at_low
            self.low, self.at_low = scale, distance
        else:
            self.high, self.at_high = scale, distance
        self.widths.append(self.high - self.low)
        if self.expected is not None:
            self.caution *= Fraction(1, 2) if self.expected == holds else 8
            self.caution = max(self.caution, Fraction(1, 64))

    def next_scale(self) -> Fraction:
        """Choose a simple fraction strictly between the ends."""
        self.expected = None
        width = self.high - self.low
        root = self._root()
        is_slow = len(self.widths) > 4 and width > self.widths[-5] / 4
        if root is None or is_slow:
            return simplest(self.low + width * 3 / 8, self.low + width * 5 / 8)
        margin = self.caution * min(width * width / self.high, 2 * (root - self.low))
        margin = min(max(margin, self.tolerance * self.high / 4), width / 8)
        simple = simplest(max(root - margin, self.low + margin / 8), root + margin)
        if simple < self.high and 200 * margin * simple.denominator**2 < 1:
            return simple  # the end itself, if that is a simple fraction
        self.expected = root - self.low > self.high - root
        target = root - margin if self.expected else root + margin
        target = min(max(target, self.low + margin), self.high - margin)
        return simplest(target - margin / 2, target + margin / 2)

    def _root(self) -> Fraction | None:
        """Estimate the end sought by a line through two distances: those at the ends, or two below
        where nothing is left at the upper end."""
        line = (self.high, self.at_high) if self.at_high > 0 else self.before
        if line is None or line[0] == self.low or self.at_low < self.clearance:
            return None
        share = (self.at_low - self.clearance) / (self.at_low - line[1] or math.nan)
        if not math.isfinite(share):
            return None
        root = self.low + Fraction(share) * (line[0] - self.low)
        return root if self.low <= root < self.high else None


def simplest(low: Fraction, high: Fraction) -> Fraction:
    """Return the fraction with the least denominator in a closed interval of positive numbers."""
    whole = []
    while True:
        floor = low.numerator // low.denominator
        if low == floor or floor + 1 <= high:
            whole.append(floor if low == floor else floor + 1)
            break
        whole.append(floor)
        low, high = 1 / (high - floor), 1 / (low - floor)
    value = Fraction(whole.pop())
    while whole:
        value = whole.pop() + 1 / value
    return value
