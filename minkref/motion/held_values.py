"""Scales at which obstacles hold a part, as values: in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, overload

from minkref import _core
from minkref.argument_types import expect_sets
from minkref.motion.path_values import PathBound, ValidScales, path_bound, valid_scales_of
from minkref.motion.scale_ranges import (
    CONTACTS,
    PATH_ROUTES,
    Number,
    ScaleRange,
    ScalesInRanges,
    path_of,
    range_values,
    window_of,
    word_of,
)
from minkref.motion.space_values import (
    SpacePathBound,
    SpaceValidScales,
    Surface,
    space_bound,
    space_operands,
    space_valid_scales_of,
)

Bound = TypeVar("Bound", PathBound, SpacePathBound)


@dataclass(frozen=True)
class HeldEnd(Generic[Bound]):
    """The contact at an end of held scales. `at_place`: the part touches at its place, so that it
    fits on one side of the scale only; otherwise it touches on the way."""

    at_place: bool
    contact: Bound


@dataclass(frozen=True)
class HeldRange(Generic[Bound]):
    """Held scales from one to another, and the contacts at both ends: None at an end of the window.
    `stop`: at one of these scales, the first place of the way where the part collides (with contact
    allowed: the limit of such places), and the contact there."""

    scales: ScaleRange
    begin: HeldEnd[Bound] | None
    end: HeldEnd[Bound] | None
    stop: Bound


@dataclass(frozen=True)
class HeldScales(ScalesInRanges):
    """The scales at which a part fits at its place and the way out is blocked: `ranges`, ascending,
    with their contacts in `held`. `fits`: the scales at the way's first vertex; `way`: scales for
    the whole way."""

    held: tuple[HeldRange[PathBound], ...]
    fits: ValidScales
    way: ValidScales


@dataclass(frozen=True)
class SpaceHeldScales(ScalesInRanges):
    """Scales like HeldScales, in space."""

    held: tuple[HeldRange[SpacePathBound], ...]
    fits: SpaceValidScales
    way: SpaceValidScales


@overload
def held_scales(
    part: _core.PolygonSet,
    obstacles: _core.PolygonSet,
    way: Sequence[Sequence[Number]],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
    route: str = ...,
) -> HeldScales: ...
@overload
def held_scales(
    part: Surface,
    obstacles: Surface,
    way: Sequence[Sequence[Number]],
    contact: str = ...,
    from_scale: Number | None = ...,
    to_scale: Number | None = ...,
    route: str = ...,
) -> SpaceHeldScales: ...
def held_scales(
    part: _core.PolygonSet | Surface,
    obstacles: _core.PolygonSet | Surface,
    way: Sequence[Sequence[Number]],
    contact: str = "allowed",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    route: str = "pieces",
) -> HeldScales | SpaceHeldScales:
    """Find the scales at which the part does not meet the obstacles at the way's first vertex, and
    meets them somewhere on the way (Behar & Lien 2012, Sec. 8.1, "part removal"). Exact: ranges
    with open and closed ends, and single scales. A way is one of many: a part that is trapped is
    held on each way out, but a held part may have another way out (`trapped_scales`).

    Operands, `contact`, window and `route` as for `valid_scales`; cost: twice its cost. Raises
    BadInput, Refusal."""
    rule, by = word_of("contact", contact, CONTACTS), word_of("route", route, PATH_ROUTES)
    window = window_of(from_scale, to_scale)
    if isinstance(part, Surface):
        return _held_in_space(part, obstacles, way, rule, window, by)
    expect_sets(part=part, obstacles=obstacles)
    assert isinstance(obstacles, _core.PolygonSet)
    places = [(x, y) for x, y in path_of(way, 2, "way")]
    part.validate("part")
    obstacles.validate("obstacles")
    fits, along, held = _core.held_scales(part, obstacles, places, rule, *window, by)
    is_star = _core.star_shaped(part)
    return HeldScales(
        range_values([row[0] for row in held]),
        tuple(_held(row, path_bound) for row in held),
        valid_scales_of(fits, is_star),
        valid_scales_of(along, is_star),
    )


def _held_in_space(
    part: Surface,
    obstacles: Any,
    way: Any,
    rule: str,
    window: tuple[str | None, str | None],
    by: str,
) -> SpaceHeldScales:
    first, second, places = space_operands(part, obstacles, way, "way")
    fits, along, held = _core.held_scales_in_space(first, second, places, rule, *window, by)
    is_star = _core.star_shaped_in_space(first)
    return SpaceHeldScales(
        range_values([row[0] for row in held]),
        tuple(_held(row, space_bound) for row in held),
        space_valid_scales_of(fits, is_star),
        space_valid_scales_of(along, is_star),
    )


def _held(row: Any, bound: Callable[[Any], Bound]) -> HeldRange[Bound]:
    scales, begin, end, stop = row

    def end_of(one: Any) -> HeldEnd[Bound] | None:
        return None if one is None else HeldEnd(one[0], bound(one[1]))

    return HeldRange(range_values([scales])[0], end_of(begin), end_of(end), bound(stop))
