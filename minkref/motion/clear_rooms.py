"""The greatest distance that a part keeps at one scale: a disc among the sum of the obstacles and
the turned part (docs/paths.md, "Clearance")."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.disc.eroded import eroded_by_disc
from minkref.errors import Refusal
from minkref.motion.disc_radii import limit_between
from minkref.motion.scale_bracket import Room

Exact = tuple[Fraction, Fraction]
Places = tuple[tuple[str, str], tuple[str, str]]


@dataclass(frozen=True)
class Container:
    """Decides how far a part in a container stays from the container's boundary: at some place, or
    all along a way between two places. Each question takes a sum and its diagram."""

    part: _core.PolygonSet
    container: _core.PolygonSet
    name: str
    places: Places | None
    clearance: Fraction
    threads: int

    def room(self, scale: Fraction) -> Room:
        """The greatest distance at a scale; at 0 of the part's origin alone."""
        inner = self.inner(scale)
        if inner.is_empty:
            return Room(-1, 0.0, "meets")
        square = str(self.clearance**2)
        outside: Any = eroded_by_disc(inner, self.name).set
        if self.places is None:
            row, events = _core.disc_anywhere(outside, "0", square, self.threads)
            return _room(row, "room", events)
        found = _core.disc_passage(outside, *self.places, "0", square, self.threads)
        cause, limit = limit_between(found)
        return Room(-1, 0.0, cause) if limit is None else _room(limit[0], cause, found[4])

    def inner(self, scale: Fraction) -> _core.PolygonSet:
        """The places of the part inside the container, without exact fits."""
        if scale == 0:
            return self.container
        return _core.erosion(self.container, self.part.scaled(str(scale)), "1").region

    def refuse_without_area(self) -> None:
        eroded_by_disc(self.container, self.name)

    def keeps(self, scale: Fraction, place: Exact, allowed: bool) -> bool:
        """Tell whether the part at a scale and a place keeps the clearance. Exact."""
        inner = self.inner(scale)
        if inner.is_empty or place not in inner:
            return False
        x, y = map(str, place)
        outside = eroded_by_disc(inner, self.name).set
        found: Any = _core.disc_on_path(outside, [(x, y)], "0", str(self.clearance**2))
        order = found[0][3]
        return bool(order > 0 or (allowed and order == 0))

    @property
    def most(self) -> Fraction:
        """The greatest scale at which the part's box, grown by the clearance, fits into the
        container's box; 0 or less without one. The part keeps no more than the clearance there."""
        own, around = _extent(self.part), _extent(self.container)
        return min(
            (room - 2 * self.clearance) / size
            for room, size in zip(around, own, strict=True)
            if size > 0
        )


@dataclass(frozen=True)
class WayOut:
    """Decides how far a part stays from obstacles on the best way from a place to infinity."""

    part: _core.PolygonSet
    obstacles: _core.PolygonSet
    place: tuple[str, str]
    clearance: Fraction
    threads: int

    def room(self, scale: Fraction) -> Room:
        """The greatest distance at a scale; at 0 of the part's origin alone."""
        found: Any = _core.disc_passage(
            self.grown(scale), self.place, None, "0", str(self.clearance**2), self.threads
        )
        limit, first, _, radius, events = found
        if first is None:
            return Room(-1, 0.0, "meets")
        if limit == "apart":
            return Room(-1, 0.0, limit)
        return _room(radius, "neck", events) if limit == "neck" else _room(first[0], "contact", [])

    def grown(self, scale: Fraction) -> _core.PolygonSet:
        """The places at which the part meets the obstacles."""
        if scale == 0:
            return self.obstacles
        return _core.minkowski_sum(_core.negated(self.part), self.obstacles, str(scale)).region


def refuse_without_extent(part: _core.PolygonSet, name: str) -> None:
    if part.is_empty or part.is_point:
        what, mend = "the part has no extent, so no scale is the largest", "name a set of polygons"
        raise Refusal(what, name, mend, "point-part")


def refuse_other_stars(part: _core.PolygonSet, name: str, about_origin: bool) -> None:
    """Refuse a part whose smaller copies may need more room: one without a point that sees all of
    it, or whose origin does not, where the question is about given places."""
    if about_origin and not _core.star_shaped(part):
        found = _core.star_centre(part)
        what = "the part is not star-shaped about its origin, so that smaller copies may not pass"
        mend = "ask for one scale with --scale S"
        if found is not None:
            x, y = found[0]
            mend += f", or move the part's origin to ({x}, {y}), which sees all of it"
        raise Refusal(what, name, mend, "not-star-shaped")
    if not about_origin and _core.star_centre(part) is None:
        what = "no point of the part sees all of it, so that smaller copies may not fit"
        mend = "ask for one scale with --scale S, or for all scales at a place with --at X,Y"
        raise Refusal(what, name, mend, "not-star-shaped")


def shrinks_strictly(part: _core.PolygonSet, about_origin: bool) -> bool:
    """Tell whether a smaller copy keeps more distance than a larger copy."""
    if about_origin:
        return _core.is_inner_star_centre(part, ("0", "0"))
    found = _core.star_centre(part)
    return found is not None and found[1]


def _room(row: Any, cause: str, events: Any) -> Room:
    low, high = row[2]
    place = next((tuple(event[4]) for event in events), None)
    return Room(row[3], (low + high) / 2, cause, place)


def _extent(of: _core.PolygonSet) -> Exact:
    points = [point for polygon in of.rings() for ring in polygon for point in ring]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(xs) - min(xs), max(ys) - min(ys)
