"""Scales at which a part keeps a distance from obstacles, as values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import coordinates, expect_sets, number
from minkref.motion.path_values import Feature
from minkref.motion.scale_ranges import CONTACTS, Number, path_of, window_of, word_of

Bounds = tuple[float, float]


@dataclass(frozen=True)
class RootScale:
    """A scale, rational or the root of a quadratic polynomial: `expression`, exact, as `1/2 +
    3/4*sqrt(5)`; `bounds`, neighbouring doubles around it, equal for a double."""

    expression: str
    bounds: Bounds

    @property
    def rational(self) -> Fraction | None:
        """Returns a rational scale, else None."""
        return None if "sqrt" in self.expression else Fraction(self.expression)


@dataclass(frozen=True)
class ClearRange:
    """Scales from one to another; `high` is None without an end."""

    low: RootScale
    high: RootScale | None
    low_in: bool
    high_in: bool

    def __str__(self) -> str:
        high = "inf" if self.high is None else self.high.expression
        left, right = "[" if self.low_in else "(", "]" if self.high_in else ")"
        return f"{left}{self.low.expression}, {high}{right}"


@dataclass(frozen=True)
class ClearBound:
    """An end of a range (`blocks`: scales just above come too near) or a beginning, the features at
    the distance there, and the place of the path: its segment, and how far along (`t`)."""

    scale: RootScale
    blocks: bool
    segment: int
    t: RootScale
    part: Feature
    obstacle: Feature


@dataclass(frozen=True)
class ClearScales:
    """The scales at which a part keeps a distance: `ranges`, ascending; `bounds`, their ends inside
    the window."""

    ranges: tuple[ClearRange, ...]
    bounds: tuple[ClearBound, ...]

    def holds(self, scale: Fraction) -> bool:
        """Tell whether ranges include a scale, by doubles around ends. Raises ValueError strictly
        between an irrational end's two doubles."""
        return any(
            _beyond(scale, one.low, one.low_in)
            and (one.high is None or _beyond(-scale, _negative(one.high), one.high_in))
            for one in self.ranges
        )


def clear_scales(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    path: Sequence[Sequence[Number]],
    clearance: Number,
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
) -> ClearScales:
    """Find the scales at which the part, carried along the polyline, keeps at least a distance from
    the obstacles; with contact forbidden, more than it. Exact: ends are rational, or roots of
    quadratic polynomials. Validates both sets. O(k n m) for k path vertices and n, m vertices.
    Raises BadInput, Refusal. docs/paths.md."""
    rule = word_of("contact", contact, CONTACTS)
    expect_sets(part=part, obstacles=obstacles)
    places = [(x, y) for x, y in path_of(path, 2)]
    part.validate("part")
    obstacles.validate("obstacles")
    window, far = window_of(from_scale, to_scale), number("clearance", clearance)
    return clear_scales_of(_core.clear_scales(part, obstacles, places, far, rule, *window))


def clear_fit(
    part: _core.PolygonSet,
    container: _core.PolygonSet,
    at: Sequence[Number],
    clearance: Number,
    contact: str = "allowed",
) -> ClearScales:
    """Find the scales at which the part lies in the container at a place and keeps a distance from
    the boundary, likewise."""
    rule = word_of("contact", contact, CONTACTS)
    expect_sets(part=part, container=container)
    x, y = coordinates("at", at, 2)
    part.validate("part")
    container.validate("container")
    far = number("clearance", clearance)
    return clear_scales_of(_core.scales_clear_at(part, container, (x, y), far, rule))


def clear_scales_of(rows: Any) -> ClearScales:
    ranges, bounds = rows
    return ClearScales(
        tuple(
            ClearRange(RootScale(*low), None if high is None else RootScale(*high), low_in, high_in)
            for low, low_in, high, high_in in ranges
        ),
        tuple(
            ClearBound(
                RootScale(*scale), blocks, segment, RootScale(*t), Feature(*own), Feature(*other)
            )
            for scale, blocks, segment, t, own, other in bounds
        ),
    )


def _negative(scale: RootScale) -> RootScale:
    low, high = scale.bounds
    exact = scale.rational
    return RootScale(scale.expression if exact is None else str(-exact), (-high, -low))


def _beyond(scale: Fraction, end: RootScale, is_in: bool) -> bool:
    exact = end.rational
    if exact is not None:
        return scale > exact or (is_in and scale == exact)
    low, high = end.bounds
    if low < scale < high:
        raise ValueError(f"{scale} is too near to {end.expression}")
    return scale >= high
