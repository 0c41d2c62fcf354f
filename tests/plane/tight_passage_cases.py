"""Exact fits made by hand, each with its tight passages derived from the definition.

Everywhere x is tight iff sP and x - Q touch and every small motion makes them overlap; x - Q is Q
turned by 180 degrees about the origin and moved by x. For the unit square U = [0,1]^2 the set
x - U is [x-1, x] x [y-1, y].
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

Pair = tuple[int | str | Fraction, int | str | Fraction]
Ring = list[Pair]
Edge = tuple[str, int, int, int, int]  # kind, ring and index of the edge, of the vertex


@dataclass(frozen=True)
class Case:
    title: str
    P: list[list[Ring]]  # polygons: an outer ring (counter-clockwise), then holes (clockwise)
    Q: list[list[Ring]]
    scale: str
    passages: list[Ring]
    near: list[Ring] | None = field(default_factory=list)  # at s* +- 2^-40; None: not critical
    contacts: list[list[list[Edge]]] | None = None


def box(x0: int, y0: int, x1: int, y1: int) -> Ring:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def hole(x0: int, y0: int, x1: int, y1: int) -> Ring:
    return [(x0, y0), (x0, y1), (x1, y1), (x1, y0)]


def moved(polygons: list[list[Ring]], dx: str, dy: str) -> list[list[Ring]]:
    by = (Fraction(dx), Fraction(dy))
    return [
        [[(Fraction(x) + by[0], Fraction(y) + by[1]) for x, y in ring] for ring in polygon]
        for polygon in polygons
    ]


UNIT = [[box(0, 0, 1, 1)]]
FRAME = [[box(0, 0, 4, 4), hole(1, 1, 2, 2)]]
CORRIDOR = [[box(0, 0, 5, 3), hole(1, 1, 4, 2)]]
# [0,3]^2 without the slot (1,2) x (1,3], open at its top.
FORK = [[[(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]]]
GAP_RING = [
    [
        [
            *[(0, 0), (5, 0), (5, 2), (4, 2), (4, 1), (1, 1)],
            *[(1, 4), (4, 4), (4, 3), (5, 3), (5, 5), (0, 5)],
        ]
    ]
]
# A hole in hourglass form, 6 high, with a waist 2 wide at half the height.
HOURGLASS = [[box(-9, -9, 15, 15), [(0, 0), (2, 3), (0, 6), (6, 6), (4, 3), (6, 0)]]]
FOUR_SQUARES = [[box(0, 0, 1, 1)], [box(2, 0, 3, 1)], [box(0, 2, 1, 3)], [box(2, 2, 3, 3)]]
# Two squares that touch at the origin, filling quadrants 1 and 3; two more, filling quadrants 2 and
# 4.
ONE_THREE = [[box(-1, -1, 0, 0)], [box(0, 0, 1, 1)]]
TWO_FOUR = [[box(-1, 0, 0, 1)], [box(0, -1, 1, 0)]]
# A hole with its apex at the origin, the middle of the upper side.
APEX = [[box(-2, -4, 2, 0), [(0, 0), (1, -2), (-1, -2)]]]
# Four blunt tips at (1,0), (0,1), (-1,0), (0,-1) that point at the origin.
HALF = Fraction(3, 2)
TIPS = [
    [[(1, 0), (2, -HALF), (2, HALF)]],
    [[(0, 1), (HALF, 2), (-HALF, 2)]],
    [[(-1, 0), (-2, HALF), (-2, -HALF)]],
    [[(0, -1), (-HALF, -2), (HALF, -2)]],
]
DIAMOND = [[[(1, 0), (0, 1), (-1, 0), (0, -1)]]]
TRIANGLE = [[[(-3, -2), (4, -1), (1, 3)]]]
# The hole's three sides, moved inwards by the triangle's support, share a point at s = 541/186: it
# solves -31 x - 17 y = a and 2 x + 36 y = b.
CRITICAL = Fraction(541, 186)
A, B = -340 + CRITICAL * 127, -362 + CRITICAL * 110
MEETING = ((36 * A + 17 * B) / -1082, (-31 * B - 2 * A) / -1082)

CASES = [
    Case(
        "a square peg in a square hole: a point, held by the four sides of the hole",
        FRAME,
        UNIT,
        "1",
        [[(2, 2)]],  # x - U = [1,2]^2
        contacts=[[[("S", 1, 0, 0, 2), ("S", 1, 1, 0, 1), ("S", 1, 2, 0, 0), ("S", 1, 3, 0, 3)]]],
    ),
    Case(
        "a hole longer than the peg: a segment, held by the two long sides",
        CORRIDOR,
        UNIT,
        "1",
        [[(2, 2), (4, 2)]],  # x - 1 from 1 to 3
        contacts=[[[("S", 1, 1, 0, 1), ("S", 1, 3, 0, 3)]]],
    ),
    Case(
        "straight vertices in the sides of the hole do not cut the segment",
        [[box(0, 0, 5, 3), [(1, 1), (1, 2), (3, 2), (4, 2), (4, 1), ("5/2", 1), (2, 1)]]],
        UNIT,
        "1",
        [[(2, 2), (4, 2)]],
        # The upper side is edges 1 and 2 at Q's vertex 1: (2,2)-(4,2) and (4,2)-(5,2), of which the
        # first covers the passage and the second touches its end only. The lower side is edges 4, 5
        # and 6 at Q's vertex 3: (4,2)-(5/2,2), (5/2,2)-(2,2) and (2,2)-(1,2).
        contacts=[[[("S", 1, 1, 0, 1), ("S", 1, 4, 0, 3), ("S", 1, 5, 0, 3)]]],
    ),
    Case(
        "an open slot: the passage reaches the outer boundary of the sum",
        FORK,
        UNIT,
        "1",
        # x - 1 = 1, and y - 1 from the bottom of the slot at 1 up to where U leaves it at 3.
        [[(2, 2), (2, 4)]],
        # The right wall downwards at (0,0) covers y from 1 to 3, the left wall upwards at (1,1)
        # from 2 to 4, U's left side downwards at the mouth's vertex (2,3) from 3 to 4.
        contacts=[[[("S", 0, 3, 0, 0), ("S", 0, 5, 0, 2), ("T", 0, 3, 0, 3)]]],
    ),
    Case(
        "a gap in a ring: from the hole of the sum to its outer boundary",
        GAP_RING,
        UNIT,
        "1",
        # In the gap [4,5] x (2,3) y = 3; free for x <= 4 (in the cavity), gone at x - 1 = 5.
        [[(4, 3), (6, 3)]],
    ),
    Case(
        "an L-shaped hole: a polyline with one bend",
        [[box(0, 0, 5, 5), [(1, 1), (1, 4), (2, 4), (2, 2), (4, 2), (4, 1)]]],
        UNIT,
        "1",
        [[(2, 4), (2, 2), (4, 2)]],
    ),
    Case(
        "a Z-shaped hole: a polyline with two bends",
        [[box(0, 0, 7, 5), [(1, 1), (1, 2), (3, 2), (3, 4), (6, 4), (6, 3), (4, 3), (4, 1)]]],
        UNIT,
        "1",
        [[(2, 2), (4, 2), (4, 4), (6, 4)]],
    ),
    Case(
        "a T-shaped hole: three segments that meet",
        [[box(0, 0, 5, 4), [(1, 2), (1, 3), (4, 3), (4, 2), (3, 2), (3, 1), (2, 1), (2, 2)]]],
        UNIT,
        "1",
        [[(2, 3), (3, 3)], [(3, 2), (3, 3)], [(3, 3), (4, 3)]],
    ),
    Case(
        "a plus-shaped hole: crossing segments are four pieces that meet",
        [
            [
                box(0, 0, 5, 5),
                [
                    *[(1, 2), (1, 3), (2, 3), (2, 4), (3, 4), (3, 3)],
                    *[(4, 3), (4, 2), (3, 2), (3, 1), (2, 1), (2, 2)],
                ],
            ]
        ],
        UNIT,
        "1",
        [[(2, 3), (3, 3)], [(3, 2), (3, 3)], [(3, 3), (3, 4)], [(3, 3), (4, 3)]],
    ),
    Case(
        "a channel round an island: a closed polyline",
        [[box(0, 0, 7, 7), hole(1, 1, 6, 6)], [box(2, 2, 5, 5)]],
        UNIT,
        "1",
        [[(2, 2), (2, 6), (6, 6), (6, 2), (2, 2)]],
    ),
    Case(
        "a channel round an island with a blind arm: a loop and a segment at its begin",
        [[box(0, 0, 9, 7), [(1, 1), (1, 6), (6, 6), (6, 2), (8, 2), (8, 1)]], [box(2, 2, 5, 5)]],
        UNIT,
        "1",
        [[(6, 2), (2, 2), (2, 6), (6, 6), (6, 2)], [(6, 2), (8, 2)]],
    ),
    Case(
        "two holes, a point in one and a segment in the other",
        [[box(0, 0, 9, 4), hole(1, 1, 2, 2), hole(4, 1, 7, 2)]],
        UNIT,
        "1",
        [[(2, 2)], [(5, 2), (7, 2)]],
    ),
    Case(
        "a notch wider at its bottom holds its counterpart: a point",
        # The notch is the trapezoid T = (1,1) (5,1) (4,3) (2,3), open at the top; x - Q is T + x -
        # (6,4). Its outer normals (-2,1), (2,1), (0,-1) at the touching sides have a positive
        # combination equal to zero, so no motion frees it.
        [[[(0, 0), (6, 0), (6, 3), (4, 3), (5, 1), (1, 1), (2, 3), (0, 3)]]],
        [[[(5, 3), (1, 3), (2, 1), (4, 1)]]],
        "1",
        [[(6, 4)]],
    ),
    Case(
        "a notch wider at its top lets its counterpart out: none",
        [[[(0, 0), (6, 0), (6, 3), (5, 3), (4, 1), (2, 1), (1, 3), (0, 3)]]],
        [[[(4, 3), (2, 3), (1, 1), (5, 1)]]],
        "1",
        [],
        near=None,
    ),
    Case(
        "the waist of an hourglass: vertices of P slide along the peg's sides, from hole to hole",
        # At s = 1/2 the waist is from (1,3/2) to (2,3/2): x = 2 and y - 1 < 3/2 < y.
        HOURGLASS,
        UNIT,
        "1/2",
        [[(2, "3/2"), (2, "5/2")]],
        contacts=[[[("T", 0, 1, 1, 1), ("T", 0, 3, 1, 4)]]],
    ),
    Case(
        "the waist of an hourglass and a diamond: a pinch of the boundary is no passage",
        # Vertex meets vertex on both sides at x = (3/2, 3/2), but up and down the way is free.
        HOURGLASS,
        [[[("1/2", 0), (0, "1/2"), ("-1/2", 0), (0, "-1/2")]]],
        "1/2",
        [],
        near=None,
    ),
    Case(
        "four tips against the vertices of a diamond: a point, vertex to vertex",
        # Each tip (2 to 3, so blunter than the diamond's right angle) forbids all motions within
        # 56 degrees of its own direction: together all.
        TIPS,
        DIAMOND,
        "1",
        [[(0, 0)]],
        contacts=[
            [
                [
                    *[("S", 0, 0, 0, 2), ("S", 0, 2, 0, 2), ("S", 1, 0, 0, 3), ("S", 1, 2, 0, 3)],
                    *[("S", 2, 0, 0, 0), ("S", 2, 2, 0, 0), ("S", 3, 0, 0, 1), ("S", 3, 2, 0, 1)],
                ]
            ]
        ],
    ),
    Case(
        "a peg in the hole of Q: a point",
        # x minus the hole of Q is (x-2, x-1)^2, which equals sP = [0,1]^2 at x = (2,2).
        UNIT,
        FRAME,
        "1",
        [[(2, 2)]],
    ),
    Case(
        "a peg that does not contain the origin in the hole of Q, at a scale other than 1",
        # sP = [2,3]^2 at s = 1/2, so x - 2 = 2.
        [[box(4, 4, 6, 6)]],
        FRAME,
        "1/2",
        [[(4, 4)]],
    ),
    Case(
        "a fit on both sides at once: the peg in P's hole, the island in the peg's hole",
        # x - Q is [x-3, x]^2 without (x-2, x-1)^2: in (1,4)^2 and round [2,3]^2 for x = (4,4) only.
        [[box(0, 0, 5, 5), hole(1, 1, 4, 4)], [box(2, 2, 3, 3)]],
        [[box(0, 0, 3, 3), hole(1, 1, 2, 2)]],
        "1",
        [[(4, 4)]],
    ),
    Case(
        "both operands away from the origin",
        # The first case: (2,2) + (10,-7) + (-3,2/3).
        moved(FRAME, "10", "-7"),
        moved(UNIT, "-3", "2/3"),
        "1",
        [[(9, "-13/3")]],
    ),
    Case(
        "a hole that is the size of the peg at s = 3/2",
        # At this scale the hole is (3,6)^2, and the peg has side 3.
        [[box(0, 0, 8, 8), hole(2, 2, 4, 4)]],
        [[box(0, 0, 3, 3)]],
        "3/2",
        [[(6, 6)]],
    ),
    Case(
        "a slanted corridor and a parallelogram of its width",
        # The hole is (1,1) + [0,1] (6,2) + [0,1] (0,2); x - Q has its lower left corner at
        # x - (3,3), from (1,1) to (1,1) + (3,1).
        [[box(0, 0, 9, 7), [(1, 1), (1, 3), (7, 5), (7, 3)]]],
        [[[(0, 0), (3, 1), (3, 3), (0, 2)]]],
        "1",
        [[(4, 4), (7, 5)]],
    ),
    Case(
        "a triangle in a triangular hole of other angles: a point where three edges meet",
        TRIANGLE,
        [[box(-40, -40, 40, 40), [(0, 20), (17, -11), (-19, -9)]]],
        "541/186",
        [[MEETING]],
    ),
    Case(
        "two squares whose gap is the peg's width: a segment, both ends on the boundary",
        # [0,2]^2 and [2,4] x [0,2]; nothing of the open sums on x = 2.
        [[box(0, 0, 1, 1)], [box(2, 0, 3, 1)]],
        UNIT,
        "1",
        [[(2, 0), (2, 2)]],
    ),
    Case(
        "two squares side by side at different heights: the common part of their sides",
        # [0,2]^2 and [2,4] x [1/2,5/2].
        [[box(0, 0, 1, 1)], [[(2, "1/2"), (3, "1/2"), (3, HALF), (2, HALF)]]],
        UNIT,
        "1",
        [[(2, "1/2"), (2, 2)]],
    ),
    Case(
        "four squares: crossing segments that reach the outer boundary",
        FOUR_SQUARES,
        UNIT,
        "1",
        [[(0, 2), (2, 2)], [(2, 0), (2, 2)], [(2, 2), (2, 4)], [(2, 2), (4, 2)]],
    ),
    Case(
        "two squares whose sums meet in a point: that is boundary, none",
        [[box(0, 0, 1, 1)], [box(2, 2, 3, 3)]],
        UNIT,
        "1",
        [],
        near=None,
    ),
    Case(
        "rings that touch in the origin, P and Q in opposite quadrants: a point at all scales",
        ONE_THREE,
        TWO_FOUR,
        "1",
        [[(0, 0)]],
        near=[[(0, 0)]],
    ),
    Case("the same at s = 1/3", ONE_THREE, TWO_FOUR, "1/3", [[(0, 0)]], near=[[(0, 0)]]),
    Case(
        "a segment through the point where two squares touch: it slides, at all scales",
        # x - Q passes the origin for x on Q; its ends are on the boundary of the sum.
        ONE_THREE,
        [[[(0, 0), (1, -1)]]],
        "7/5",
        [[(0, 0), (1, -1)]],
        near=[[(0, 0), (1, -1)]],
        # Vertex (0,0) is the lower square's third vertex and the upper square's first; Q's edge 0
        # runs right and down, edge 1 back.
        contacts=[[[("T", 0, 0, 1, 0), ("T", 0, 1, 0, 2)]]],
    ),
    Case(
        "a hole that touches the outer ring inside of an edge: a segment through the point, always",
        # x - Q = {0} x [y-1, y] passes the apex (0,0) from the hole to the outside for y from 0 to
        # 1. Right of the apex, P's interior lies between outer edge 2, leftwards, and hole edge 0,
        # downwards: Q's edge 1, down, touches it. Left of the apex Q's edge 0 does so.
        APEX,
        [[[(0, 0), (0, 1)]]],
        "1",
        [[(0, 0), (0, 1)]],
        near=[[(0, 0), (0, 1)]],
        contacts=[[[("T", 0, 0, 1, 0), ("T", 0, 1, 1, 0)]]],
    ),
    Case(
        "the same hole and two thin triangles, tip to tip: a point at all scales",
        # Up, down and to both sides a tip enters P next to the apex.
        APEX,
        [[[(0, 0), ("1/4", 1), ("-1/4", 1)]], [[(0, 0), ("-1/4", -1), ("1/4", -1)]]],
        "1",
        [[(0, 0)]],
        near=[[(0, 0)]],
    ),
    Case(
        "a segment as high as a corridor: without its ends, it may stand at the end walls",
        # ri Q is open: x from 1 to 4, both included, where x - Q stands at a wall from the inside.
        CORRIDOR,
        [[[(0, 0), (0, 1)]]],
        "1",
        [[(1, 2), (4, 2)]],
        contacts=[[[("S", 1, 1, 0, 0), ("S", 1, 3, 0, 1)]]],
    ),
    Case(
        "a segment as long as a corridor", CORRIDOR, [[[(0, 0), (3, 0)]]], "1", [[(4, 1), (4, 2)]]
    ),
    Case(
        "a segment shorter than a corridor is free in it: none",
        CORRIDOR,
        [[[(0, 0), (2, 0)]]],
        "1",
        [],
        near=None,
    ),
    Case(
        "a segment across an open slot: from its bottom to the outer boundary",
        # x = 2, y from the slot's bottom at 1 to its mouth at 3, where the sum ends.
        FORK,
        [[[(0, 0), (1, 0)]]],
        "1",
        [[(2, 1), (2, 3)]],
    ),
    Case(
        "a segment as P, in a hole of Q",
        # sP = {0} x [0,1]; x less the hole is (x-4, x-1) x (y-2, y-1): y = 2, x from 1 to 4.
        [[[(0, 0), (0, 2)]]],
        CORRIDOR,
        "1/2",
        [[(1, 2), (4, 2)]],
    ),
    Case("a point as Q: none, though rings of P touch", ONE_THREE, [[[(0, 0)]]], "1", []),
    Case("a point as P: none", [[[(3, 4)]]], TWO_FOUR, "2", []),
    Case("two convex operands: none", TRIANGLE, UNIT, "1", []),
]
