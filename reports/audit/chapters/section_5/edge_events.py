"""Edge events."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from math import isqrt

import sympy as sp
from minkref.fuzz.geometry.space import cross, dot, minus
from minkref.fuzz.judges.space import paper_space
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import pair_of_family
from minkref.reports.audit.entry import Chapter, Shown, Status, text
from minkref.reports.audit.facet_code import contacts_as_read
from minkref.reports.audit.space import (
    Edge,
    Vector,
    Vertex,
    events_of_facets,
    facet,
    polygons_meet,
    s_edge,
    segments_meet,
    t_edge,
    vector,
)
from minkref.reports.audit.space_pictures import facets_picture, plan_picture
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

PART = Chapter("section-5", "Section 5: uniform scaling in space")
SEED = 5
ORACLE = ("oracle/symbolic/space/space_events.py", "oracle/symbolic/space/derive_space.py")
ORIGIN = (0, 0, 0)
KINDS = tuple(product(EDGES, FACETS))


def _flats(kinds: tuple[str, str]) -> tuple[Flat, Flat]:
    """An edge and a facet, all symbols."""
    return edge(kinds[0], "e"), symbolic_facet(kinds[1], "f")


@PART.entry(
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
    shown.true(
        f"an example: without transposition $(t, u, v)$ is {text(one)}, with it {text(other)}",
        one != other,
    )
    for kinds in KINDS:
        line, plane = _flats(kinds)
        k = line.power + plane.power
        det = determinant(-line.spans[0], *plane.spans)
        shown.identity(
            rf"{kinds[0]}-edge and {kinds[1]}-facet: $\det M$ and $s^{k}$ times its value"
            " at 1",
            det - s**k * det.subs(s, 1),
        )


@PART.entry(
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


@PART.entry(
    "singular-systems",
    "The system is singular for other faces than parallel ones",
    place="Section 5.2",
    status=Status.INCOMPLETE,
    printed=r"""If the faces are parallel the matrix is singular, and edge events are not found in
    the usual way; such faces are treated by themselves.""",
    right=r"""It is singular wherever $l_1$ is parallel to $p_2$, and so for parallel edges. Faces
    need not be parallel for that: a face that comes down on another one along an edge has edge
    events, no vertex event, and no $x_1$. The determinant of the two lines finds them.""",
    code=(*ORACLE, "reference/paper/space/facet_contacts.hpp"),
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
    pair = pair_of_family("mixed", 1, 0)
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
    printed = contacts_as_read(P, Q, corner="lines", crossing="points")
    right = contacts_as_read(P, Q)
    singular = {
        "of parallel faces": printed["parallel_faces"],
        "of parallel edges": printed["parallel_sides"],
        "with an edge along the plane": printed["side_along_plane"],
    }
    shown.true(
        "two polyhedra, in rational numbers, by `minkref events --reading corner=lines --reading "
        f"crossing=points`: of {printed['events']} events {printed['missed']} are missed, where "
        "the matrix is singular: "
        + ", ".join(f"{number} {what}" for what, number in singular.items()),
        printed["missed"] == sum(singular.values()) > 0,
    )
    shown.equal("missed where edges in one plane are one equation", right["missed"], 0)
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


@PART.entry(
    "inside-both",
    "Edge events have to be inside both edges",
    place="Section 5.2",
    status=Status.INCOMPLETE,
    printed=r"""To find edge events the expressions for $x_1$ and $x_2$ are set equal and solved for
    $s$. (Of vertex events it is said that they are checked to be in the face; of these
    nothing.)""",
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


@PART.entry(
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
