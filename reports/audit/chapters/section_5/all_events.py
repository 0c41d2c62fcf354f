"""Further statements: events of four facets, event counts, reflex edges."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import combinations, pairwise
from math import comb

import sympy as sp
from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import area_vector, cross, dot, minus
from minkref.fuzz.judges.space import paper_space
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.generators.star import star
from minkref.fuzz.space.meeting import Meeting
from minkref.reports.audit import cavity
from minkref.reports.audit.bodies import hull
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import Facet, events_of_facets, vector
from minkref.reports.audit.space_pictures import solids_picture
from minkref.reports.audit.symbolic_space import Flat, degree, edge, place, s
from minkref.reports.audit.symbolic_space import facet as symbolic_facet

PART = Chapter("section-5", "Section 5: uniform scaling in space")
SEED = 5
ORACLE = ("oracle/symbolic/space/space_events.py", "oracle/symbolic/space/derive_space.py")


def _flats(kinds: tuple[str, str]) -> tuple[Flat, Flat]:
    """An edge and a facet, all symbols."""
    return edge(kinds[0], "e"), symbolic_facet(kinds[1], "f")


@PART.entry(
    "four-facets",
    "Four facets through one point",
    place="Sections 3 and 5",
    status=Status.INCOMPLETE,
    printed=r"""The structure of the arrangement changes only at critical scales (Section 3); in
    space events are defined by the contact of two faces (Section 5).""",
    right=r"""It also changes where four facets come to pass through one point, as three edges do in
    the plane: voids of the sum begin and end there. The condition is a determinant of four planes
    $n_i \cdot x = s \alpha_i + \beta_i$, linear in $s$.""",
    code=(*ORACLE, "reference/space/critical/concurrent_facets.hpp"),
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
    P, Q = map(core_polyhedron, (cavity.P.polyhedron, cavity.Q()))
    listed = _core.space_events(P, Q, "1/10", "10", concurrent=True)
    shown.equal(
        "scales of the pair events of the polyhedra from 1/10 to 10, by `minkref events`",
        sorted({Fraction(row[0]) for row in listed.rows(0, len(listed))}),
        [Fraction(4, 3), Fraction(2)],
    )
    shown.equal(
        "of those of three and four facets, two of which may share a side (`--kind triple`)",
        sorted({Fraction(row[0]) for row in listed.concurrent(0, 100)}),
        [one],
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


@PART.entry(
    "event-space",
    "The number of events",
    place="Sections 6 and 9",
    status=Status.CONDITION,
    printed=r"""The worst-case complexity of the event space is $O(m^4 n^4)$.""",
    right=r"""As an upper bound it holds, but the event space of the paper is smaller. The events of
    Section 5 are those of pairs of the $N = O(m n)$ facets of the convolution, of a pair at most as
    many as it has pairs of vertices, edges and facets. For triangles and parallelograms that is a
    constant, and the whole is $O(N^2) = O(m^2 n^2)$. $N^4 = m^4 n^4$ is the order of the events of
    four facets, which the paper does not compute.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """Seven large triangles of the kind vf, not those of one sum, that move through each other:
    every four of them have a scale of their own, by the symbolic oracle, at which they meet in a
    point. Pairs of them have no more events than the 6 vertices with the other triangle and the 9
    pairs of edges give."""
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
    """Triangles from a vertex of P and a facet of Q each, whose planes pass near the origin at
    scale 10."""
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


@PART.entry(
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
