"""Scales for which a polyhedron passes along a path, fits or is trapped, as values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import coordinates, surface_of
from minkref.motion.scale_ranges import ScalesInRanges, path_of, range_values

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


@dataclass(frozen=True)
class FitSupport:
    """A contact that keeps the part from growing: a vertex of the part on the plane of a face of
    the container, and its weight. The weighted normals of the faces, each twice the face's area
    vector, sum up to zero."""

    vertex: int
    face: int
    weight: Fraction


@dataclass(frozen=True)
class SpaceFreeBound:
    """An end (`ends`) or a beginning of scales for a fit or a trap in space. `event`: "contact" if
    the part touches and fits no more, "death" if the last free places vanish, "split" if a way
    closes. `at`: a place of the part's origin; for a contact the point that is touched."""

    scale: Fraction
    ends: bool
    event: str
    at: SpacePlace
    contact: SpacePathBound | None


@dataclass(frozen=True)
class SpaceFreeScales(ScalesInRanges):
    """The scales at which a polyhedron fits somewhere or is trapped, by translations alone:
    `ranges`, ascending; `bounds`, their ends; `place`, where the part fits at the greatest scale
    (None for a trap); `supports`, the proof for a convex container; `proofs` as SpaceFitScales."""

    bounds: tuple[SpaceFreeBound, ...]
    place: SpacePlace | None
    supports: tuple[FitSupport, ...]
    proofs: tuple[tuple[Fraction, bool], ...]


def valid_scales_in_space(
    part: Surface,
    obstacles: Any,
    path: Any,
    contact: str,
    window: tuple[str | None, str | None],
    route: str,
) -> SpaceValidScales:
    part, walls, places = space_operands(part, obstacles, path)
    rows = _core.valid_scales_in_space(part, walls, places, contact, *window, route)
    return space_valid_scales_of(rows, _core.star_shaped_in_space(part))


def space_operands(
    part: Any, obstacles: Any, path: Any, name: str = "path"
) -> tuple[_core.Polyhedron, _core.Polyhedron, list[tuple[str, str, str]]]:
    """Validated operands, and the vertices of a path, named in errors, as texts."""
    first, second = surface_of("part", part), surface_of("obstacles", obstacles)
    places = [_texts(place) for place in path_of(path, 3, name)]
    first.validate_summand("part")
    second.validate_summand("obstacles")
    return first, second, places


def space_valid_scales_of(rows: Any, is_star: bool) -> SpaceValidScales:
    ranges, bounds, statistics = rows
    return SpaceValidScales(
        range_values(ranges), tuple(map(space_bound, bounds)), is_star, dict(statistics)
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
        tuple(space_bound(row) for row in bounds),
        tuple((Fraction(scale), holds) for scale, holds in proofs),
    )


def fit_anywhere_in_space(part: Surface, container: Any, contact: str) -> SpaceFreeScales:
    first, second = surface_of("part", part), surface_of("container", container)
    first.validate_summand("part")
    second.validate_summand("container")
    found = _free(_core.fit_anywhere_in_space(first, second, contact))
    contact_there = found.bounds[0].contact
    return replace(found, place=None if contact_there is None else contact_there.at)


def trapped_in_space(
    part: Surface, obstacles: Any, at: Any, contact: str, window: tuple[str | None, str | None]
) -> SpaceFreeScales:
    first, second, [place] = space_operands(part, obstacles, [coordinates("at", at, 3)])
    return _free(_core.trapped_scales_in_space(first, second, place, contact, *window))


def _free(rows: Any) -> SpaceFreeScales:
    ranges, bounds, supports, proofs, _ = rows
    return SpaceFreeScales(
        range_values(ranges),
        tuple(map(_free_bound, bounds)),
        None,
        tuple(FitSupport(vertex, face, Fraction(weight)) for vertex, face, weight in supports),
        tuple((Fraction(scale), holds) for scale, holds in proofs),
    )


def _free_bound(row: Any) -> SpaceFreeBound:
    scale, ends, event, at, contact = row
    told = None if contact is None else space_bound(contact)
    where = _place(at) if told is None or event != "contact" else told.touching
    return SpaceFreeBound(Fraction(scale), ends, event, where, told)


def _texts(place: Sequence[str]) -> tuple[str, str, str]:
    x, y, z = place
    return x, y, z


def _place(row: tuple[str, str, str]) -> SpacePlace:
    x, y, z = (Fraction(text) for text in row)
    return x, y, z


def space_bound(row: Any) -> SpacePathBound:
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
