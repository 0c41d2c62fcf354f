"""Scales for which a polyhedron passes along a path in space or fits at a place, as values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import surface_of
from minkref.motion.scale_ranges import ScalesInRanges, coordinates, path_of, range_values

Surface = _core.Polyhedron | _core.ConvexPolyhedron
SpacePlace = tuple[Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class SpaceFeature:
    """A touching feature: a "vertex" by number, an "edge" by two vertices, or a "face"'s inside by
    number."""

    kind: str
    numbers: tuple[int, ...]


@dataclass(frozen=True)
class SpacePathBound:
    """A bound like PathBound, in space."""

    scale: Fraction
    blocks: bool
    segment: int
    t: Fraction
    at: SpacePlace
    part: SpaceFeature
    obstacle: SpaceFeature
    touching: SpacePlace


@dataclass(frozen=True)
class SpaceValidScales(ScalesInRanges):
    """Scales like ValidScales, in space."""

    bounds: tuple[SpacePathBound, ...]
    star_shaped: bool
    statistics: dict[str, int]


@dataclass(frozen=True)
class SpaceFitScales(ScalesInRanges):
    """The scales at which a polyhedron fits at a place: `ranges`, ascending; `bounds`, their ends;
    `proofs`, scales at, just below and just above each end, with a fresh decision whether the
    polyhedron fits there."""

    bounds: tuple[SpacePathBound, ...]
    proofs: tuple[tuple[Fraction, bool], ...]


def valid_scales_in_space(
    part: Surface,
    obstacles: Any,
    path: Any,
    contact: str,
    window: tuple[str | None, str | None],
    route: str,
) -> SpaceValidScales:
    part, walls = surface_of("part", part), surface_of("obstacles", obstacles)
    places = [_texts(place) for place in path_of(path, 3)]
    part.validate_summand("part")
    walls.validate_summand("obstacles")
    rows = _core.valid_scales_in_space(part, walls, places, contact, *window, route)
    return SpaceValidScales(
        range_values(rows[0]),
        tuple(_bound(row) for row in rows[1]),
        _core.star_shaped_in_space(part),
        dict(rows[2]),
    )


def fit_at_in_space(
    part: Surface, container: Any, at: Sequence[Any], contact: str
) -> SpaceFitScales:
    first, second = surface_of("part", part), surface_of("container", container)
    place = _texts(coordinates("at", at, 3))
    first.validate_summand("part")
    second.validate_summand("container")
    (ranges, bounds, _), proofs = _core.fit_at_in_space(first, second, place, contact)
    return SpaceFitScales(
        range_values(ranges),
        tuple(_bound(row) for row in bounds),
        tuple((Fraction(scale), holds) for scale, holds in proofs),
    )


def _texts(place: Sequence[str]) -> tuple[str, str, str]:
    x, y, z = place
    return x, y, z


def _place(row: tuple[str, str, str]) -> SpacePlace:
    x, y, z = (Fraction(text) for text in row)
    return x, y, z


def _bound(row: Any) -> SpacePathBound:
    scale, blocks, segment, t, at, part, obstacle, touching = row
    return SpacePathBound(
        Fraction(scale),
        blocks,
        segment,
        Fraction(t),
        _place(at),
        SpaceFeature(part[0], tuple(part[1])),
        SpaceFeature(obstacle[0], tuple(obstacle[1])),
        _place(touching),
    )
