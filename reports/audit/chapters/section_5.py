"""Section 5: uniform scaling in space, and what Sections 3, 6 and 9 say of it."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, pairwise, product
from math import comb, isqrt

import sympy as sp
from minkref.fuzz.judges import paper_space
from minkref.fuzz.space.generators.star import star
from minkref.fuzz.space.integers import area_vector
from minkref.fuzz.space.meeting import Meeting
from minkref.fuzz.space.polyhedron import Polyhedron
from minkref.reports.audit import cavity
from minkref.reports.audit.bodies import hull
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import (
    Edge,
    Facet,
    Vector,
    Vertex,
    cross,
    dot,
    drawn,
    events_of_facets,
    facet,
    minus,
    polygons_meet,
    s_edge,
    segments_meet,
    t_edge,
    vector,
)
from minkref.reports.audit.space_pictures import facets_picture, plan_picture, solids_picture
from minkref.reports.audit.symbolic_space import (
    EDGES,
    FACETS,
    Flat,
    degree,
    determinant,
    diagonal,
    edge,
    place,
    s,
)
from minkref.reports.audit.symbolic_space import facet as symbolic_facet

CHAPTER = Chapter("section-5", "Section 5: uniform scaling in space")
SEED = 5
ORACLE = ("oracle/symbolic/space_events.py", "oracle/symbolic/derive_space.py")
ORIGIN = (0, 0, 0)
KINDS = tuple(product(EDGES, FACETS))


def _flats(kinds: tuple[str, str]) -> tuple[Flat, Flat]:
    """An edge and a facet, all symbols."""
    return edge(kinds[0], "e"), symbolic_facet(kinds[1], "f")


@CHAPTER.entry(
    "contacts-of-facets",
    "Vertex events and edge events",
    place="Section 5",
    status=Status.CONDITION,
    printed=r"""Two faces come into contact where a vertex of one meets the other, or else where an
    edge of one meets an edge of the other.""",
    right=r"""So it is, where contact begins and where it ends. For convex facets the scales of
    contact are one interval, since the set of all $(s, x)$ with $x$ on the facet at the scale $s$
    is convex for each of the three kinds: $s f_P + v_Q$, $s v_P + f_Q$ and $s e_P + e_Q$. While
    they are in contact, vertices and edges that pass through the other facet are events of the same
    two kinds. A facet that is not convex may come into contact several times.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """225 random pairs of facets of all kinds, with small integers: all events by the symbolic
    oracle, and whether the facets meet, by a test in plain Python, at each event, between
    neighbouring ones and at four more scales."""
    dice = random.Random(SEED)
    met = 0
    one = found = True
    for kinds in 25 * list(product(FACETS, repeat=2)):
        a, b = (drawn(dice, kind, 3) for kind in kinds)
        events = events_of_facets(a, b)
        marks = sorted({*events["vertex"], *events["edge"]})
        ends = [Fraction(0), *marks, (marks or [Fraction(1)])[-1] + 2]
        scales = sorted(
            {
                *marks,
                *((low + high) / 2 for low, high in pairwise(ends)),
                *(Fraction(dice.randint(1, 40), dice.randint(1, 9)) for _ in range(4)),
            }
        )
        told = [(at, polygons_meet(a.corners(at), b.corners(at))) for at in scales]
        changes = [(x if x[1] else y)[0] for x, y in pairwise(told) if x[1] != y[1]]
        found &= all(at in marks for at in changes)
        one &= len(changes) <= 2 and (len(changes) < 2 or not told[0][1])
        met += any(meet for _, meet in told)
    shown.true(f"225 pairs, of which {met} meet: contact begins and ends at an event", found)
    shown.true("the scales of contact of each pair are one interval", one and met > 50)


@CHAPTER.entry(
    "moving-intersection-in-space",
    "The intersection of a line and a plane moves along a line",
    place="Section 5.1",
    status=Status.CONDITION,
    printed=r"""$x(s) = x_0 + (s - 1) \sigma$ with $\sigma = x(2) - x(1)$, for the line $l$ of an
    edge and the plane $p$ of a face, as in the plane.""",
    right=r"""So it is for S- and T-edges and facets of all three kinds, if $l$ is not parallel to
    $p$: directions and normals stand still, up to a factor $s^k$, and offsets are linear in
    $s$.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra, with symbols for all coordinates: the normal of each kind of facet is a
    power of $s$ times a constant vector, and the second derivative of $x(s)$ is zero."""
    for kind in FACETS:
        flat = symbolic_facet(kind, "f")
        u, v = flat.spans
        gap = u.cross(v) - s**flat.power * flat.along[0].cross(flat.along[1])
        shown.identity(
            f"normal of a facet $f$ of the kind {kind}, $s^{flat.power}$ aside", sum(gap)
        )
    n = place("n")
    for kind in EDGES:
        line, p, q = edge(kind, "e"), place("p"), place("q")
        d = line.along[0]
        x = line.start + d * n.dot(s * p + q - line.start) / n.dot(d)
        shown.identity(f"{kind}-edges: the second derivative of $x(s)$", sum(x.diff(s, 2)))
        shown.identity(
            f"{kind}-edges: $n \\cdot x(s)$ is the plane's offset", n.dot(x) - n.dot(s * p + q)
        )


@CHAPTER.entry(
    "overdetermined-in-space",
    "The condition of a vertex event is called overdetermined",
    place="Section 5.1",
    status=Status.FALSE,
    printed=r"""$x(s) = e_i(s)$ are three equations with one unknown; there may be no solution,
    which is so when the edges are parallel or skew.""",
    right=r"""$x(s)$ and $e_i(s)$ both lie on the line of the edge, so it is one linear equation:
    $n \cdot (e_i(s) - t_a(s)) = 0$, with the normal $n$ of the face and a corner $t_a$ of it. It
    has no solution only if its slope is zero and its constant is not. Skew edges are no exception
    but the rule: where a vertex comes to the inside of a face, its edge is skew to all edges of
    the face, or parallel to them.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra $(x(s) - e_0(s)) \\times d = 0$ whatever $n$ is. One event inside a
    triangle, by the symbolic oracle, whose edge is skew to all three sides. Then 300 random edges
    and facets: whether there is a solution goes by the slope alone."""
    n, line, corner = place("n"), edge("S", "e"), place("p") * s + place("q")
    d = line.along[0]
    x = line.start + d * n.dot(corner - line.start) / n.dot(d)
    shown.identity(r"first coordinate of $(x(s) - e_0(s)) \times d$", (x - line.start).cross(d)[0])
    shown.identity(
        r"$n \cdot (x(s) - e_0(s)) = n \cdot (t_a(s) - e_0(s))$",
        n.dot(x - line.start) - n.dot(corner - line.start),
    )
    of = facet("vf", [ORIGIN], [ORIGIN, (6, 0, 0), (0, 6, 0)])
    moving = t_edge((1, 2, 10), (2, 3, 13), (0, 0, -1))
    case, at, meet = paper_space.vertex_event(of.numbers, moving.start.numbers)
    shown.equal("a vertex comes to the inside of a triangle", (case, at, meet), ("once", 10, True))
    scale = Fraction(10)
    shown.equal(
        "sides of it that are skew to the edge of the vertex, then",
        sum(_skew(moving, side, scale) for side in of.edges),
        3,
    )
    shown.draw(
        "the triangle, and the edge at that scale",
        facets_picture([moving.at(scale)], [of.corners(scale)], "an edge and a facet"),
    )
    dice = random.Random(SEED)
    cases = {"once": 0, "always": 0, "never": 0}
    right = True
    for kind in 100 * list(FACETS):
        of = drawn(dice, kind, 2)
        vertex = Vertex(*(vector([dice.randint(-2, 2) for _ in "xyz"]) for _ in "pq"))
        n0, base = of.normal, of.vertices[0]
        slope, constant = dot(n0, minus(vertex.p, base.p)), dot(n0, minus(vertex.q, base.q))
        case, at, _ = paper_space.vertex_event(of.numbers, vertex.numbers)
        cases[case] += 1
        scale = -constant / slope if slope else Fraction(0)
        right &= at == scale if scale > 0 else case == ("never" if slope or constant else "always")
    told = ", ".join(f"{case} {count}" for case, count in cases.items())
    shown.true(f"300 random vertices and planes meet as slope and constant say: {told}", right)


def _skew(a: Edge, b: Edge, scale: Fraction) -> bool:
    (a0, a1), (b0, b1) = a.at(scale), b.at(scale)
    return dot(cross(minus(a1, a0), minus(b1, b0)), minus(b0, a0)) != 0


@CHAPTER.entry(
    "line-and-plane",
    "The system for the intersection of a line and a plane",
    place="Section 5.2",
    status=Status.HOLDS,
    printed=r"""$e_a - t_a = M^T (t, u, v)$ with the rows $e_a - e_b$, $t_b - t_a$, $t_c - t_a$ of
    $M$, hence $(t, u, v)$ by the inverse of the transposed matrix, with all entries linear in
    $s$.""",
    right=r"""So it is, the transposition being meant before the inversion. For the edges and
    facets of a convolution it simplifies: $\det M = c s^k$ with a constant $c$ and $k$ from 0 to 3,
    and $t$, $u$, $v$ are quotients of linear functions and powers of $s$.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra: with the transposed inverse both parametrisations name the same point,
    for all $M$; the determinant for all six kinds of edges and facets. A matrix with small integers
    shows that the inverse without transposition does not do."""
    M = sp.Matrix([list(place(name)) for name in "abc"])
    gap = place("g")  # e_a - t_a
    t, u, v = M.T.inv() * gap
    points = gap - t * M[0, :].T - u * M[1, :].T - v * M[2, :].T
    for name, left in zip("xyz", points, strict=True):
        shown.identity(f"coordinate {name} of $e(t)$ and of $p(u, v)$", left)
    numbers = sp.Matrix([[-1, 0, 0], [1, 2, 0], [0, 1, 1]])
    one, other = (tuple(m.inv() * sp.Matrix([1, 1, 1])) for m in (numbers, numbers.T))
    shown.different("an example, $(t, u, v)$ without transposition", one, other)
    for kinds in KINDS:
        line, plane = _flats(kinds)
        k = line.power + plane.power
        det = determinant(-line.spans[0], *plane.spans)
        shown.identity(
            rf"{kinds[0]}-edge and {kinds[1]}-facet: $\det M$ and $s^{k}$ times its value"
            " at 1",
            det - s**k * det.subs(s, 1),
        )


@CHAPTER.entry(
    "edge-events",
    "The lines of two edges meet where x1 = x2",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""$l_1$ and $l_2$ meet precisely where $x_1 = x_2$, for $x_1$ on $l_1$ and $p_2$ and
    $x_2$ on $l_2$ and $p_1$; the expressions are set equal and solved for $s$.""",
    right=r"""That holds if $l_1$ is not parallel to $p_2$ nor $l_2$ to $p_1$. Both points lie on
    the line $p_1 \cap p_2$, so that of the three equations one is independent: $\det(d_1, d_2, s
    \Delta p + \Delta q) = 0$, which is linear in $s$ for S- and T-edges, and needs no facets.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra $(n_2 \\cdot d_1)(n_1 \\cdot d_2)(x_1 - x_2) = \\det(d_1, d_2, w) (n_1
    \\times n_2)$, with $w$ from the first line to the second. The degree of the determinant for all
    kinds of edges, and for 200 random pairs that it is that of the symbolic oracle."""
    d1, g1, d2, g2, w = (place(name) for name in ("d", "g", "e", "h", "w"))
    n1, n2 = d1.cross(g1), d2.cross(g2)
    first, second = n2.dot(d1), n1.dot(d2)
    gap = d1 * n2.dot(w) * second - w * first * second + d2 * n1.dot(w) * first
    gap -= determinant(d1, d2, w) * n1.cross(n2)
    for name, left in zip("xyz", gap, strict=True):
        shown.identity(f"coordinate {name}", sp.expand(left))
    for kinds in product(EDGES, repeat=2):
        a, b = edge(kinds[0], "a"), edge(kinds[1], "b")
        k = a.power + b.power
        det = determinant(a.spans[0], b.spans[0], b.start - a.start)
        own = determinant(a.along[0], b.along[0], b.start - a.start)
        shown.identity(
            f"{''.join(kinds)}: determinant and $s^{k}$ times one of its own", det - s**k * own
        )
        shown.equal(f"{''.join(kinds)}: its degree, without the factor", degree(own), 1)
    dice = random.Random(SEED)
    same = True
    for _ in range(200):
        x, y = _random_edge(dice), _random_edge(dice)
        p, q = minus(y.start.p, x.start.p), minus(y.start.q, x.start.q)
        turn = cross(x.direction, y.direction)
        slope, constant = paper_space.lines_polynomial(x.numbers, y.numbers)
        same &= (slope, constant) in ((dot(turn, p), dot(turn, q)), (-dot(turn, p), -dot(turn, q)))
    shown.true("200 random pairs: the coefficients are those of the symbolic oracle", same)


def _random_edge(dice: random.Random, size: int = 3) -> Edge:
    while True:
        (a, b, c) = ([dice.randint(-size, size) for _ in "xyz"] for _ in "abc")
        if a != b:
            make = dice.choice((s_edge, t_edge))
            return make((a[0], a[1], a[2]), (b[0], b[1], b[2]), (c[0], c[1], c[2]))


@CHAPTER.entry(
    "singular-systems",
    "The system is singular for other faces than parallel ones",
    place="Section 5.2",
    status=Status.INCOMPLETE,
    printed=r"""If the faces are parallel the matrix is singular, and edge events are not found in
    the usual way; such faces are treated by themselves.""",
    right=r"""It is singular wherever $l_1$ is parallel to $p_2$, and so for parallel edges. Faces
    need not be parallel for that: a face that comes down on another one along an edge has edge
    events, no vertex event, and no $x_1$. The determinant of the two lines finds them.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """A level triangle, and an upright one that comes down on it: the determinant of the matrix of
    the lower edge and the level plane is zero; the symbolic oracle has the edge events at 3, and no
    vertex event there. By computer algebra $\\det M = -n_2 \\cdot d_1$."""
    d1, u, v = place("d"), place("u"), place("v")
    shown.identity(r"$\det M + n_2 \cdot d_1$", determinant(-d1, u, v) + u.cross(v).dot(d1))
    level = facet("vf", [ORIGIN], [ORIGIN, (2, 0, 0), (1, 4, 0)])
    upright = facet("vf", [(0, 0, -1)], [(-5, 1, 3), (5, 1, 3), (0, 1, 8)])
    lower = upright.edges[0]
    shown.equal("$n_2 \\cdot d_1$ for the lower edge", dot(level.normal, lower.direction), 0)
    shown.true("the facets are not parallel", any(cross(level.normal, upright.normal)))
    events = events_of_facets(level, upright)
    shown.equal("scale at which they begin to meet", min(events["edge"]), 3)
    at = Fraction(3)
    shown.true(
        "they meet there, and not just before",
        polygons_meet(level.corners(at), upright.corners(at))
        and not polygons_meet(*(f.corners(Fraction(299, 100)) for f in (level, upright))),
    )
    shown.equal("vertex events there", events["vertex"].count(at), 0)
    shown.equal(
        "edge events of the lower edge there, of the pairs of edges",
        sum(paper_space.edge_contact(lower.numbers, e.numbers) == (at, at) for e in level.edges),
        2,
    )
    shown.draw(
        "the two facets at the scale 3",
        facets_picture([upright.corners(at)], [level.corners(at)], "two facets"),
    )


@CHAPTER.entry(
    "inside-both",
    "Edge events have to be inside both edges",
    place="Section 5.2",
    status=Status.INCOMPLETE,
    printed=r"""The scale at which $l_1$ and $l_2$ meet is an edge event. (Of vertex events it is
    said that they are checked to be in the face.)""",
    right=r"""Lines are not edges: the parameters at that scale have to be in $[0, 1]$ on both
    edges, which few are. And the scale has to be positive.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """1,000 random pairs of edges whose lines come to meet at one scale: how many meet there
    themselves, by a test in plain Python, which agrees with the symbolic oracle."""
    dice = random.Random(SEED)
    count = positive = meeting = 0
    same = True
    while count < 1000:
        a, b = _random_edge(dice), _random_edge(dice)
        slope, constant = paper_space.lines_polynomial(a.numbers, b.numbers)
        if slope == 0:
            continue
        count += 1
        at = -constant / slope
        if at <= 0:
            continue
        positive += 1
        meets = segments_meet(*a.at(at), *b.at(at))
        same &= meets == (paper_space.edge_contact(a.numbers, b.numbers) is not None)
        meeting += meets
    shown.true(
        f"of 1,000 such scales {positive} are positive, at {meeting} of which the edges meet",
        0 < meeting < positive,
    )
    shown.true("the symbolic oracle agrees on each", same)


@CHAPTER.entry(
    "facets-in-triangles",
    "Faces in triangles",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""A plane underlies a triangle $t_a$, $t_b$, $t_c$, whose corners move as $v = v_q + s
    v_p$; scales are solved for from equal expressions in $s$.""",
    right=r"""As the plane of three corners this is right for every facet. But an ee-facet is a
    parallelogram, and must not be cut into triangles: its diagonal has the direction $s d_p + d_q$,
    and the events of diagonals are of degree 2 with an S- or T-edge and 3 with another diagonal.
    Their scales are irrational in general, such as the positive root of $17 s^2 + 24 s - 5$, and
    nothing changes there.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """The degrees by computer algebra. A parallelogram that an edge pierces from 5/109 to 5/24: its
    diagonal meets the edge at a root of the polynomial above, by the symbolic oracle, whose
    discriminant is no square. For two diagonals a cubic in which none of the possible rational
    roots is one."""
    for kind in EDGES:
        a = edge(kind, "a")
        start, along = diagonal("b")
        det = determinant(a.along[0], along, start - a.start)
        shown.equal(
            f"degree of the event of a diagonal and an edge of the kind {kind}", degree(det), 2
        )
    (a0, da), (b0, db) = diagonal("a"), diagonal("b")
    shown.equal("of two diagonals", degree(determinant(da, db, b0 - a0)), 3)
    flat = facet("ee", [(-1, 0, 0), (-1, 17, 1)], [(0, -1, 0), (5, 23, 2)])
    upright = t_edge(ORIGIN, (0, 0, 1), ORIGIN)
    around = flat.vertices
    cut = Edge("D", around[0], around[2])
    polynomial = [abs(c) for c in paper_space.lines_polynomial(cut.numbers, upright.numbers)]
    shown.equal(
        "the polynomial of the upright edge and the diagonal, signs aside", polynomial, [17, 24, 5]
    )
    x = sp.Symbol("x")
    found = sp.Poly(17 * x**2 + 24 * x - 5, x)
    discriminant = int(found.discriminant())
    shown.equal("its discriminant", discriminant, 916)
    shown.true("916 is no square", isqrt(discriminant) ** 2 != discriminant)
    low, high = Fraction(5, 109), Fraction(5, 24)
    shown.true(
        "it changes sign between 5/109 and 5/24",
        found.eval(sp.Rational(5, 109)) < 0 < found.eval(sp.Rational(5, 24)),
    )
    events = sorted(
        bound
        for side in flat.edges
        for bound in set(paper_space.edge_contact(side.numbers, upright.numbers) or ())
        if bound is not None
    )
    shown.equal("events of the edge and the parallelogram itself", events, [low, high])
    cubic = _cubic()
    shown.equal("coefficients for two diagonals, of a cubic", cubic, [3, 2, 0, -3])
    rational = [Fraction(n, d) for n in (1, 3, -1, -3) for d in (1, 3)]
    shown.true(
        "none of 1, 3, 1/3 and their negatives is a root",
        all(_value(cubic, each) for each in rational),
    )
    shown.true(
        "it changes sign between 4/5 and 1",
        _value(cubic, Fraction(4, 5)) < 0 < _value(cubic, Fraction(1)),
    )
    middle = (low + high) / 2
    shown.draw(
        "the parallelogram in two triangles, and the edge, half way between its events: from "
        "above, sheared by $y - 24 x / 5$",
        plan_picture(
            [_sheared(flat.corners(middle)), _sheared(cut.at(middle))],
            (0.0, 0.0),
            "a parallelogram",
        ),
    )


def _sheared(corners: Sequence[Vector]) -> list[tuple[float, float]]:
    return [(float(x), float(y - Fraction(24, 5) * x)) for x, y, _ in corners]


def _cubic() -> list[Fraction]:
    """Highest coefficient positive."""
    a, b = (
        Edge("D", Vertex(vector(p), vector(q)), Vertex(vector(r), vector(t)))
        for p, q, r, t in (
            ((1, 2, 1), (0, 2, 1), (0, 0, 1), (-2, -2, 0)),
            ((1, 0, 2), (-1, 2, 0), (-1, -1, -1), (0, -1, 1)),
        )
    )
    found = paper_space.lines_polynomial(a.numbers, b.numbers)
    return found if found[0] > 0 else [-c for c in found]


def _value(polynomial: list[Fraction], x: Fraction) -> Fraction:
    total = Fraction(0)
    for coefficient in polynomial:
        total = total * x + coefficient
    return total


def _level(kind: str, at: tuple[int, int], corners: list[tuple[int, int]]) -> Facet:
    """In the plane z = slope s + constant, for `at` = (slope, constant)."""
    slope, constant = at
    if kind == "vf":
        return facet("vf", [(0, 0, slope)], [(x, y, constant) for x, y in corners])
    return facet("fv", [(x, y, slope) for x, y in corners], [(0, 0, constant)])


@CHAPTER.entry(
    "parallel-faces",
    "Parallel faces",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""For parallel faces that are not always coplanar the scale at which they are is
    found, and edges are checked at that scale; two coplanar faces may meet without any vertex
    contact (Figure 4).""",
    right=r"""There is one such scale, $s = -n \cdot \Delta q / n \cdot \Delta p$, if $n \cdot
    \Delta p \ne 0$ and the quotient is negative, and none otherwise. Contacts of edges alone do
    occur, as in the figure; that one face may hold the other the vertices see.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """Level facets that rise with the scale or not, by the symbolic oracle: coplanar once, never,
    at a negative scale only, or always. The two triangles of a six-pointed star, which have six
    contacts of edges at one scale and none of a vertex; a triangle inside another one, whose
    vertices are in contact."""
    large, turned = [(0, 3), (-3, -2), (3, -2)], [(0, -3), (3, 2), (-3, 2)]
    still = _level("vf", (0, 4), large)
    for words, moves, wanted in (
        ("rises with $s$", (1, 0), ("once", 4, True)),
        ("rises with $s$, from above", (1, 9), ("never", None, None)),
        ("stands still elsewhere", (0, 1), ("never", None, None)),
        ("stands still beside it", (0, 4), ("always", None, None)),
    ):
        told = paper_space.plane_event(_level("vf", moves, turned).numbers, still.numbers)
        shown.equal(f"a facet that {words}, and one that stands still", told, wanted)
    star_of = _level("vf", (1, 0), turned)
    events = events_of_facets(star_of, still)
    shown.equal(
        "six-pointed star: scales of edge events", sorted(set(events["edge"])), [Fraction(4)]
    )
    shown.equal("pairs of edges in contact", len(events["edge"]) // 2, 6)
    shown.equal("vertex events", len(events["vertex"]), 0)
    at = Fraction(4)
    shown.draw(
        "the star at the scale 4",
        facets_picture([star_of.corners(at)], [still.corners(at)], "two triangles"),
    )
    inner = _level("vf", (1, 0), [(0, 1), (-1, -1), (1, -1)])
    events = events_of_facets(inner, still)
    shown.equal(
        "a triangle inside: vertex events, edge events",
        (len(events["vertex"]), len(events["edge"])),
        (3, 0),
    )


@CHAPTER.entry(
    "vertex-events-of-parallel-faces",
    "Vertex events of parallel faces need no special case",
    place="Section 5.2",
    status=Status.FALSE,
    printed=r"""The detection of vertex events is robust enough for parallel faces, and gives the
    scale at which they are coplanar.""",
    right=r"""As printed in Section 5.1 it starts with $x(1)$ and $x(2)$, the points in which the
    line of an edge meets the plane of the face, and for parallel faces there are none. The one
    equation $n \cdot (e_i(s) - t_a(s)) = 0$ does need no special case.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """Fifty random pairs of parallel facets: the denominator of $x(s)$ is zero for all their
    edges, and the equation of a vertex, by the symbolic oracle, has the scale at which the planes
    coincide."""
    dice = random.Random(SEED)
    zero = same = True
    once = 0
    for _ in range(50):
        ring = [(0, dice.randint(1, 5)), (-dice.randint(1, 5), 0), (dice.randint(1, 5), -1)]
        a, b = (
            _level(dice.choice(("fv", "vf")), (dice.randint(-3, 3), dice.randint(-3, 3)), ring)
            for _ in "ab"
        )
        for one, other in ((a, b), (b, a)):
            zero &= all(dot(other.normal, each.direction) == 0 for each in one.edges)
        case, at, _ = paper_space.plane_event(a.numbers, b.numbers)
        told = [paper_space.vertex_event(b.numbers, v.numbers)[:2] for v in a.vertices]
        same &= told == [(case, at)] * len(told)
        once += case == "once"
    shown.true("the denominator $n \\cdot d$ is zero for each edge of fifty pairs", zero)
    shown.true(f"each vertex has the scale of the planes, where there is one ({once} pairs)", same)


@CHAPTER.entry(
    "coplanar-faces",
    "Faces that are always coplanar",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""Both faces are transformed into the $xy$-plane, and the events of vertices are found
    as in the plane; edge events are impossible.""",
    right=r"""Contact does begin and end at a vertex. But the transformation must not be a rotation:
    that leaves the rational numbers. From the plane $x + y + z = 0$ no rotation into the $xy$-plane
    keeps all rational points rational, since $(1, 1, -2)$ has the squared length 6, which is no sum
    of two rational squares. Leaving out a coordinate whose axis is not parallel to the plane keeps
    contacts and numbers.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """For 6: if $a^2 + b^2 = 6 c^2$ then 3 divides all three, by all remainders modulo 9, so that
    there is no solution in lowest terms. For 40 pairs of facets in $x + y + z = 0$: the interval of
    contact by the symbolic oracle, and contact in space and of the projections at many scales; at
    its ends a vertex is on the other facet."""
    solutions = {
        (a % 3, b % 3, c % 3)
        for a, b, c in product(range(9), repeat=3)
        if (a * a + b * b - 6 * c * c) % 9 == 0
    }
    shown.equal(
        "remainders modulo 3 of $a$, $b$, $c$ in all solutions modulo 9",
        sorted(solutions),
        [(0, 0, 0)],
    )
    dice = random.Random(SEED)
    met = 0
    same = at_vertex = True
    for _ in range(40):
        a, b = (_in_plane(dice) for _ in "ab")
        intervals = paper_space.facet_contact(a.numbers, b.numbers)
        bounds = [bound for each in intervals for bound in each or () if bound is not None]
        for scale in (*bounds, *(Fraction(dice.randint(1, 40), 7) for _ in range(6))):
            inside = any(
                each is not None
                and (each[0] is None or each[0] <= scale)
                and (each[1] is None or scale <= each[1])
                for each in intervals
            )
            x, y = a.corners(scale), b.corners(scale)
            shadows = ([vector([p[0], p[1], 0]) for p in ring] for ring in (x, y))
            same &= polygons_meet(x, y) == polygons_meet(*shadows) == inside
        events = _coplanar_vertex_events(a, b)
        at_vertex &= set(bounds) <= events
        met += bool(intervals)
    shown.true(
        f"40 pairs, of which {met} meet: contact in space and in projection is the oracle's",
        same and met > 20,
    )
    shown.true("contact begins and ends where a vertex is on the boundary of the other", at_vertex)


def _in_plane(dice: random.Random) -> Facet:
    """In x + y + z = 0."""
    while True:
        points = [(dice.randint(-3, 3), dice.randint(-3, 3)) for _ in range(4)]
        whole = [(x, y, -x - y) for x, y in points]
        kind = dice.choice(tuple(FACETS))
        cut = {"fv": 3, "vf": 1, "ee": 2}[kind]
        found = facet(kind, whole[:cut], whole[cut:])
        if any(found.normal):
            return found


def _coplanar_vertex_events(a: Facet, b: Facet) -> set[Fraction]:
    """Scales at which a vertex of one is on the line of a side of the other and on that side."""
    found = set()
    for one, other in ((a, b), (b, a)):
        for v, side in product(one.vertices, other.edges):
            d, w = side.direction, side.start
            slope = cross(d, minus(v.p, w.p))[2]
            constant = cross(d, minus(v.q, w.q))[2]
            for scale in _candidates(slope, constant, v, side):
                if scale > 0 and segments_meet(v.at(scale), v.at(scale), *side.at(scale)):
                    found.add(scale)
    return found


def _candidates(slope: Fraction, constant: Fraction, v: Vertex, side: Edge) -> list[Fraction]:
    """Of a vertex and a line in x + y + z = 0; for a vertex that runs along the line at all scales
    those at which it is at an end of the side."""
    if slope:
        return [-constant / slope]
    if constant:
        return []
    found = []
    for end in (side.start, side.end):
        p, q = minus(v.p, end.p), minus(v.q, end.q)
        k = next((k for k in range(3) if p[k]), None)
        if k is not None:
            found.append(-q[k] / p[k])
    return found


@CHAPTER.entry(
    "four-facets",
    "Four facets through one point",
    place="Sections 3 and 5",
    status=Status.INCOMPLETE,
    printed=r"""In space events are defined by the contact of two faces, and the structure changes
    at them only.""",
    right=r"""It also changes where four facets come to pass through one point, as three edges do in
    the plane: voids of the sum begin and end there. The condition is a determinant of four planes
    $n_i \cdot x = s \alpha_i + \beta_i$, linear in $s$.""",
    code=(*ORACLE, "reference/plane/dynamic/triple_events.hpp"),
)
def _(shown: Shown) -> None:
    """A tetrahedron and a cube with a tetrahedral cavity. The void of the sum ends at 1: by the
    definition, and since a sum of the four conditions of the void with positive weights is zero
    there. All events of vertices and edges of the 26 facets of their convolution, by the symbolic
    oracle, are elsewhere. By computer algebra the determinant is linear."""
    rows = [[*place(name), s * sp.Symbol(f"a_{name}") + sp.Symbol(f"b_{name}")] for name in "klmn"]
    shown.equal("degree of the determinant", degree(sp.Matrix(rows).det(method="berkowitz")), 1)
    one = Fraction(1)
    inner, outer = cavity.inner_facets(), cavity.outer_facets()
    shown.equal(
        "four facets around the void, by the symbolic oracle",
        paper_space.four_event([each.numbers for each in inner]),
        ("once", one, True),
    )
    events = cavity.pair_events([*inner, *outer])
    shown.equal(
        f"scales of all pair events of {len(inner) + len(outer)} facets",
        sorted(events),
        [Fraction(4, 3), Fraction(2)],
    )
    before, after = Fraction(49, 50), Fraction(51, 50)
    for scale in (before, after):
        corners = cavity.corners(scale)
        centre = vector([sum((p[k] for p in corners), Fraction(0)) / 4 for k in range(3)])
        shown.equal(
            f"centre of the four planes in the sum at {scale}",
            cavity.in_sum(scale, centre),
            scale > 1,
        )
        shown.true(
            f"weighted sum of the conditions at {scale}: {cavity.slack(scale)}",
            (cavity.slack(scale) > 0) == (scale < 1),
        )
    shown.equal("at 1", cavity.slack(one), 0)
    x = cavity.corners(one)[0]
    fitted = cavity.P.polyhedron.reflected(x)
    shown.draw(
        "the cavity, and $x - P$ inside it at the scale 1, which it just fits",
        solids_picture(
            [(fitted, "first"), (cavity.CAVITY.polyhedron, "wire")],
            "a tetrahedron in a tetrahedral cavity",
        ),
    )


@CHAPTER.entry(
    "event-space",
    "The number of events",
    place="Sections 6 and 9",
    status=Status.CONDITION,
    printed=r"""The worst-case complexity of the event space is $O(m^4 n^4)$.""",
    right=r"""The events of Section 5 are those of pairs of the $N = O(m n)$ facets of the
    convolution, of a pair at most as many as it has pairs of vertices, edges and facets. For
    triangles and parallelograms that is a constant, and the whole is $O(N^2) = O(m^2 n^2)$. $N^4 =
    m^4 n^4$ is the order of the events of four facets, which the paper does not compute.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """Seven large triangles that move through each other: every four of them have a scale of their
    own, by the symbolic oracle, at which they meet in a point. Pairs of them have no more events
    than the 6 vertices with the other triangle and the 9 pairs of edges give."""
    facets = _crossing(7)
    told = [paper_space.four_event([f.numbers for f in four]) for four in combinations(facets, 4)]
    scales = {at for _, at, meet in told if at is not None and at > 0 and meet}
    shown.equal("seven facets: choices of four", len(told), comb(7, 4))
    shown.equal("different scales at which four of them meet in a point", len(scales), comb(7, 4))
    pairs = [events_of_facets(a, b) for a, b in combinations(facets, 2)]
    most = max(len({*each["vertex"], *each["edge"]}) for each in pairs)
    shown.true(f"events of a pair of them: at most {most}", most <= 6 + 9)
    for n in (10, 100, 1000):
        shown.tell(
            f"{n:,} triangles: {15 * comb(n, 2):,} events of pairs at most, "
            f"{comb(n, 4):,} choices of four."
        )


def _crossing(count: int) -> list[Facet]:
    """Triangles of a vertex of P and a facet of Q, whose planes pass near the origin at 10."""
    dice = random.Random(SEED)
    found: list[Facet] = []
    while len(found) < count:
        u, v, p, q = ([dice.randint(-20, 20) for _ in "xyz"] for _ in range(4))
        base = [10 * (-10 * p[k]) + q[k] for k in range(3)]
        n = cross(vector(u), vector(v))
        if not any(n) or dot(n, vector(p)) == 0:
            continue
        far = 1000
        corners = [
            [base[k] + far * (a * u[k] + b * v[k]) for k in range(3)]
            for a, b in ((1, 1), (-2, 1), (1, -2))
        ]
        found.append(Facet("vf", (vector([10 * x for x in p]),), tuple(vector(c) for c in corners)))
    return found


def _is_reflex(solid: Polyhedron, i: int, j: int) -> bool:
    """Whether the interior angle at an edge is above 180 degrees."""
    faces = {pair: face for face in solid.faces for pair in pairwise((*face, face[0]))}
    n, m = (vector(area_vector([solid.wholes[k] for k in faces[e]])) for e in ((i, j), (j, i)))
    into = cross(m, minus(solid.vertices[i], solid.vertices[j]))  # from the edge, in the other face
    return dot(n, into) > 0


def _edges(solid: Polyhedron) -> list[tuple[int, int]]:
    return [(i, j) for f in solid.faces for i, j in pairwise((*f, f[0])) if i < j]


@CHAPTER.entry(
    "reflex-edges",
    "Reflex edges, and vertices at them",
    place="Section 3",
    status=Status.CONDITION,
    printed=r"""In space the contributions of reflex edges are left out; they are interior to the
    sum. A facet is compatible with a vertex if its normal is in the region of the Gaussian map that
    the normals of the facets at the vertex enclose.""",
    right=r"""It is right for ee-facets: near a reflex edge there is more than a half-space, and
    with an edge of the other operand that is not parallel it gives a neighbourhood. A vertex at
    which only some edges are reflex must stay: a plane may support it. There the enclosed region is
    no simple one, and the test is $n \cdot (w - v) \le 0$ for all edges $v w$.""",
)
def _(shown: Shown) -> None:
    """Forty pairs of a body with reflex edges and a tetrahedron: the middles of ee-facets with a
    reflex edge, whether compatible or not, are inside the sum, by the definition. Then a pyramid
    over an arrowhead and a cube: the top of the sum is the top of the cube at the apex, one of
    whose edges is reflex, and nothing else of the convolution is as high."""
    dice = random.Random(SEED)
    count = inside = 0
    tetrahedron = hull([(0, 0, 0), (3, 1, 0), (-1, 2, 1), (1, 0, 4)]).polyhedron
    for _ in range(40):
        body = star(dice, 5, 4)
        reflex = [pair for pair in _edges(body) if _is_reflex(body, *pair)]
        meeting = Meeting(body, tetrahedron, Fraction(1))
        for pair in dice.sample(reflex, min(2, len(reflex))):
            other = dice.choice(_edges(tetrahedron))
            ends = [body.vertices[k] for k in pair], [tetrahedron.vertices[k] for k in other]
            if not any(cross(minus(*ends[0]), minus(*ends[1]))):
                continue
            x = vector(
                [sum((e[k] for two in ends for e in two), Fraction(0)) / 2 for k in range(3)]
            )
            count += 1
            inside += meeting.decide(x).contact == "overlap"
    shown.true(f"{count} ee-facets of reflex edges: all middles inside", 40 < count == inside)
    base = [(4, 0, 0), (-4, 4, 0), (-1, 0, 0), (-4, -4, 0), (0, 0, 3)]
    pyramid = Polyhedron(
        tuple(vector(p) for p in base), ((3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))
    )
    shown.equal(
        "reflex edges of the pyramid",
        [pair for pair in _edges(pyramid) if _is_reflex(pyramid, *pair)],
        [(2, 4)],
    )
    apex = pyramid.vertices[4]
    shown.true(
        "the level plane supports the apex", all(v[2] < apex[2] for v in pyramid.vertices[:4])
    )
    cube = hull([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]).polyhedron
    x = vector((Fraction(1, 2), Fraction(1, 2), 4))
    shown.equal(
        "contact of the cube and $x - Q$ for $x = (1/2, 1/2, 4)$, at its top and the apex",
        Meeting(cube, pyramid, Fraction(1)).decide(x).contact,
        "touch",
    )
    shown.equal(
        "height of all that does without the apex",
        max(v[2] for v in pyramid.vertices[:4]) + max(v[2] for v in cube.vertices),
        1,
    )
    shown.draw(
        "the pyramid, its apex, and the reflex edge at it",
        solids_picture(
            [(pyramid, "second")],
            "a pyramid over an arrowhead",
            apex,
            [(pyramid.vertices[2], apex)],
        ),
    )
