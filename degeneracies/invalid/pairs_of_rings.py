"""Rings that are valid alone and invalid beside another. The damage stays in a small place of a
valid operand, near one edge."""

from __future__ import annotations

from random import Random

from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import Spot, region, spot
from minkref.degeneracies.invalid.sheet import FORMS, Sheet, place_of, sheet
from minkref.degeneracies.invalid.writing import refused
from minkref.degeneracies.plane.shapes import turned
from minkref.fuzz.geometry.plane import Ring, Shape, box, extent

FAMILIES = Families()

Places = tuple[tuple[int, int], ...]

# Rings in a spot's coordinates: the edge runs along y = 0, and the set lies above.
LYING_ON: Places = ((-1, 0), (1, 0), (0, 1))
LYING_BELOW: Places = ((0, -1), (1, 0), (-1, 0))
ACROSS: tuple[Places, ...] = (
    ((0, -1), (1, 1), (-1, 1)),
    ((0, 0), (2, -1), (2, 1), (-1, 1)),  # through the edge at one of the ring's vertices
    ((0, 0), (1, -1), (2, 0), (1, 1)),  # at two vertices
    ((-2, -1), (2, -1), (2, 2), (1, 2), (1, 0), (-1, 0), (-1, 2), (-2, 2)),
)
ABOVE: tuple[Places, ...] = (((-1, 1), (1, 1), (0, 2)), ((0, 0), (1, 1), (-1, 1)))
BELOW: tuple[Places, ...] = (((-1, -1), (0, -2), (1, -1)), ((0, 0), (-1, -1), (1, -1)))
FIRST_HOLE: Places = ((-2, 1), (2, 1), (2, 3), (-2, 3))
WITHIN_IT: tuple[Places, ...] = (((-1, 2), (1, 2), (0, 3)), ((-2, 1), (1, 2), (0, 2)))


def added(dice: Random, shape: Shape, ring: Ring, at: Spot, hole: bool) -> tuple[int, int]:
    """Adds the ring as a hole to the spot's polygon, or as a polygon."""
    if hole:
        shape[at.polygon].append(turned(ring))
        return at.polygon, len(shape[at.polygon]) - 1
    shape.append([turned(ring)[::-1]])
    return len(shape) - 1, 0


def named(page: Sheet, first: tuple[int, int], second: tuple[int, int]) -> list[str]:
    return [f"ring {page.number(*first)}", f"ring {page.number(*second)}"]


def edge_of(page: Sheet, at: Spot) -> tuple[str, ...]:
    """The ends of the spot's edge, as the file writes them."""
    ring = page.shape[at.polygon][at.ring]
    ends = (at.edge, (at.edge + 1) % len(ring))
    return place_of(*(ring[-k - 1 if page.backwards else k] for k in ends))


@FAMILIES.add("two rings along one stretch, or a hole in a hole")
def overlapping_rings(dice: Random) -> Invalid:
    """A stretch in common, the same ring twice, or a hole in a hole."""
    shape = region(dice)
    at = spot(dice, shape)
    kind = dice.choice(("stretch", "stretch", "twice", "within"))
    if kind == "within":
        first = added(dice, shape, at.points(*FIRST_HOLE), at, True)
        second = added(dice, shape, at.points(*dice.choice(WITHIN_IT)), at, True)
        page = sheet(dice, shape)
        place = named(page, first, second)
        if not page.backwards:
            place += place_of(*(page.shape[p][r][0] for p, r in (first, second)))
        return refused(dice, page, "overlapping-rings", *place)
    if kind == "twice":
        hole = at.ring > 0 or dice.random() < 0.3
        second = added(dice, shape, list(shape[at.polygon][at.ring]), at, hole)
    else:
        hole = dice.random() < 0.5
        second = added(dice, shape, at.points(*(LYING_ON if hole else LYING_BELOW)), at, hole)
    page = sheet(dice, shape)
    place = named(page, (at.polygon, at.ring), second)
    if kind == "stretch":
        place += edge_of(page, at)
        if not page.backwards:
            page.mark(at.polygon, at.ring, at.edge)
    return refused(dice, page, "overlapping-rings", *place)


@FAMILIES.add("two rings that cross")
def crossing_rings(dice: Random) -> Invalid:
    """A hole or another polygon across an edge."""
    shape = region(dice)
    at = spot(dice, shape)
    hole = dice.random() < 0.6
    second = added(dice, shape, at.points(*dice.choice(ACROSS[: 4 if hole else 3])), at, hole)
    # If a .poly has several outer rings, a hole across an outer ring's edge lies in none.
    forms = [form for form in FORMS if not (form == "poly" and len(shape) > 1)]
    page = sheet(dice, shape, forms)
    place = named(page, (at.polygon, at.ring), second)
    if not page.backwards:
        page.mark(at.polygon, at.ring, at.edge)
    return refused(dice, page, "crossing-rings", *place, *edge_of(page, at))


@FAMILIES.add("a hole that does not lie in its outer ring")
def hole_outside(dice: Random) -> Invalid:
    """A hole beside its outer ring, or around it."""
    shape = region(dice)
    at = spot(dice, shape, outer=True)
    around = len(shape) == 1 and dice.random() < 0.2
    ring = at.points(*dice.choice(BELOW))
    if around:
        shape[0] = shape[0][:1]
        x, y, width, height = extent(shape[0][0])
        ring = box(x - 1, y - 2, width + 3, height + 5)
    p, r = added(dice, shape, ring, at, True)
    page = sheet(dice, shape)
    place = [f"ring {page.number(p, r)}"]
    if not page.backwards:
        page.mark(p, r, 0)
        place += ["vertex 0", *place_of(page.shape[p][r][0])]
    return refused(dice, page, "hole-outside", *place)


@FAMILIES.add("a polygon in the material of another")
def overlapping_polygons(dice: Random) -> Invalid:
    """A polygon inside the material of another, or all polygons inside a new one without holes."""
    shape = region(dice)
    at = spot(dice, shape)
    if dice.random() < 0.3:
        x, y, width, height = extent([p for rings in shape for p in rings[0]])
        shape.append([box(x - dice.randint(1, 3), y - 1, width + 5, height + dice.randint(2, 4))])
        inner, outer = (0, 0), (len(shape) - 1, 0)
    else:
        outer = (at.polygon, 0)
        inner = added(dice, shape, at.points(*dice.choice(ABOVE)), at, False)
    page = sheet(dice, shape)
    place = named(page, inner, outer)
    if not page.backwards:
        page.mark(*inner, 0)
        place += ["vertex 0", *place_of(*(page.shape[p][r][0] for p, r in (inner, outer)))]
    return refused(dice, page, "overlapping-polygons", *place)
