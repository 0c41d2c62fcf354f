"""Brackets of the scales at which a part keeps a distance, before a judge of all pairs on a grid
(oracle/distances)."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

import minkref
from minkref.api import PolygonSet, ScaleBracket
from minkref.fuzz.judges.motion.disc_draws import disc_case, rings_of, rooms
from minkref.fuzz.motion.path_cases import Place, texts
from minkref.oracle.distances import PartRooms, is_inside

CELLS = 40
CLEARANCES = tuple(map(Fraction, ("1/7", "1/4", "1/2", "1")))
CONTACTS = ("allowed", "forbidden")
DIRECTIONS = ((2, 0), (2, 1), (1, 2), (0, 1), (-1, 2), (-1, 0), (-2, -1), (0, -2), (1, -1))


@dataclass(frozen=True)
class BracketCase:
    """A part that is star-shaped about its origin, and rooms with doors, the block around them, or
    a set of another kind."""

    name: str
    part: PolygonSet
    rooms: PolygonSet
    places: tuple[Place, Place]
    inside: bool  # the rooms are the container
    clearance: Fraction
    contact: str


def bracket_case(seed: int, index: int) -> BracketCase:
    """The same one for the same numbers."""
    name = f"brackets {seed}:{index}"
    dice = random.Random(name)
    if index % 3 == 2:
        drawn = disc_case(seed, index)
        container, inside = drawn.set, dice.random() < 0.7
        places = drawn.inside if inside else drawn.outside
    else:
        container, middles = rooms(dice)
        places = dice.choice(middles), dice.choice(middles)
        inside = is_inside(rings_of(container), places[0])
    clearance, contact = dice.choice(CLEARANCES), dice.choice(CONTACTS)
    return BracketCase(name, _star(dice), container, places, inside, clearance, contact)


def bracket_faults(case: BracketCase, tally: Counter[str]) -> Iterator[str]:
    """Compares a case's brackets with a grid at the scales that they end with."""
    tally["brackets"] += 1
    ways = texts(case.places)
    clearance, contact = case.clearance, case.contact
    if not case.inside:
        trap = minkref.clear_trap(case.part, case.rooms, ways[0], clearance, contact)
        tally["traps"] += not trap.is_empty
        if trap.escapes is not None:
            yield from _faults(case, trap.escapes, (case.places[0], None), tally)
        return
    found = minkref.clear_fits(case.part, case.rooms, clearance, contact=contact)
    yield from _faults(case, found, None, tally)
    found = minkref.clear_fits(case.part, case.rooms, clearance, ways, contact)
    yield from _faults(case, found, case.places, tally)


def _faults(
    case: BracketCase,
    found: ScaleBracket,
    places: tuple[Place, Place | None] | None,
    tally: Counter[str],
) -> Iterator[str]:
    """At the end of the scales the greatest distance is the clearance, up to a step of the grid;
    without scales it is no more for a very small part. A given place keeps the clearance itself."""
    told = f"{case.name}, {places or 'anywhere'}: {found}"
    tally["exact ends"] += found.is_exact and not found.is_empty
    scale = found.holds_to or Fraction(1, 10**6)
    grid = PartRooms(rings_of(case.rooms), case.inside, CELLS, rings_of(case.part), scale)
    near = grid.most() if places is None else grid.bottleneck(*places)
    far = float(case.clearance)
    tally["grids"] += 1
    if found.fails_from is not None and near > far + grid.step:
        yield f"{told}: {near} on a grid, and {far} asked"
    if found.holds_to > 0 and near < far - grid.step:
        yield f"{told}: only {near} on a grid, and {far} asked"
    if found.holds_to > 0:
        for place in (each for each in places or () if each is not None):
            if grid.squared_at(place) < case.clearance**2:
                yield f"{told}: the part at {place} does not keep {case.clearance}"


def _star(dice: random.Random) -> PolygonSet:
    """Draw a ring about the origin, which lies inside or, seldom, on a side."""
    while True:
        chosen = sorted(dice.sample(range(len(DIRECTIONS)), dice.randint(3, 6)))
        corners = []
        for k in chosen:
            far = Fraction(dice.randint(1, 4), 2)
            corners.append((str(far * DIRECTIONS[k][0]), str(far * DIRECTIONS[k][1])))
        try:
            part = PolygonSet([[corners]])
            part.validate("a drawn part")
        except minkref.BadInput:
            continue
        if minkref.valid_scales(part, part, [(50, 50)]).star_shaped:
            return part
