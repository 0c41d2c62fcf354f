"""Invalid rings, each in an operand that would be valid without the damage."""

from __future__ import annotations

from random import Random

from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region, spot
from minkref.degeneracies.invalid.sheet import CLOSED, JSON_FORMS, Tokens, place_of, sheet, token
from minkref.degeneracies.invalid.writing import refused
from minkref.fuzz.geometry.plane import Shape, box

FAMILIES = Families()

Damage = tuple[tuple[tuple[int, int], ...], tuple[int, ...]]

# In a spot's coordinates: the points to insert, and the numbers of points that each message names.
CROSSING: Damage = ((-1, 0), (1, 1), (-1, 1), (1, 0)), (0, 1, 2, 3)
TOUCHING: Damage = ((-1, 0), (2, 0), (2, 1), (0, 0), (-1, 1), (-1, 2), (3, 2), (3, 0)), (0, 1, 3)
MEETING: Damage = ((0, 0), (2, 0), (2, 1), (0, 0), (-1, 1), (-1, 2), (3, 2), (3, 0)), (0,)
SPIKE: Damage = ((0, 0), (0, 2), (0, 0)), (0,)
FOLD: Damage = ((2, 0), (-1, 0), (3, 0)), (0, 1)
LINES = ((0, 2, 1), (0, 1, 2), (0, 3, 1, 2), (0, 3, 2, 1), (1, 3, 2, 0, -1))


@FAMILIES.add("a ring that crosses or touches itself")
def self_intersection(dice: Random) -> Invalid:
    if dice.random() < 0.2:
        return _bow_tie(dice)
    shape = region(dice)
    at = spot(dice, shape)
    points, named = dice.choice((CROSSING, CROSSING, TOUCHING, MEETING, SPIKE, FOLD))
    k, ring = at.edge + 1, shape[at.polygon][at.ring]
    ring[k:k] = at.points(*points)
    page = sheet(dice, shape)
    ring = page.shape[at.polygon][at.ring]
    if page.backwards:
        k, named = len(ring) - k - len(points), tuple(len(points) - 1 - i for i in named)
    place = [f"ring {page.number(at.polygon, at.ring)}", *place_of(*(ring[k + i] for i in named))]
    if points == CROSSING[0] and not page.backwards:
        page.mark(at.polygon, at.ring, k)
        place.append(f"vertices {k}, {k + 1}, {k + 2}, {k + 3}")
    return refused(dice, page, "self-intersection", *place)


def _bow_tie(dice: Random) -> Invalid:
    """A box with two exchanged corners: its area is zero, or nearly."""
    a, b, c, d = box(0, 0, dice.randint(1, 20), dice.randint(2, 20))
    ring = [a, c, b, (d[0], d[1] - dice.choice((0, 0, 1)))]
    page = sheet(dice, [[ring]], backwards=False)
    return refused(dice, page, "self-intersection", "ring 0", *place_of(*page.shape[0][0]))


@FAMILIES.add("a vertex twice in a row")
def zero_length_edge(dice: Random) -> Invalid:
    shape = region(dice)
    p = dice.randrange(len(shape))
    r = dice.randrange(len(shape[p]))
    k = dice.randrange(len(shape[p][r]))
    shape[p][r].insert(k, shape[p][r][k])
    page = sheet(dice, shape)
    twice = page.shape[p][r][-k - 1 if page.backwards else k]
    place = [f"ring {page.number(p, r)}", *place_of(twice)]
    if not page.backwards:
        page.mark(p, r, k)
        place.append(f"vertices {k}, {k + 1}")
    return refused(dice, page, "zero-length-edge", *place)


@FAMILIES.add("a ring whose vertices all lie on one line")
def zero_area(dice: Random) -> Invalid:
    """A ring along a line: a hole, a polygon, or the whole operand."""
    steps = dice.choice(LINES)
    kind = dice.choice(("hole", "polygon", "all"))
    if kind == "all":
        dx, dy = dice.randint(1, 9), dice.randint(-9, 9)
        shape: Shape = [[[(k * dx, k * dy) for k in steps]]]
        p = r = 0
    else:
        shape = region(dice)
        at = spot(dice, shape, outer=True)
        flat = at.points(*((k - 1, 2 if kind == "hole" else -2) for k in steps))
        p, r = (at.polygon, len(shape[at.polygon])) if kind == "hole" else (len(shape), 0)
        shape[p:p] = [] if kind == "hole" else [[]]
        shape[p].append(flat)
    page = sheet(dice, shape)
    page.mark(p, r, 0)
    named = ["vertices 0, 1, 2", *place_of(*page.shape[p][r][:3])]
    return refused(dice, page, "zero-area", f"ring {page.number(p, r)}", *named)


@FAMILIES.add("a ring of fewer than three vertices")
def too_few_vertices(dice: Random) -> Invalid:
    """A hole, or the whole operand in formats where it would not be a point or segment."""
    shape = region(dice)
    page = sheet(dice, shape)
    p = dice.randrange(len(shape))
    if page.form not in JSON_FORMS and dice.random() < 0.3:
        page.polygons[:] = [[page.polygons[p][0]]]
        p = r = 0
    else:
        r = len(page.polygons[p])
        page.polygons[p].append(Tokens())
    count = dice.randint(0 if page.form != "wkt" else 1, 2)
    ring = Tokens(page.polygons[p][0][:count])
    if page.form in CLOSED and (count == 2 or dice.random() < 0.5):
        ring += ring[:1]
    ring.mark = True
    page.polygons[p][r] = ring
    return refused(dice, page, "too-few-vertices", f"ring {page.number(p, r)}")


@FAMILIES.add("a ring whose last vertex is not its first")
def ring_not_closed(dice: Random) -> Invalid:
    """The first vertex is missing at the end, or replaced by another point."""
    shape = region(dice)
    page = sheet(dice, shape, CLOSED)
    p = dice.randrange(len(shape))
    r = dice.randrange(len(shape[p]))
    ring, points = page.polygons[p][r], list(page.shape[p][r])
    ring.pop()
    if dice.random() < 0.5:
        x, y = points[0]
        points.append((x, y + dice.choice((1, -1, 2))))
        ring.append([token(dice, page.form, n) for n in points[-1]])
    last = len(ring) - 1
    page.mark(p, r, last)
    named = [f"vertices 0, {last}", *place_of(points[0], points[-1])]
    return refused(dice, page, "ring-not-closed", f"ring {page.number(p, r)}", *named)
