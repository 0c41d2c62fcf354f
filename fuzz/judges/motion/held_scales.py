"""Held scales before decisions at single scales: at each bound, just beside it and in each range,
and before and behind each stop. Plane and space alike."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

import minkref

HAIR = Fraction(1, 1 << 20)
#: Whether the part collides on a path at a scale.
Collides = Callable[[Sequence[Any], Fraction], bool]
Held = minkref.HeldScales | minkref.SpaceHeldScales


def scales_beside(found: Held) -> list[Fraction]:
    """Scales that reveal a wrong bound of any of the three answers."""
    scales = {Fraction(1, 50), Fraction(1), Fraction(50)}
    for answer in (found, found.fits, found.way):
        for one in answer.ranges:
            for end in {one.low, one.high} - {None, Fraction(0)}:
                assert end is not None
                scales |= {end, end * (1 - HAIR), end * (1 + HAIR)}
            scales.add((one.low + one.high) / 2 if one.high is not None else 2 * one.low + 1)
    return sorted(scales)


def wrong_scales(
    found: Held, way: Sequence[Any], scales: Sequence[Fraction], collides: Collides
) -> Iterator[str]:
    """Differences between the answer and decisions."""
    for scale in scales:
        fits, passes = not collides(way[:1], scale), not collides(way, scale)
        told = (scale in found.fits, scale in found.way, scale in found)
        if told != (fits, passes, fits and not passes):
            yield f"at {scale} fits, passes, held: {told}, not {(fits, passes)}"


def wrong_stops(found: Held, way: Sequence[Any], contact: str, collides: Collides) -> Iterator[str]:
    """Stops behind which the part does not collide, or before which it does."""
    for one in found.held:
        stop = one.stop
        if stop.scale not in one.scales:
            yield f"the stop at {stop.scale} is at no scale of {one.scales}"
        before, behind = _up_to(way, stop.segment, stop.t, contact), _beyond(way, stop)
        if collides(before, stop.scale):
            yield f"collides before the stop at {stop.scale}"
        if not collides(behind, stop.scale):
            yield f"does not collide behind the stop at {stop.scale}"


def wrong_ends(found: Held) -> Iterator[str]:
    """Ends of held ranges with a contact absent from the right answer at the same scale."""
    for one in found.held:
        for end, at in ((one.begin, one.scales.low), (one.end, one.scales.high)):
            if end is None:
                continue
            bounds = found.fits.bounds if end.at_place else found.way.bounds
            if end.contact.scale != at or end.contact not in bounds:
                yield f"the contact at {at} is no bound"
        if one.begin is not None and one.begin.contact.blocks == one.begin.at_place:
            yield f"the wrong kind of contact at {one.scales.low}"
        if one.end is not None and one.end.contact.blocks != one.end.at_place:
            yield f"the wrong kind of contact at {one.scales.high}"


def _up_to(way: Sequence[Any], segment: int, t: Fraction, contact: str) -> list[Any]:
    """The way up to a place; with contact forbidden up to just before it."""
    if contact == "forbidden":
        if t == 0 and segment > 0:
            segment, t = segment - 1, Fraction(1)
        t *= 1 - HAIR
    return [*way[: segment + 1], _at(way, segment, t)]


def _beyond(way: Sequence[Any], stop: Any) -> list[Any]:
    """The way up to just behind a stop."""
    segment, t = stop.segment, stop.t
    if t == 1 and segment + 2 < len(way):
        segment, t = segment + 1, Fraction(0)
    return [*way[: segment + 1], _at(way, segment, t + (1 - t) * HAIR)]


def _at(way: Sequence[Any], segment: int, t: Fraction) -> Any:
    a, b = way[segment], way[min(segment + 1, len(way) - 1)]
    return tuple(p + t * (q - p) for p, q in zip(a, b, strict=True))
