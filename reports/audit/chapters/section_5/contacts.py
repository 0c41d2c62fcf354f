"""Facet contacts and vertex events."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise, product

from minkref import _core
from minkref.fuzz.geometry.space import cross, dot, minus
from minkref.fuzz.judges.space import paper_space
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import pair_of_family
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import (
    Edge,
    Vertex,
    drawn,
    events_of_facets,
    facet,
    polygons_meet,
    t_edge,
    vector,
)
from minkref.reports.audit.space_pictures import facets_picture
from minkref.reports.audit.symbolic_space import EDGES, FACETS, Flat, edge, place, s
from minkref.reports.audit.symbolic_space import facet as symbolic_facet

PART = Chapter("section-5", "Section 5: uniform scaling in space")
SEED = 5
ORACLE = ("oracle/symbolic/space/space_events.py", "oracle/symbolic/space/derive_space.py")
ORIGIN = (0, 0, 0)


def _flats(kinds: tuple[str, str]) -> tuple[Flat, Flat]:
    """An edge and a facet, all symbols."""
    return edge(kinds[0], "e"), symbolic_facet(kinds[1], "f")


@PART.entry(
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


@PART.entry(
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
        shown.identity(f"normal of a facet $f$ of the kind {kind}, $s^{flat.power}$ aside", gap)
    n = place("n")
    for kind in EDGES:
        line, p, q = edge(kind, "e"), place("p"), place("q")
        d = line.along[0]
        x = line.start + d * n.dot(s * p + q - line.start) / n.dot(d)
        shown.identity(f"{kind}-edges: the second derivative of $x(s)$", x.diff(s, 2))
        shown.identity(
            f"{kind}-edges: $n \\cdot x(s)$ is the plane's offset", n.dot(x) - n.dot(s * p + q)
        )


def _in_arithmetics(shown: Shown) -> None:
    """Counts solvable systems that each arithmetic calls inconsistent."""
    pair = pair_of_family("mixed", 1, 0)
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
    for arithmetic in ("rational", "double", "mpfr:53", "mpfr:200"):
        told = dict(_core.facet_contact_trial(P, Q, arithmetic))
        wrong = told["false_inconsistent"]
        shown.true(
            f"{arithmetic}: {wrong:,} of {told['roots']:,} systems with a solution are called "
            f"inconsistent, by `minkref events --form printed --arithmetic {arithmetic}`",
            (wrong == 0) == (arithmetic == "rational"),
        )


@PART.entry(
    "overdetermined-in-space",
    "No vertex event where edges are parallel or skew",
    place="Section 5.1",
    status=Status.FALSE,
    printed=r"""$x(s) = e_i(s)$ are three equations with one unknown; there may be no solution,
    which is so when the edges are parallel or skew.""",
    right=r"""$x(s)$ and $e_i(s)$ both lie on the line of the edge, so it is one linear equation: $n
    \cdot (e_i(s) - t_a(s)) = 0$, with the normal $n$ of the face and a corner $t_a$ of it. It has
    no solution only if its slope is zero and its constant is not. Skew edges are no exception but
    the rule: where a vertex comes to the inside of a face, its edge, if it is not in the plane of
    the face, is skew to all edges of a convex face. (Read of the paths of $x(s)$ and $e_i(s)$ the
    remark fails as well: they are in one plane, for the difference of both points has the direction
    of the edge, so that they are never skew.) Over rounded numbers the three equations seldom
    agree, at any precision.""",
    code=(*ORACLE, "reference/paper/space/facet_contacts.hpp"),
)
def _(shown: Shown) -> None:
    """By computer algebra $(x(s) - e_0(s)) \\times d = 0$ whatever $n$ is. One event inside a
    triangle, by the symbolic oracle, whose edge is skew to all three sides. Then 300 random
    vertices and facets: whether and where there is a solution goes by slope and constant. The
    text followed to the letter, on all pairs of facets of two polyhedra, in four arithmetics."""
    _in_arithmetics(shown)
    n, line, corner = place("n"), edge("S", "e"), place("p") * s + place("q")
    d = line.along[0]
    x = line.start + d * n.dot(corner - line.start) / n.dot(d)
    shown.identity(r"$(x(s) - e_0(s)) \times d$", (x - line.start).cross(d))
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
