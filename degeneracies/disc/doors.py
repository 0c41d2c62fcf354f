"""Doors of equal width: holes born at one radius, and edges on one line."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref import _core
from minkref.degeneracies.disc.draft import DiscDraft, DiscFacts, DiscFamily, Spot
from minkref.degeneracies.disc.placing import placed
from minkref.degeneracies.plane.shapes import framed, number
from minkref.fuzz.geometry.plane import Point, Ring, Shape, box, cross, dot, edges, minus


def _row_of_rooms(dice: Random, size: int, width: Fraction) -> tuple[Shape, list[Spot]]:
    """A hole with rooms in a row and doors of equal width; a room is wider and higher than a door.
    The places stand where doors begin."""
    low: list[Point] = []
    high: list[Point] = []
    places: list[Spot] = []
    x = Fraction(0)
    count = min(max(size // 6, 3), 8)
    for k in range(count):
        wide = width * 2 + number(dice, 1, 4)
        down, up = (width + number(dice, 0, 4) for _ in range(2))
        low += [(x, -down), (x + wide, -down)]
        high += [(x, up), (x + wide, up)]
        x += wide
        if k < count - 1:
            deep = number(dice, 1, 2)
            low += [(x, -width / 2), (x + deep, -width / 2)]
            high += [(x, width / 2), (x + deep, width / 2)]
            places.append((x, Fraction(0)))
            x += deep
    return [framed([[*low, *reversed(high)]])], places


def _blocks(dice: Random, size: int, width: Fraction) -> tuple[Shape, list[Spot]]:
    """Blocks in rows and columns, with streets of equal width: each crossing becomes a hole. The
    places lie where two blocks begin to face each other."""
    columns, rows = dice.choice(((3, 2), (2, 3), (3, 3))) if size > 10 else (3, 2)
    wide = [number(dice, 1, 4) for _ in range(columns)]
    high = [number(dice, 1, 4) for _ in range(rows)]
    P: Shape = []
    places: list[Spot] = []
    x = Fraction(0)
    for column in range(columns):
        y = Fraction(0)
        for row in range(rows):
            P.append([box(x, y, wide[column], high[row])])
            if row + 1 < rows:
                places.append((x, y + high[row] + width / 2))
            if column + 1 < columns:
                places.append((x + wide[column] + width / 2, y))
            y += high[row] + width
        x += wide[column] + width
    return P, places


def _births(dice: Random, size: int) -> DiscDraft:
    width = number(dice, 1, 3)
    P, places = dice.choice((_row_of_rooms, _blocks))(dice, size, width)
    return placed(dice, DiscDraft(P, (width / 2) ** 2, tuple(places)))


def _slots(dice: Random, size: int) -> DiscDraft:
    """A block with slots of equal width and depth: one line holds their floors, another the tops
    between. The place lies in the leftmost slot, as far from the floor as from the walls."""
    width = number(dice, 1, 3)
    deep, under = width + number(dice, 0, 3), number(dice, 1, 3)
    count = min(max(size // 4, 2), 8)
    ring: Ring = []
    x = Fraction(0)
    for k in range(count + 1):
        wide = number(dice, 1, 3)
        ring += [(x, deep), (x + wide, deep)]
        x += wide
        if k < count:
            ring += [(x, 0), (x + width, 0)]
            x += width
    place = (ring[2][0] + width / 2, width / 2)
    outline: Ring = [(0, -under), (x, -under), *reversed(ring)]
    return placed(dice, DiscDraft([[outline]], (width / 2) ** 2, (place,)))


def born_at(facts: DiscFacts) -> list[tuple[float, float]]:
    """Returns a place for each hole born at the radius."""
    index = _core.disc_index(facts.P)
    number, is_event = index.place(str(facts.squared_radius))
    return [
        index.rows(event, 1)[0][4]
        for event, radius, born, _, _ in index.changes()
        if is_event and radius == number
        for _ in born
    ]


def _has_births(facts: DiscFacts) -> bool:
    return facts.is_at_places and len(born_at(facts)) >= 2


def _is_on_further_edge(facts: DiscFacts) -> bool:
    """Whether a nearest point lies on an edge that is not the first on its line."""
    every = [(_spot(a), _spot(b)) for a, b in edges(facts.shape)]
    for point in facts.near[0].points:
        for k, (a, b) in enumerate(every):
            along, way = minus(b, a), minus(point, a)
            if cross(along, way) != 0 or not 0 < dot(along, way) < dot(along, along):
                continue
            if any(_are_on_one_line((a, b), other) for other in every[:k]):
                return facts.is_at_places
    return False


def _spot(p: Point) -> Spot:
    return Fraction(p[0]), Fraction(p[1])


def _are_on_one_line(e: tuple[Spot, Spot], f: tuple[Spot, Spot]) -> bool:
    along, other, way = minus(e[1], e[0]), minus(f[1], f[0]), minus(f[0], e[0])
    return cross(along, other) == 0 == cross(along, way) and dot(along, other) > 0


FAMILIES = (
    DiscFamily("disc-doors", "several holes are born at one radius", _births, _has_births),
    DiscFamily(
        "disc-edges-on-one-line",
        "what is nearest is not the first edge on its line",
        _slots,
        _is_on_further_edge,
    ),
)
