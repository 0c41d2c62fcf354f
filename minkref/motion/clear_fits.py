"""Scales at which a part that keeps a distance fits into a container, passes or is trapped, as
values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from minkref import _core
from minkref.argument_types import coordinates, expect_sets, number, whole
from minkref.disc.disc import read_clearance, read_tolerance
from minkref.exact import exact_scale, text_of_bounds
from minkref.motion.clear_rooms import (
    Container,
    Places,
    WayOut,
    refuse_other_stars,
    refuse_without_extent,
    shrinks_strictly,
)
from minkref.motion.clear_values import ClearScales, clear_scales_of
from minkref.motion.scale_bracket import BracketSearch, ScaleBracket, Told
from minkref.motion.scale_ranges import CONTACTS, Number, window_of, word_of

BILLIONTH = "1/1000000000"
DOUBLINGS = 40  # of the scale of a part that nothing stops
Place = tuple[str, str]
Window = tuple[Fraction | None, Fraction | None]


@dataclass(frozen=True)
class ClearTrap:
    """The scales at which a part keeps a distance at a place, and no way that keeps it leads away.
    `free`: at the place, exact; `escapes`: the bracket of the scales at which the part gets away,
    among the free ones; None without free scales, or without obstacles. The part is trapped at the
    free scales from `escapes.fails_from` on (if `escapes.is_exact`: at that scale itself iff not
    `end_in`)."""

    free: ClearScales
    escapes: ScaleBracket | None

    @property
    def is_empty(self) -> bool:
        """Tell whether the part is trapped at no scale that was asked."""
        found = self.escapes
        if found is None or found.fails_from is None:
            return True
        last = self.free.ranges[-1]
        end = None if last.high is None else last.high.rational
        if end is None or found.fails_from < end:
            return False
        return found.fails_from > end or not last.high_in or (found.is_exact and found.end_in)


@dataclass(frozen=True)
class KeptDistance:
    """The distance to keep; `allowed`: the distance itself is enough; how narrow a bracket has to
    be, relative to its scales; threads to use; what hears each bracket on the way."""

    clearance: Fraction
    allowed: bool
    tolerance: Fraction
    threads: int = 1
    told: Told | None = None

    def bracket(
        self, asked: Container | WayOut, strict: bool, low: Fraction, high: Fraction
    ) -> ScaleBracket:
        search = BracketSearch(
            asked.room, self.clearance, self.allowed, strict, self.tolerance, self.told
        )
        return search.between(low, high)

    def fits(self, asked: Container, name: str) -> ScaleBracket:
        """Find the bracket of a part, named in refusals, in a container; both are valid sets."""
        given = asked.places is not None
        refuse_without_extent(asked.part, name)
        asked.refuse_without_area()
        refuse_other_stars(asked.part, name, given)
        most = asked.most
        if most <= 0:
            return ScaleBracket(Fraction(0), Fraction(0), True, False, "meets", None, 0)
        found = self.bracket(asked, shrinks_strictly(asked.part, given), Fraction(0), most)
        # Beyond the box that has room, the part keeps less.
        return (
            found
            if found.fails_from is not None
            else replace(found, fails_from=most, is_exact=True)
        )

    def trap(
        self,
        part: _core.PolygonSet,
        obstacles: _core.PolygonSet,
        place: Place,
        window: Window,
        name: str,
    ) -> ClearTrap:
        """Find the scales of a trap; likewise."""
        refuse_without_extent(part, name)
        refuse_other_stars(part, name, True)
        rule = CONTACTS[0] if self.allowed else CONTACTS[1]
        free = clear_scales_of(
            _core.clear_scales(
                part, obstacles, [place], str(self.clearance), rule, *text_of_bounds(*window)
            )
        )
        if not free.ranges or obstacles.is_empty:
            return ClearTrap(free, None)
        asked = WayOut(part, obstacles, place, self.clearance, self.threads)
        strict, low = shrinks_strictly(part, True), window[0] or Fraction(0)
        end = free.ranges[-1].high
        if end is not None:
            high = end.rational or Fraction(end.bounds[0])
            return ClearTrap(free, self.bracket(asked, strict, low, high))
        high = max(Fraction(1), 2 * low)
        for _ in range(DOUBLINGS):
            found = self.bracket(asked, strict, low, high)
            if found.fails_from is not None:
                break
            high *= 2
        return ClearTrap(free, found)


def clear_fits(
    part: _core.PolygonSet,
    container: _core.PolygonSet,
    clearance: Number,
    between: Sequence[Sequence[Number]] | None = None,
    contact: str = "allowed",
    tolerance: Number = BILLIONTH,
    threads: int = 1,
) -> ScaleBracket:
    """Bracket the scales at which the part lies somewhere in the container and keeps a distance
    from the boundary (with contact forbidden: more than it), or does so all along a way between two
    places.

    Both ends are decided exactly, and differ by `tolerance` times the scale at most; an end at
    which the greatest distance equals the clearance is found if it is a simple fraction. Some point
    of the part has to see all of it; with `between` its origin. Validates both sets. Takes about
    ten sums, each with a DiscIndex of its places. Raises BadInput, LimitExceeded, Refusal
    (`not-star-shaped`). docs/paths.md."""
    asked = _asked(contact, clearance, tolerance, threads)
    expect_sets(part=part, container=container)
    part.validate("part")
    container.validate("container")
    places = None if between is None else two_places(between)
    where = Container(part, container, "container", places, asked.clearance, asked.threads)
    return asked.fits(where, "part")


def clear_trap(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    at: Sequence[Number],
    clearance: Number,
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    tolerance: Number = BILLIONTH,
    threads: int = 1,
) -> ClearTrap:
    """Bracket the scales at which the part keeps a distance from the obstacles at a place, and no
    translation that keeps it takes the part away. The part has to be star-shaped about its origin.
    As clear_fits, with the scales that are free at the place exact, as clear_scales."""
    asked = _asked(contact, clearance, tolerance, threads)
    expect_sets(part=part, obstacles=obstacles)
    part.validate("part")
    obstacles.validate("obstacles")
    x, y = coordinates("at", at, 2)
    low, high = (
        None if text is None else exact_scale(text, name)
        for text, name in zip(
            window_of(from_scale, to_scale), ("from_scale", "to_scale"), strict=True
        )
    )
    return asked.trap(part, obstacles, (x, y), (low, high), "part")


def two_places(between: Sequence[Sequence[Number]]) -> Places:
    if isinstance(between, str) or not isinstance(between, Sequence) or len(between) != 2:
        raise TypeError(f"between has to be two places, and is of type {type(between).__name__}")
    (ax, ay), (bx, by) = (coordinates("between", place, 2) for place in between)
    return (ax, ay), (bx, by)


def _asked(contact: str, clearance: Number, tolerance: Number, threads: int) -> KeptDistance:
    allowed = word_of("contact", contact, CONTACTS) == CONTACTS[0]
    return KeptDistance(
        read_clearance(number("clearance", clearance), "clearance"),
        allowed,
        read_tolerance(number("tolerance", tolerance), "tolerance"),
        max(1, whole("threads", threads)),
    )
