"""Section 6: convex polyhedra under non-uniform scaling, and what Section 7.2 says of them."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import sympy as sp
from minkref.fuzz.space.hull import sum_of_convex
from minkref.reports.audit.bodies import (
    ONE,
    Body,
    Edge,
    Pairs,
    Whole,
    compatible_pairs,
    cross,
    dot,
    edge_pairs,
    facet_pairs,
    hull,
    minus,
    random_body,
    scaled,
    scaled_normal,
    support,
)
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import vector
from minkref.reports.audit.space_pictures import solids_picture
from minkref.reports.audit.symbolic_space import place

CHAPTER = Chapter("section-6", "Section 6: convex polyhedra under non-uniform scaling")
SEED = 6
SCALINGS = 4  # of a random pair
UP: Whole = (0, 0, 1)
OCTAHEDRON = hull([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)])
CUBE = hull([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


def _drawn_body(dice: random.Random) -> Body:
    return random_body(dice, dice.randint(4, 6))


def _drawn_scaling(dice: random.Random, most: int = 9) -> Whole:
    return dice.randint(1, most), dice.randint(1, most), dice.randint(1, most)


def _drawn_vector(dice: random.Random) -> Whole:
    while True:
        found = dice.randint(-9, 9), dice.randint(-9, 9), dice.randint(-9, 9)
        if any(found):
            return found


def _rise(body: Body, v: int, w: int, n: Whole) -> int:
    return dot(n, minus(body.points[w], body.points[v]))


def _printed_witness(body: Body, v: int, n: Whole) -> tuple[int, int]:
    """IC times the length of n, and the other end of the edge that has it."""
    return max((abs(_rise(body, v, w, n)), w) for w in body.neighbours[v])


def _printed_walk(body: Body, v: int, n: Whole) -> list[int]:
    """Along witnesses until IC is zero or a vertex comes again."""
    walk = [v]
    while walk.count(walk[-1]) < 2:
        distance, w = _printed_witness(body, walk[-1], n)
        if distance == 0:
            break
        walk.append(w)
    return walk


def _walk(points: list[Whole] | tuple[Whole, ...], near: list[list[int]], v: int, n: Whole) -> int:
    """Up to the highest neighbour, as long as one is higher."""
    while True:
        best = max(near[v], key=lambda w: dot(n, points[w]))
        if dot(n, points[best]) <= dot(n, points[v]):
            return v
        v = best


@CHAPTER.entry(
    "degree-of-incompatibility",
    "The degree of incompatibility",
    place="Section 6",
    status=Status.FALSE,
    printed=r"""$IC(f, v)$ is the greatest distance of a point on an edge at $v$ from $f$. All edges
    at a compatible vertex are below or on the half-plane of $f$; descent along the witness ends at
    the compatible vertex.""",
    right=r"""A distance does not tell above from below: $IC$ is greater than zero at every
    compatible vertex, and the witness may lead downwards, so that the descent never ends. What does
    is $IC(f, v) = \max(0, \max_w n_f \cdot (w - v))$ over the neighbours $w$ of $v$. (A half-space
    is meant, bounded by the plane through $v$ that is parallel to $f$.) Only signs and the order of
    heights are needed, so that $n_f$ may have any length.""",
)
def _(shown: Shown) -> None:
    """An octahedron at its upper apex, for a level facet. A tetrahedron on which the printed
    descent goes to and fro between two vertices. Then 300 random bodies, directions and start
    vertices: where either walk comes to rest."""
    shown.different(
        "apex of the octahedron, $n_f = (0, 0, 1)$, $IC$",
        _printed_witness(OCTAHEDRON, 0, UP)[0],
        max(0, *(_rise(OCTAHEDRON, 0, w, UP) for w in OCTAHEDRON.neighbours[0])),
    )
    shown.equal(
        "vertices of the octahedron that are compatible with it",
        sorted(support(OCTAHEDRON.points, UP)),
        [0],
    )
    apex = vector(OCTAHEDRON.points[0])
    shown.draw(
        "the octahedron, its apex, and an edge with $IC = 1$",
        solids_picture(
            [(OCTAHEDRON.polyhedron, "second")],
            "an octahedron",
            apex,
            [(apex, vector(OCTAHEDRON.points[1]))],
        ),
    )
    body = hull([(0, 0, 0), (2, 0, 1), (0, 2, -5), (0, -2, -1)])
    shown.equal(
        "heights of the vertices of a tetrahedron", [p[2] for p in body.points], [0, 1, -5, -1]
    )
    shown.equal(
        "the printed descent from the first one visits", _printed_walk(body, 0, UP), [0, 2, 1, 2]
    )
    dice = random.Random(SEED)
    rest = right = positive = 0
    for _ in range(300):
        body, n = _drawn_body(dice), _drawn_vector(dice)
        start = dice.randrange(len(body.points))
        top = support(body.points, n)
        positive += all(_printed_witness(body, v, n)[0] > 0 for v in top)
        last = _printed_walk(body, start, n)[-1]
        rest += _printed_witness(body, last, n)[0] == 0
        near = [list(each) for each in body.neighbours]
        right += _walk(body.points, near, start, n) in top
    shown.equal(
        "300 random bodies: printed $IC$ above zero at all compatible vertices", positive, 300
    )
    shown.equal("printed walks that come to rest", rest, 0)
    shown.equal("walks by the right $IC$ that end at a compatible vertex", right, 300)


@CHAPTER.entry(
    "normals-after-scaling",
    "The normal of a scaled facet",
    place="Section 6",
    status=Status.INCOMPLETE,
    printed=r"""The facet $f$ of $P$ moves in the Gaussian map as $P$ is scaled; how its normal is
    found is not said.""",
    right=r"""With $D = diag(s_x, s_y, s_z)$, all positive, the normal of the scaled facet is
    $D^{-1} n_f$, or $(s_y s_z n_x, s_z s_x n_y, s_x s_y n_z)$, which stays integral; it is not $D
    n_f$.""",
)
def _(shown: Shown) -> None:
    """By computer algebra $(D u) \\times (D v)$ is $u \\times v$ times the cofactors, which are
    $\\det D$ times $D^{-1}$. Then 400 random facets and scalings: for how many the vertices of a
    second body that are farthest along each vector are those for the normal that the scaled corners
    have."""
    u, v, factors = place("u"), place("v"), place("s")
    D = sp.diag(*factors)
    cofactors = D.det() * D.inv()
    for name, left in zip("xyz", (D * u).cross(D * v) - cofactors * u.cross(v), strict=True):
        shown.identity(f"coordinate {name}", left)
    dice = random.Random(SEED)
    counts = {"the cofactors": 0, "$n_f$ unchanged": 0, "$D n_f$": 0}
    for _ in range(400):
        P, Q, s = _drawn_body(dice), _drawn_body(dice), _drawn_scaling(dice)
        number = dice.randrange(len(P.facets))
        n = P.normals[number]
        a, b, c = (scaled(s, P.points[k]) for k in P.facets[number])
        truth = support(Q.points, cross(minus(b, a), minus(c, a)))
        for words, vector_ in zip(counts, (scaled_normal(s, n), n, scaled(s, n)), strict=True):
            counts[words] += support(Q.points, vector_) == truth
    for words, count in counts.items():
        shown.tell(f"{words}: {count} of 400 facets get their vertices.")
    shown.true(
        "only the cofactors are right in all",
        [count == 400 for count in counts.values()] == [True, False, False],
    )


@CHAPTER.entry(
    "descent",
    "Gradient descent ends at the compatible vertex",
    place="Section 6",
    status=Status.CONDITION,
    printed=r"""The error of a facet and a vertex is corrected by gradient descent on the degree of
    incompatibility, until the pair is compatible.""",
    right=r"""With the right degree it holds on a convex polyhedron all of whose vertices are
    extreme: the edges at a vertex span the cone of the body there, so that a vertex without a
    higher neighbour is highest. It fails on meshes with vertices inside flat facets, and with
    vertices of degree two inside edges, there even from the vertex of the scale before. Such
    vertices have to be removed first.""",
)
def _(shown: Shown) -> None:
    """All vertices of 150 random bodies, for ten directions each: those without a higher neighbour
    are the farthest ones. A box with a vertex in the middle of its lower facet. A prism with a
    vertex inside an edge, which is compatible with a facet and, by its neighbours, seems to be so
    after a scaling."""
    dice = random.Random(SEED)
    same = True
    for _ in range(150):
        body = random_body(dice, dice.randint(4, 9))
        for _ in range(10):
            n = _drawn_vector(dice)
            lone = {
                v
                for v, near in enumerate(body.neighbours)
                if all(_rise(body, v, w, n) <= 0 for w in near)
            }
            same &= lone == support(body.points, n)
    shown.true("150 bodies, 10 directions: no higher neighbour means highest", same)
    points = [*CUBE.points, (0, 0, -1)]
    near = [list(each) for each in CUBE.neighbours]
    near.append([k for k, p in enumerate(CUBE.points) if p[2] == -1])
    end = _walk(points, near, 8, UP)
    shown.different(
        "a cube, from the middle of its lower facet, highest vertex found",
        points[end][2],
        max(p[2] for p in points),
    )
    section = ((1, 0), (0, 1), (-1, 0), (0, -1))
    prism = [(x, y, z) for y, z in section for x in (-1, 1)]
    middle = (0, 1, 0)
    n, s = (0, 2, 1), (1, 4, 1)
    after = scaled_normal(s, n)
    ends = [(-1, 1, 0), (1, 1, 0)]
    shown.equal(
        "a prism, neighbours of the middle of an edge that are higher, before and after",
        [sum(dot(way, minus(w, middle)) > 0 for w in ends) for way in (n, after)],
        [0, 0],
    )
    heights = [max(dot(way, p) for p in prism) - dot(way, middle) for way in (n, after)]
    shown.equal("by how much it is not highest, before and after", heights, [0, 2])
    shown.true("the normal has turned by less than a right angle", dot(n, after) > 0)


def _ridge(count: int, axis: int) -> Body:
    """A ridge of `count` edges along an axis, x or y, on a parabola, and a tip on either side."""
    low = -40 * count * count
    places = [k - count // 2 for k in range(count + 1)]
    points: list[Whole] = [(2 * k, 0, -k * k) for k in places]
    points += [(1, 1, low), (1, -1, low)]
    return hull([p if axis == 0 else (p[1], p[0], p[2]) for p in points])


@CHAPTER.entry(
    "facets-of-convex-sums",
    "O(m + n) facets of one kind and O(mn) of the other",
    place="Section 6",
    status=Status.HOLDS,
    printed=r"""For convex operands there are $O(m + n)$ fv-facets, but $O(m n)$ ee-facets.""",
    right=r"""So it is: each facet has one vertex where none is in a special position, and two
    ridges across each other have $m n$ compatible pairs of edges.""",
)
def _(shown: Shown) -> None:
    """Ridges along $x$ and $y$ with $k$ edges each, by supports: each edge of one ridge is
    compatible with each edge of the other."""
    for k in (2, 4, 6, 8):
        P, Q = _ridge(k, 0), _ridge(k, 1)
        pairs = compatible_pairs(P, Q)
        shown.true(
            f"{k} edges: {len(P.facets) + len(Q.facets)} facets of both kinds, each with one "
            f"vertex, and {len(pairs.ee)} pairs of edges, at least {k * k}",
            pairs.unique
            and len(pairs.ee) >= k * k
            and len(P.facets) + len(Q.facets) <= 4 * (2 * k + 6),
        )


# Vertices in the order of the text.
ONE_KIND = (
    hull([(0, -3, 5), (-1, -1, 4), (-2, 4, -5), (4, 5, -3)]),
    hull([(1, 5, 1), (3, 0, 3), (2, 3, -1), (-5, -5, 0)]),
    (9, 3, 4),
)
EXCHANGED = (
    hull([(1, -5, 5), (-2, -5, 3), (2, 4, 1), (-2, 2, -4)]),
    hull([(5, 4, -2), (-4, -4, -3), (5, -3, 1), (-4, 1, -5)]),
    (5, 5, 1),
)


def _errors(before: Pairs, after: Pairs) -> tuple[int, int, int]:
    """How many facets of P, facets of Q and pairs of edges are no longer compatible."""
    return (
        sum(a != b for a, b in zip(before.fv, after.fv, strict=True)),
        sum(a != b for a, b in zip(before.vf, after.vf, strict=True)),
        len(before.ee - after.ee),
    )


def _draw_pair(shown: Shown, words: str, P: Body, Q: Body, s: Whole) -> None:
    for caption, solid, style in (
        (f"{words}: $P$", P.polyhedron, "first"),
        (f"{words}: $P$ scaled by {s}", P.polyhedron.scaled(vector(s)), "first"),
        (f"{words}: $Q$", Q.polyhedron, "second"),
    ):
        shown.draw(caption, solids_picture([(solid, style)], "a tetrahedron"))


@CHAPTER.entry(
    "theorem-1-one-kind",
    "Theorem 1 with the facets of P only",
    place="Section 6, Theorem 1",
    status=Status.FALSE,
    printed=r"""An fv-error is one of a facet $f$ of $P$ and a vertex $v$ of $Q$; where there is an
    ee-error there is an fv-error.""",
    right=r"""Facets of $Q$ at vertices of $P$ have to be looked at as well: an ee-error may come
    with an error of these alone. (The text also writes vf-pairs, without saying that they differ.)
    """,
)
def _(shown: Shown) -> None:
    """Two tetrahedra and a scaling by (9, 3, 4), by supports: an edge pair is lost, all facets of
    $P$ keep their vertices, and a facet of $Q$ does not. Of random pairs of bodies it is told how
    many are such."""
    P, Q, s = ONE_KIND
    before, after = (compatible_pairs(P, Q, each) for each in (ONE, s))
    shown.true("each facet has one vertex, before and after", before.unique and after.unique)
    shown.equal(
        "errors of facets of $P$, of facets of $Q$, of edges", _errors(before, after), (0, 1, 1)
    )
    shown.equal("the lost pair of edges", sorted(before.ee - after.ee), [((0, 1), (0, 3))])
    (moved,) = (k for k in range(4) if before.vf[k] != after.vf[k])
    shown.equal(
        "the facet of $Q$ that moves, and its vertices of $P$",
        (tuple(sorted(Q.facets[moved])), *before.vf[moved], *after.vf[moved]),
        ((0, 1, 3), 0, 1),
    )
    _draw_pair(shown, "the pair", P, Q, s)
    dice = random.Random(SEED)
    edges = alone = 0
    for _ in range(400):
        P, Q, s = _drawn_body(dice), _drawn_body(dice), _drawn_scaling(dice)
        before, after = (compatible_pairs(P, Q, each) for each in (ONE, s))
        if before.unique and after.unique:
            of_P, _, of_edges = _errors(before, after)
            edges += of_edges > 0
            alone += of_edges > 0 == of_P
    shown.true(
        f"of 400 random pairs {edges} have ee-errors, {alone} of them no error of a facet of $P$",
        alone > 0,
    )


@CHAPTER.entry(
    "theorem-1-edge-errors",
    "Theorem 1, first half, with the facets of both",
    place="Section 6, Theorem 1",
    status=Status.CONDITION,
    printed=r"""Where there is an ee-error there is an fv-error.""",
    right=r"""With the facets of both operands counted, and none in a special position, this holds
    for a scaling along one axis, times any uniform one. Along $D(t) = diag(t, 1, 1)$ the heights $m
    \cdot D(t) p$ are linear in $t$ and $n \cdot D(t)^{-1} q$ are linear in $1/t$, so that a facet
    with the same vertex at both ends has it all the way; no end of an arc ever meets another arc,
    and no pair of edges changes. For other scalings it is checked on random pairs, not proved: no
    counterexample is known. Scaling along one axis after the other, with a repair after each, needs
    the proved case only.""",
)
def _(shown: Shown) -> None:
    """The heights by computer algebra. Random pairs of bodies with 4 to 6 vertices, four scalings
    by 1 to 9 of each, along one axis but for a uniform factor, and along all: where all facets keep
    their vertices, all pairs of edges are the same, by supports."""
    t, r = sp.symbols("t r", positive=True)
    n, p = place("n"), place("p")
    stretched = sp.diag(t, 1, 1)
    shown.identity(
        "second derivative of $m \\cdot D(t) p$ in $t$", sp.diff(n.dot(stretched * p), t, 2)
    )
    shown.identity(
        "second derivative of $n \\cdot D(t)^{-1} q$ in $1/t$",
        sp.diff(n.dot(stretched.inv() * p).subs(t, 1 / r), r, 2),
    )
    dice = random.Random(SEED)
    for words, count, single in (("one axis", 400, True), ("all axes", 1000, False)):
        tried = kept = same = 0
        for _ in range(count):
            P, Q = _drawn_body(dice), _drawn_body(dice)
            before, edges = facet_pairs(P, Q, ONE), None
            if any(len(each) > 1 for each in (*before[0], *before[1])):
                continue
            for _ in range(SCALINGS):
                a, b, c = _drawn_scaling(dice)
                s = dice.choice(((a, b, b), (b, a, b), (b, b, a))) if single else (a, b, c)
                tried += 1
                if len(set(s)) > 1 and before == facet_pairs(P, Q, s):
                    edges = edges or edge_pairs(P, Q, ONE)
                    kept += 1
                    same += edges == edge_pairs(P, Q, s)
        shown.true(
            f"{words}: in {kept:,} of {tried:,} random trials no facet has an error, and no "
            "pair of edges changes",
            kept == same > 300,
        )


@CHAPTER.entry(
    "theorem-1-facet-errors",
    "Theorem 1, second half",
    place="Section 6, Theorem 1",
    status=Status.FALSE,
    printed=r"""Where there is an fv-error there is an ee-error.""",
    right=r"""There are scalings after which every facet of both operands has another vertex, and
    every pair of edges is as before: the facets exchange two vertices, and the chain of edges
    between these is the same from either end. What holds: where one facet alone passes from a
    vertex to the next one, pairs of edges are lost and gained, since the arcs at it surround it. A
    repair that starts at errors of facets loses nothing by this.""",
)
def _(shown: Shown) -> None:
    """Two tetrahedra and a scaling by (5, 5, 1), by supports; the hull of all sums of two vertices
    has as many faces before and after as the compatible pairs say. Its scaling is one along a
    single axis, times a uniform one."""
    P, Q, s = EXCHANGED
    before, after = (compatible_pairs(P, Q, each) for each in (ONE, s))
    shown.true("each facet has one vertex, before and after", before.unique and after.unique)
    shown.equal(
        "errors of facets of $P$, of facets of $Q$, of edges", _errors(before, after), (4, 4, 0)
    )
    shown.true(
        f"the {len(before.ee)} pairs of edges are the same, before and after", before.ee == after.ee
    )
    for words, which in (("$P$", "fv"), ("$Q$", "vf")):
        lists = [[min(each) for each in getattr(pairs, which)] for pairs in (before, after)]
        shown.tell(f"vertices for the facets of {words}, before {lists[0]}, after {lists[1]}")
        shown.true(
            f"facets of {words} exchange two vertices",
            set(lists[0]) == set(lists[1]) and len(set(lists[0])) == 2,
        )
    for each in (ONE, s):
        faces = sum_of_convex(P.polyhedron, Q.polyhedron, vector(each)).faces
        shown.equal(f"faces of the sum, $P$ scaled by {each}", len(faces), 8 + len(before.ee))
    _draw_pair(shown, "the pair", P, Q, s)


@CHAPTER.entry(
    "theorem-1-proof",
    "The proof of Theorem 1",
    place="Section 6, Theorem 1",
    status=Status.INCOMPLETE,
    printed=r"""While $P$ is scaled an end of one arc of the Gaussian maps must cross the other arc,
    which indicates an fv-error. $g(e)$ cannot meet a segment more than twice, and so must meet new
    edges when its end moves into another region.""",
    right=r"""Two arcs of less than a half circle meet once at most. A crossing during the scaling
    does not show an error after it: a facet may leave its vertex and come back. And the chains of
    edges at a facet that has moved may be the same as before.""",
)
def _(shown: Shown) -> None:
    """By computer algebra two great circles meet in $\\pm (a \\times b)$, which are half a circle
    apart, so that one of them at most is on an arc. A facet with the normal (1, 1, 1) and a body
    $Q$, $P$ scaled from (1, 3, 9) to (9, 3, 1), straight and by the way of (5, 3, 5): the vertex is
    another one there, and the same at both ends."""
    a, b = place("a"), place("b")
    meeting = a.cross(b)
    shown.identity("$a \\cdot (a \\times b)$", sp.expand(a.dot(meeting)))
    shown.identity("$b \\cdot (a \\times b)$", sp.expand(b.dot(meeting)))
    Q = hull([(1, -2, 1), (0, 0, 0), (-3, -3, -4), (-4, -3, -3)])
    start, middle, end = (1, 3, 9), (5, 3, 5), (9, 3, 1)
    shown.true(
        "(5, 3, 5) is half way",
        tuple(2 * m for m in middle) == tuple(u + v for u, v in zip(start, end, strict=True)),
    )
    found = [min(support(Q.points, scaled_normal(s, ONE))) for s in (start, middle, end)]
    shown.equal("vertex of $Q$ for the facet, at the start, half way, at the end", found, [0, 1, 0])


@CHAPTER.entry(
    "one-vertex-for-each-face",
    "Each face is paired with precisely one vertex",
    place="Section 6",
    status=Status.CONDITION,
    printed=r"""For convex pairs each face of $P$ is paired with precisely one vertex of $Q$, and
    the other way round; errors are found by this.""",
    right=r"""Only if no normal of a facet is orthogonal to an edge of the other operand at its
    highest place. Two boxes have four vertices for each facet, at every scaling along the axes.
    Then a facet of the sum is the sum of a facet and an edge or of two facets; or ties are broken
    by one fixed perturbation for both operands.""",
)
def _(shown: Shown) -> None:
    """A cube and a box under all scalings by 1 to 3 along each axis: four vertices for each of the
    twelve facets, and six faces of the sum. Of 300 random pairs on a grid of 5 it is told how many
    have a facet with several vertices."""
    box = hull([(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)])
    four = six = True
    for s in product((1, 2, 3), (1, 2, 3), (1, 2, 3)):
        fv, vf = facet_pairs(CUBE, box, s)
        four &= {len(each) for each in (*fv, *vf)} == {4}
        six &= len(sum_of_convex(CUBE.polyhedron, box.polyhedron, vector(s)).faces) == 6
    shown.true("27 scalings of two boxes: each of 12 facets has four vertices", four)
    shown.true("and the sum has six faces", six)
    dice = random.Random(SEED)
    ties = 0
    for _ in range(300):
        P, Q = random_body(dice, 5, 2), random_body(dice, 5, 2)
        fv, vf = facet_pairs(P, Q, _drawn_scaling(dice))
        ties += any(len(each) > 1 for each in (*fv, *vf))
    shown.true(
        f"of 300 random pairs on a small grid {ties} have a facet with several vertices",
        0 < ties < 300,
    )


def _chain(Q: Body, e: Edge, ee: frozenset[tuple[Edge, Edge]], start: int, end: int) -> list[Edge]:
    """From vertex to vertex along compatible edges, never back; empty where it gets lost."""
    found: list[Edge] = []
    at = start
    while at != end:
        ahead = [g for g in Q.edges if at in g and (e, g) in ee and g not in found[-1:]]
        if len(ahead) != 1 or len(found) > len(Q.edges):
            return []
        found += ahead
        at = sum(ahead[0]) - at
    return found


@CHAPTER.entry(
    "chain-of-edges",
    "The edges that are compatible with an edge",
    place="Section 6",
    status=Status.MISPRINT,
    printed=r"""From the vertex of one facet at $e$ to that of the other one goes along compatible
    edges, ignoring the one just found; at the end all compatible vertices have been enumerated.""",
    right=r"""All compatible edges have been. The walk is right where no facet has several vertices:
    the vertices on the way are those of the regions that $g(e)$ runs through.""",
)
def _(shown: Shown) -> None:
    """All edges of $P$ in 200 random pairs of bodies: at each vertex of the walk one edge leads on,
    and those found are all compatible ones, by supports."""
    dice = random.Random(SEED)
    walks = edges = 0
    right = True
    for _ in range(200):
        P, Q = _drawn_body(dice), _drawn_body(dice)
        pairs = compatible_pairs(P, Q)
        if not pairs.unique:
            continue
        for e, (left, beyond) in P.edges.items():
            found = _chain(Q, e, pairs.ee, min(pairs.fv[left]), min(pairs.fv[beyond]))
            right &= sorted(found) == sorted(g for own, g in pairs.ee if own == e)
            walks += 1
            edges += len(found)
    shown.true(f"{walks:,} walks find all {edges:,} compatible edges", right and edges > 1000)


@CHAPTER.entry(
    "chain-through-a-normal",
    "An edge whose arc passes through the normal of a facet",
    place="Section 6",
    status=Status.INCOMPLETE,
    printed=r"""At each vertex the edge is found with which $e$ is compatible.""",
    right=r"""Where $g(e)$ passes through the normal of a facet $f$ of $Q$, so that $e$ and $f$ are
    farthest in one direction, there is none in the strict sense, and two with ties. The sum has the
    face $e \oplus f$ there, which is neither an fv-facet nor an ee-facet.""",
)
def _(shown: Shown) -> None:
    """A tetrahedron with a level edge on top, across a cube: compatible edges of the cube at the
    vertex where the walk begins, strictly and with ties, by supports; the upper face of the sum."""
    P = hull([(1, -1, 0), (-1, 1, 0), (2, 2, -2), (-2, -2, -2)])
    pairs = compatible_pairs(P, CUBE)
    e = (0, 1)
    ends = [pairs.fv[k] for k in P.edges[e]]
    shown.true(
        "the facets at $e$ have one vertex each, and not the same",
        [len(v) for v in ends] == [1, 1] and ends[0] != ends[1],
    )
    start = min(ends[0])
    incident = [g for g in CUBE.edges if start in g]
    strict = [g for g in incident if (e, g) in pairs.ee]
    tied = [g for g in incident if _meets_with_ties(P, e, CUBE, g)]
    shown.equal(
        "edges of the cube to go along, strictly and with ties", (len(strict), len(tied)), (0, 2)
    )
    total = sum_of_convex(P.polyhedron, CUBE.polyhedron, Fraction(1))
    height = max(v[2] for v in total.vertices)
    shown.equal(
        "vertices of the upper face of the sum", sum(v[2] == height for v in total.vertices), 6
    )
    shown.draw(
        "the tetrahedron, the edge on top marked",
        solids_picture(
            [(P.polyhedron, "first")],
            "a tetrahedron",
            None,
            [(vector(P.points[0]), vector(P.points[1]))],
        ),
    )
    shown.draw("its sum with a cube", solids_picture([(total, "second")], "a sum"))


def _meets_with_ties(P: Body, e: Edge, Q: Body, g: Edge) -> bool:
    """In a direction orthogonal to both edges they are farthest, perhaps with others."""
    n = cross(P.along(e), Q.along(g))
    return any(n) and any(
        support(P.points, way) >= set(e) and support(Q.points, way) >= set(g)
        for way in (n, minus((0, 0, 0), n))
    )


@CHAPTER.entry(
    "boundary-of-convex-sums",
    "For convex pairs the convolution is the boundary of the sum",
    place="Section 7.2.2",
    status=Status.CONDITION,
    printed=r"""For convex pairs the convolution is always equal to the boundary of the sum.""",
    right=r"""So it is where no facet has several vertices: each facet of the sum is one of the
    convolution. With ties, as for two boxes, the rule of compatibility has to be made precise, or
    facets are missing or there several times.""",
)
def _(shown: Shown) -> None:
    """The hull of all sums of two vertices of 150 random pairs: it has as many faces as there are
    compatible pairs. Two boxes: the sum has 6 faces, the strict rule gives no facet, and the one
    with ties 48 of facets and vertices."""
    dice = random.Random(SEED)
    count = faces = 0
    same = True
    for _ in range(150):
        P, Q = _drawn_body(dice), _drawn_body(dice)
        pairs = compatible_pairs(P, Q)
        if not pairs.unique:
            continue
        found = len(sum_of_convex(P.polyhedron, Q.polyhedron, Fraction(1)).faces)
        same &= found == len(P.facets) + len(Q.facets) + len(pairs.ee)
        count += 1
        faces += found
    shown.true(
        f"{count} random pairs: all {faces:,} faces of sums are those of compatible pairs",
        same and count > 100,
    )
    pairs = compatible_pairs(CUBE, CUBE)
    shown.equal(
        "two cubes: faces of the sum, strict pairs, pairs with ties of facets and vertices",
        (
            len(sum_of_convex(CUBE.polyhedron, CUBE.polyhedron, Fraction(1)).faces),
            len(pairs.ee) + sum(len(v) == 1 for v in (*pairs.fv, *pairs.vf)),
            sum(len(v) for v in (*pairs.fv, *pairs.vf)),
        ),
        (6, 0, 48),
    )


@CHAPTER.entry(
    "uniform-scaling-of-convex-bodies",
    "Uniform scaling of convex bodies",
    place="Section 7.2.2",
    status=Status.FALSE,
    printed=r"""Scaling convex models uniformly makes their sums scale uniformly.""",
    right=r"""$s P \oplus Q$ is not $s (P \oplus Q)$: $2 [0, 1] \oplus [0, 1] = [0, 3]$, not $[0,
    4]$. What stays is the structure: normals do not turn, so that the compatible pairs are the same
    at all scales, and there are no events; but areas grow by $s^2$ for fv-facets, by $s$ for
    ee-facets, and not at all for vf-facets.""",
)
def _(shown: Shown) -> None:
    """The intervals. For sixty random pairs of bodies the compatible pairs at scale 7 are those at
    scale 1, by supports, and the volume of the sum is not that of the scaled sum."""
    interval = (0, 1)
    ends = [2 * a + b for a, b in product(interval, repeat=2)]
    whole = [2 * (a + b) for a, b in product(interval, repeat=2)]
    shown.different(
        "the sum of $[0, 1]$ and itself, the first scaled by 2",
        (min(whole), max(whole)),
        (min(ends), max(ends)),
    )
    dice = random.Random(SEED)
    same = differs = 0
    for _ in range(60):
        P, Q = _drawn_body(dice), _drawn_body(dice)
        same += compatible_pairs(P, Q) == compatible_pairs(P, Q, (7, 7, 7))
        one, seven = (
            sum_of_convex(P.polyhedron, Q.polyhedron, Fraction(scale)).volume for scale in (1, 7)
        )
        differs += seven != 7**3 * one
    shown.equal("sixty random pairs: compatible pairs the same at scales 1 and 7", same, 60)
    shown.equal(
        "the volume of $7 P \\oplus Q$ is not $7^3$ times that of $P \\oplus Q$", differs, 60
    )
    shown.draw(
        "an octahedron and a cube: the sum at the scale 1",
        solids_picture(
            [(sum_of_convex(OCTAHEDRON.polyhedron, CUBE.polyhedron, Fraction(1)), "first")], "a sum"
        ),
    )
    shown.draw(
        "the sum at the scale 4, the octahedron scaled",
        solids_picture(
            [(sum_of_convex(OCTAHEDRON.polyhedron, CUBE.polyhedron, Fraction(4)), "first")], "a sum"
        ),
    )
