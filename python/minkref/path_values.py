"""For which scales a part passes along a path, fits or is trapped, as values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, number, text_of
from minkref.errors import Refusal, choice

CONTACTS = ("allowed", "forbidden")
PATH_ROUTES = ("pieces", "contacts", "index")
Number = str | int | Fraction
Place = tuple[Fraction, Fraction]
POINT = "a pair of exact numbers: strs as '7/5' or '0.1', ints or Fractions"


@dataclass(frozen=True)
class ScaleRange:
    """Scales from one to another; each end belongs to the range or does not. `high` is None where
    there is no end. A single scale is a range with equal ends."""

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


def ranges_of(window: ScaleRange, valid: Sequence[ScaleRange]) -> list[tuple[ScaleRange, bool]]:
    """A window in ranges that follow each other: those that are given, ascending, and what is
    between them, which are the ones that are not valid."""
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


@dataclass(frozen=True)
class Feature:
    """A vertex, or the edge that starts at it (`is_edge`), by ring and index."""

    is_edge: bool
    ring: int
    index: int


@dataclass(frozen=True)
class PathBound:
    """Where valid scales end (`blocks`: those just above are not valid) or begin, and the contact
    that is the cause: the place on the path (the segment, how far along it, the point), the
    features of part and obstacles that touch there, and where they do."""

    scale: Fraction
    blocks: bool
    segment: int
    t: Fraction
    at: Place
    part: Feature
    obstacle: Feature
    touching: Place


@dataclass(frozen=True)
class ValidScales:
    """The scales at which a part passes along a path: `ranges`, ascending; `bounds`, the ends that
    are no end of the window; whether the part is `star_shaped` about its origin (the ranges are
    then one that starts at 0); how it was found (`statistics`)."""

    ranges: tuple[ScaleRange, ...]
    bounds: tuple[PathBound, ...]
    star_shaped: bool
    statistics: dict[str, int]

    def __contains__(self, scale: Number) -> bool:
        return any(scale in one for one in self.ranges)

    @property
    def largest(self) -> Fraction | None:
        """The least number that no valid scale exceeds; None where there is none, or no scale."""
        return self.ranges[-1].high if self.ranges else None


@dataclass(frozen=True)
class FreeBound:
    """Where scales of a fit or a trap end (`ends`) or begin. `event`: "contact" where the part
    touches at a place that was asked for, as `contact` says; otherwise what happens to a hole of
    the sum of obstacles and turned part at the place `at`: birth, death, merge, split, touch."""

    scale: Fraction
    ends: bool
    event: str
    at: Place
    contact: PathBound | None


@dataclass(frozen=True)
class FreeScales:
    """The scales at which a part fits, passes or is trapped, by translations alone: `ranges`,
    ascending; `bounds`, their ends; `proofs`, scales at, just below and just above each end and
    whether the static sum there has the property too."""

    ranges: tuple[ScaleRange, ...]
    bounds: tuple[FreeBound, ...]
    proofs: tuple[tuple[Fraction, bool], ...]

    def __contains__(self, scale: Number) -> bool:
        return any(scale in one for one in self.ranges)

    @property
    def largest(self) -> Fraction | None:
        """The least number that no scale exceeds; None where there is none, or no scale."""
        return self.ranges[-1].high if self.ranges else None

    @property
    def smallest(self) -> Fraction | None:
        """The greatest number that no scale is below; None where there is no scale."""
        return self.ranges[0].low if self.ranges else None


def valid_scales(
    robot: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    path: Sequence[Sequence[Number]],
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    route: str = "pieces",
) -> ValidScales:
    """The scales at which the robot, scaled about its origin and carried along the polyline with
    its origin on it, never turned, does not meet the obstacles: with contact allowed their
    interiors, with contact forbidden the closed sets. Exact: ranges with open and closed ends, and
    single scales. Without bounds, all scales above 0. `route`: pieces, contacts or index, which
    share little. Both sets are validated first. Cost: docs/paths.md. Raises BadInput, Refusal."""
    expect_sets(robot=robot, obstacles=obstacles)
    robot.validate("robot")
    obstacles.validate("obstacles")
    places = _path(path)
    bounds = [
        None if bound is None else number(name, bound)
        for name, bound in (("from_scale", from_scale), ("to_scale", to_scale))
    ]
    rows = _core.valid_scales(
        robot,
        obstacles,
        places,
        _one_of("contact", contact, CONTACTS),
        bounds[0],
        bounds[1],
        _one_of("route", route, PATH_ROUTES),
    )
    return ValidScales(
        scale_ranges(rows[0]),
        tuple(_path_bound(row) for row in rows[1]),
        _core.star_shaped(robot),
        dict(rows[2]),
    )


def largest_fit(
    part: _core.PolygonSet,
    container: _core.PolygonSet,
    at: Sequence[Number] | None = None,
    between: Sequence[Sequence[Number]] | None = None,
    contact: str = "allowed",
) -> FreeScales:
    """The scales at which the part, scaled about its origin, lies in the container: with its origin
    at a place (`at`), at some place (neither `at` nor `between`), or at two places and all along
    some way from one to the other (`between`), by translations. `largest` is the scale that is
    asked for as a rule. Exact. Both sets are validated first. Cost: docs/paths.md. Raises BadInput,
    Refusal."""
    expect_sets(part=part, container=container)
    part.validate("part")
    container.validate("container")
    rule = _one_of("contact", contact, CONTACTS)
    if at is not None and between is not None:
        what = "a place and two places are different questions"
        raise Refusal(what, "largest_fit", "give `at` or `between`, or neither")
    if at is not None:
        return _free(_core.fit_at(part, container, _point("at", at), rule))
    if between is None:
        return _free(_core.fit_anywhere(part, container, rule))
    if isinstance(between, str) or not isinstance(between, Sequence) or len(between) != 2:
        raise TypeError(f"between has to be two places, and is of type {type(between).__name__}")
    start, end = (_point("between", place) for place in between)
    return _free(_core.fit_between(part, container, start, end, rule))


def trapped_scales(
    part: _core.PolygonSet,
    assembly: _core.PolygonSet,
    at: Sequence[Number],
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
) -> FreeScales:
    """The scales at which the part, scaled about its origin and with it at a place, does not meet
    the assembly, and no translation takes it away without a collision. A rotation may free it all
    the same. Exact. Without bounds, all scales above 0. Both sets are validated first. Cost:
    docs/paths.md. Raises BadInput, Refusal."""
    expect_sets(part=part, assembly=assembly)
    part.validate("part")
    assembly.validate("assembly")
    place = _point("at", at)
    bounds = [
        None if bound is None else number(name, bound)
        for name, bound in (("from_scale", from_scale), ("to_scale", to_scale))
    ]
    rule = _one_of("contact", contact, CONTACTS)
    return _free(_core.trapped_scales(part, assembly, place, rule, bounds[0], bounds[1]))


def _one_of(name: str, value: Any, known: Sequence[str]) -> str:
    word = text_of(name, value)
    if word not in known:
        raise Refusal(f"there is no {name} {word!r}", name, choice(word, known))
    return word


def _point(name: str, value: Any) -> tuple[str, str]:
    if isinstance(value, str) or not isinstance(value, Sequence) or len(value) != 2:
        raise TypeError(f"{name} has to be {POINT}, and is of type {type(value).__name__}")
    x, y = (number(name, one) for one in value)
    return x, y


def _path(path: Any) -> list[tuple[str, str]]:
    if isinstance(path, str | bytes) or not isinstance(path, Sequence):
        raise TypeError(f"path has to be a list of points, and is of type {type(path).__name__}")
    return [_point("path", place) for place in path]


def scale_ranges(rows: Sequence[Any]) -> tuple[ScaleRange, ...]:
    """Of rows (from, whether it belongs to the range, to, whether it does)."""
    return tuple(
        ScaleRange(Fraction(low), None if high is None else Fraction(high), low_in, high_in)
        for low, low_in, high, high_in in rows
    )


def _place(row: tuple[str, str]) -> Place:
    return Fraction(row[0]), Fraction(row[1])


def _path_bound(row: Any) -> PathBound:
    scale, blocks, segment, t, at, part, obstacle, touching = row
    return PathBound(
        Fraction(scale),
        blocks,
        segment,
        Fraction(t),
        _place(at),
        Feature(*part),
        Feature(*obstacle),
        _place(touching),
    )


def _free(rows: Any) -> FreeScales:
    ranges, bounds, proofs, _ = rows
    return FreeScales(
        scale_ranges(ranges),
        tuple(
            FreeBound(
                Fraction(scale),
                ends,
                event,
                _place(at),
                None if contact is None else _path_bound(contact),
            )
            for scale, ends, event, at, contact in bounds
        ),
        tuple((Fraction(scale), holds) for scale, holds in proofs),
    )
