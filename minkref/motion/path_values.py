"""Scales for which a part passes along a path, fits or is trapped, as values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, overload

from minkref import _core
from minkref.argument_types import coordinates, expect_sets, number
from minkref.errors import Refusal
from minkref.motion.scale_ranges import CONTACTS as CONTACTS
from minkref.motion.scale_ranges import PATH_ROUTES as PATH_ROUTES
from minkref.motion.scale_ranges import (
    Number,
    ScalesInRanges,
    path_of,
    range_values,
    window_of,
    word_of,
)
from minkref.motion.scale_ranges import ScaleRange as ScaleRange
from minkref.motion.space_values import (
    SpaceFitScales,
    SpaceFreeScales,
    SpaceValidScales,
    Surface,
    fit_anywhere_in_space,
    fit_at_in_space,
    trapped_in_space,
    valid_scales_in_space,
)

Place = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Feature:
    """A vertex, or the edge that starts there (`is_edge`), by ring and index."""

    is_edge: bool
    ring: int
    index: int


@dataclass(frozen=True)
class PathBound:
    """An end of valid scales (`blocks`: scales just above are not valid) or a beginning, and the
    contact that causes it: the place on the path (segment, fraction of the segment, point), the
    touching features of part and obstacles, and the touching point."""

    scale: Fraction
    blocks: bool
    segment: int
    t: Fraction
    at: Place
    part: Feature
    obstacle: Feature
    touching: Place


@dataclass(frozen=True)
class ValidScales(ScalesInRanges):
    """The scales at which a part passes along a path: `ranges`, ascending; `bounds`, their ends
    inside the window; `star_shaped`, whether the part is star-shaped about its origin (the ranges
    are then a single range from 0); `statistics` of the computation."""

    bounds: tuple[PathBound, ...]
    star_shaped: bool
    statistics: dict[str, int]


@dataclass(frozen=True)
class BadPolygon:
    """Places and scales at which a convex piece of the part collides with a convex piece of the
    obstacles on a segment of the path: a convex polygon with corners (t, s), counter-clockwise, t
    the fraction of the segment, s the scale. Pieces are given by their corners, the part's piece at
    scale 1."""

    segment: int
    part: tuple[Place, ...]
    obstacle: tuple[Place, ...]
    corners: tuple[Place, ...]


@dataclass(frozen=True)
class FreeBound:
    """An end (`ends`) or a beginning of scales for a fit or a trap. `event`: "contact" if the part
    touches at a given place, described by `contact`; otherwise the change, at the place `at`, of a
    hole in the sum of obstacles and turned part: birth, death, merge, split, touch."""

    scale: Fraction
    ends: bool
    event: str
    at: Place
    contact: PathBound | None


@dataclass(frozen=True)
class FreeScales(ScalesInRanges):
    """The scales at which a part fits, passes or is trapped, by translations alone: `ranges`,
    ascending; `bounds`, their ends; `proofs`, scales at, just below and just above each end and
    whether the static sum there has the property too."""

    bounds: tuple[FreeBound, ...]
    proofs: tuple[tuple[Fraction, bool], ...]


@overload
def valid_scales(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    path: Sequence[Sequence[Number]],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
    route: str = ...,
) -> ValidScales: ...
@overload
def valid_scales(
    part: Surface,
    obstacles: Surface,
    path: Sequence[Sequence[Number]],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
    route: str = ...,
) -> SpaceValidScales: ...
def valid_scales(
    part: _core.PolygonSet | Surface,
    obstacles: _core.PolygonSet | Surface,
    path: Sequence[Sequence[Number]],
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    route: str = "pieces",
) -> ValidScales | SpaceValidScales:
    """Find the scales at which the part, scaled about its origin and moved along the polyline with
    its origin on the path, never turned, does not meet the obstacles: with contact allowed their
    interiors, with contact forbidden the closed sets. Exact: ranges with open and closed ends, and
    single scales. Without bounds, all scales above 0. `route`: pieces, contacts or index, which
    share little.

    Part and obstacles are both sets in the plane, or both polyhedra of any shape with a path in
    space: then `route` is pieces or contacts, and either may be a point, a segment or a plane
    polygon. Both are validated first. Cost: docs/paths.md. Raises BadInput, Refusal."""
    rule, way = word_of("contact", contact, CONTACTS), word_of("route", route, PATH_ROUTES)
    window = window_of(from_scale, to_scale)
    if isinstance(part, Surface):
        return valid_scales_in_space(part, obstacles, path, rule, window, way)
    return _valid_scales_in_the_plane(part, obstacles, path, rule, window, way)


def _valid_scales_in_the_plane(
    part: _core.PolygonSet,
    obstacles: Any,
    path: Any,
    rule: str,
    window: tuple[str | None, str | None],
    way: str,
) -> ValidScales:
    expect_sets(part=part, obstacles=obstacles)
    places = [(x, y) for x, y in path_of(path, 2)]
    part.validate("part")
    obstacles.validate("obstacles")
    rows = _core.valid_scales(part, obstacles, places, rule, *window, way)
    return valid_scales_of(rows, _core.star_shaped(part))


def valid_scales_of(rows: Any, is_star: bool) -> ValidScales:
    ranges, bounds, statistics = rows
    return ValidScales(
        range_values(ranges), tuple(map(path_bound, bounds)), is_star, dict(statistics)
    )


def bad_polygons(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    path: Sequence[Sequence[Number]],
    to_scale: Number,
    contact: str = "allowed",
    from_scale: Number | None = None,
    most: int = 100_000,
) -> tuple[BadPolygon, ...]:
    """Return the diagram that explains the valid scales up to `to_scale`: the part collides at the
    place t of a segment, 0 < t < 1, and at a scale s inside the window iff some convex polygon
    contains (t, s) inside (with contact forbidden: inside or on a side). A scale inside the window
    is valid iff no polygon meets the line of this s so. Exact. Cost: docs/paths.md, and an exact
    polygon for each triple of two pieces and a segment that collides. Raises BadInput, Refusal;
    LimitExceeded for more than `most` polygons."""
    expect_sets(part=part, obstacles=obstacles)
    part.validate("part")
    obstacles.validate("obstacles")
    if isinstance(most, bool) or not isinstance(most, int):
        raise TypeError(f"most has to be an int, and is of type {type(most).__name__}")
    part_pieces, obstacle_pieces, polygons = _core.path_diagram(
        part,
        obstacles,
        [(x, y) for x, y in path_of(path, 2)],
        word_of("contact", contact, CONTACTS),
        window_of(from_scale, None)[0],
        number("to_scale", to_scale),
        max(most, 0),
    )
    own, other = (
        [tuple(map(_place, piece)) for piece in pieces] for pieces in (part_pieces, obstacle_pieces)
    )
    return tuple(
        BadPolygon(segment, own[part], other[obstacle], tuple(map(_place, corners)))
        for segment, part, obstacle, corners in polygons
    )


@overload
def largest_fit(
    part: _core.PolygonSet,
    container: _core.PolygonSet,
    at: Sequence[Number] | None = ...,
    between: Sequence[Sequence[Number]] | None = ...,
    contact: str = ...,
) -> FreeScales: ...
@overload
def largest_fit(
    part: Surface, container: Surface, at: Sequence[Number], between: None = ..., contact: str = ...
) -> SpaceFitScales: ...
@overload
def largest_fit(
    part: Surface, container: Surface, at: None = ..., between: None = ..., contact: str = ...
) -> SpaceFreeScales: ...
def largest_fit(
    part: _core.PolygonSet | Surface,
    container: _core.PolygonSet | Surface,
    at: Sequence[Number] | None = None,
    between: Sequence[Sequence[Number]] | None = None,
    contact: str = "allowed",
) -> FreeScales | SpaceFitScales | SpaceFreeScales:
    """Find the scales at which the container holds the part, scaled about its origin: with the
    origin at a place (`at`), at some place (neither `at` nor `between`), or at two places and all
    along some way between them (`between`), by translations. `largest` is the usual answer. Exact.
    Both sets are validated first. Polyhedra do not support `between`; anywhere, the container has
    to be convex, or some point strictly inside the part has to see all of it. Cost: docs/paths.md.
    Raises BadInput, Refusal."""
    rule = word_of("contact", contact, CONTACTS)
    if at is not None and between is not None:
        what = "a place and two places are different questions"
        raise Refusal(what, "largest_fit", "give `at` or `between`, or neither")
    if isinstance(part, Surface):
        if between is not None:
            what = "in space a fit is found at one place or anywhere"
            raise Refusal(what, "largest_fit", "give `at`, or neither")
        if at is None:
            return fit_anywhere_in_space(part, container, rule)
        return fit_at_in_space(part, container, at, rule)
    return _fit_in_the_plane(part, container, at, between, rule)


def _fit_in_the_plane(
    part: _core.PolygonSet, container: Any, at: Any, between: Any, rule: str
) -> FreeScales:
    expect_sets(part=part, container=container)
    part.validate("part")
    container.validate("container")
    if at is not None:
        return _free(_core.fit_at(part, container, _point("at", at), rule))
    if between is None:
        return _free(_core.fit_anywhere(part, container, rule))
    if isinstance(between, str) or not isinstance(between, Sequence) or len(between) != 2:
        raise TypeError(f"between has to be two places, and is of type {type(between).__name__}")
    start, end = (_point("between", place) for place in between)
    return _free(_core.fit_between(part, container, start, end, rule))


@overload
def trapped_scales(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    at: Sequence[Number],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
) -> FreeScales: ...
@overload
def trapped_scales(
    part: Surface,
    obstacles: Surface,
    at: Sequence[Number],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
) -> SpaceFreeScales: ...
def trapped_scales(
    part: _core.PolygonSet | Surface,
    obstacles: _core.PolygonSet | Surface,
    at: Sequence[Number],
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
) -> FreeScales | SpaceFreeScales:
    """Find the scales at which the part, scaled about its origin and put at a place, does not meet
    the obstacles, and no translation removes the part without a collision. A rotation may still
    free the part. Exact. Without bounds, all scales above 0. Both sets are validated first. A
    polyhedron has to be star-shaped about its origin, with the origin strictly below the planes of
    all its faces. Cost: docs/paths.md. Raises BadInput, Refusal."""
    rule = word_of("contact", contact, CONTACTS)
    window = window_of(from_scale, to_scale)
    if isinstance(part, Surface):
        return trapped_in_space(part, obstacles, at, rule, window)
    expect_sets(part=part, obstacles=obstacles)
    assert isinstance(obstacles, _core.PolygonSet)
    part.validate("part")
    obstacles.validate("obstacles")
    place = _point("at", at)
    return _free(_core.trapped_scales(part, obstacles, place, rule, *window))


def _point(name: str, value: Any) -> tuple[str, str]:
    x, y = coordinates(name, value, 2)
    return x, y


def _place(row: tuple[str, str]) -> Place:
    return Fraction(row[0]), Fraction(row[1])


def path_bound(row: Any) -> PathBound:
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
        range_values(ranges),
        tuple(
            FreeBound(
                Fraction(scale),
                ends,
                event,
                _place(at),
                None if contact is None else path_bound(contact),
            )
            for scale, ends, event, at, contact in bounds
        ),
        tuple((Fraction(scale), holds) for scale, holds in proofs),
    )
