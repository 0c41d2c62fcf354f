"""Radii of discs on paths, in containers and among obstacles, and scales of parts that keep a
distance, before a judge of all pairs (oracle/distances)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
from minkref.fuzz.judges.motion.disc_draws import DiscCase, rings_of
from minkref.fuzz.motion.path_cases import PathCase, Place, path_case, texts
from minkref.oracle.distances import (
    Rooms,
    path_distance,
    squared_distance_inside,
    squared_distance_on_path,
)

CELLS = 40
SLACK = 1e-9  # of the grid's doubles
CLEARANCES = tuple(map(Fraction, ("1/7", "1/2", "1", "5/3")))
LADDER = tuple(map(Fraction, ("1/9", "1/3", "3/5", "1", "5/3", "4")))
CONTACTS = ("allowed", "forbidden")


def disc_faults(case: DiscCase, tally: Counter[str]) -> Iterator[str]:
    """Compares a case's path, places, ways and traps."""
    yield from _path_faults(case, tally)
    for inside in (False, True):
        rooms = Rooms(case.rings, inside, CELLS)
        for place in case.inside if inside else case.outside:
            if inside:
                yield from _place_faults(case, rooms, place, tally)
            else:
                yield from _trap_faults(case, rooms, place, tally)
        if inside:
            yield from _way_faults(case, rooms, tally)


def _path_faults(case: DiscCase, tally: Counter[str]) -> Iterator[str]:
    square = path_distance(case.rings, case.path)
    found = minkref.valid_radii(case.set, texts(case.path))
    tally["paths"] += 1
    tally["paths that meet the set"] += square == 0
    if _square(found) != square:
        yield f"{case.name}: a path's squared radius is {_square(found)}, and not {square}"
    contact = found.contact
    if contact is not None:
        (x, y), (p, q) = contact.at, contact.touching
        if (x - p) ** 2 + (y - q) ** 2 != square or path_distance(case.rings, [(p, q)]) != 0:
            yield f"{case.name}: the contact of a path does not touch"
        if not _is_on_path(case.path, contact.segment, contact.t, contact.at):
            yield f"{case.name}: the contact of a path is not on it"


def _place_faults(case: DiscCase, rooms: Rooms, place: Place, tally: Counter[str]) -> Iterator[str]:
    found = minkref.largest_disc(case.set, at=texts([place])[0])
    tally["places"] += 1
    if _square(found) != rooms.squared_at(place):
        yield f"{case.name}: the squared radius at {place} is {_square(found)}"


def _way_faults(case: DiscCase, rooms: Rooms, tally: Counter[str]) -> Iterator[str]:
    start, end = case.inside
    found = minkref.largest_disc(case.set, between=texts([start, end]))
    tally["ways"] += 1
    tally[f"ways, {found.cause}"] += 1
    yield from _bottleneck_faults(case, rooms, (start, end), _square(found), found)


def _trap_faults(case: DiscCase, rooms: Rooms, place: Place, tally: Counter[str]) -> Iterator[str]:
    found = minkref.trapped_radii(case.set, texts([place])[0])
    tally["traps"] += 1
    tally[f"traps, {found.cause}"] += 1
    at_place = rooms.squared_at(place)
    if found.is_empty:
        squared = at_place
    else:
        squared = Fraction(0)
        if found.low is not None and found.low.squared_distance is not None:
            squared = found.low.squared_distance
        if _square(found) != at_place:
            yield f"{case.name}: the trap at {place} ends at {_square(found)}, and not {at_place}"
    yield from _bottleneck_faults(case, rooms, (place, None), squared, found)


def _bottleneck_faults(
    case: DiscCase, rooms: Rooms, places: tuple[Place, Place | None], squared: Fraction, found: Any
) -> Iterator[str]:
    """A squared radius has to be a candidate, and within a step of the grid's."""
    start, end = places
    own = {rooms.squared_at(place) for place in places if place is not None}
    grid = rooms.bottleneck(start, end)
    told = f"{case.name}: from {start} to {end or 'infinity'}"
    if abs(float(squared) ** 0.5 - grid) > rooms.step + SLACK:
        yield f"{told} the radius is {float(squared) ** 0.5}, and {grid} on a grid"
    if squared > min(own):
        yield f"{told} the radius is larger than at a place"
    if squared not in own and squared != 0 and squared not in rooms.candidates():
        yield f"{told} the squared radius {squared} is none of two features"
    for event in found.events:
        if event.squared_radius != squared:
            yield f"{told} a neck has another radius"


def clearance_faults(case: PathCase, tally: Counter[str], index: int) -> Iterator[str]:
    """Compares the scales at which a part keeps a distance, at and beside their ends."""
    clearance = CLEARANCES[index % len(CLEARANCES)]
    part, obstacles = rings_of(case.part), rings_of(case.obstacles)
    for contact in CONTACTS:
        found = minkref.clear_scales(
            case.part, case.obstacles, texts(case.path), str(clearance), contact
        )
        tally["clearances"] += 1
        tally["ends"] += len(found.bounds)
        tally["ends with a root"] += sum(each.scale.rational is None for each in found.bounds)
        for scale in _scales(found):
            square = squared_distance_on_path(part, obstacles, case.path, scale)
            tally["scales"] += 1
            if found.holds(scale) != _is_clear(square, clearance, contact):
                yield f"{case.name}, {contact}, clearance {clearance}: wrong at {scale}"


def fit_faults(case: DiscCase, tally: Counter[str], index: int) -> Iterator[str]:
    """Compares the scales at which a part fits into a container and keeps a distance."""
    clearance = CLEARANCES[index % len(CLEARANCES)] / 2
    drawn = path_case(index, 1).part
    part, place = rings_of(drawn), case.inside[0]
    for contact in CONTACTS:
        found = minkref.clear_fit(drawn, case.set, texts([place])[0], str(clearance), contact)
        tally["fits"] += 1
        tally["ends of fits"] += len(found.bounds)
        for scale in _scales(found):
            square = squared_distance_inside(part, case.rings, place, scale)
            tally["scales of fits"] += 1
            if found.holds(scale) != _is_clear(square, clearance, contact):
                yield f"{case.name}, fit, {contact}, clearance {clearance}: wrong at {scale}"


def _is_clear(square: Fraction, clearance: Fraction, contact: str) -> bool:
    return square > clearance**2 or (square == clearance**2 and contact == "allowed")


def _scales(found: Any) -> list[Fraction]:
    """Doubles beside each end, a scale between any two ends, and some that no answer chose, where
    a lost range would show."""
    ends = [tuple(map(Fraction, each.scale.bounds)) for each in found.bounds]
    ends = sorted({end for end in ends if end[0] > 0})
    if not ends:
        return list(LADDER)
    middles = [(a[1] + b[0]) / 2 for a, b in pairwise(ends)]
    return sorted(
        {ends[0][0] / 2, *(c for end in ends for c in end), *middles, 2 * ends[-1][1], *LADDER}
    )


def _square(found: Any) -> Fraction:
    """The squared greatest radius; 0 without one."""
    if found.is_empty:
        return Fraction(0)
    square = found.high.squared_distance
    return Fraction(-1) if square is None else square


def _is_on_path(path: Sequence[Place], segment: int, t: Fraction, at: Place) -> bool:
    a, b = path[segment], path[min(segment + 1, len(path) - 1)]
    place = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
    return 0 <= t <= 1 and place == at
