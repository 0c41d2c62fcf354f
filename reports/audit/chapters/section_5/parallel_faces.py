"""Parallel or coplanar faces."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

from minkref import _core
from minkref.fuzz.geometry.space import cross, dot, minus
from minkref.fuzz.judges.space import paper_space
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import pair_of_family
from minkref.reports.audit.bodies import hull
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.facet_code import contacts_as_read
from minkref.reports.audit.space import (
    Edge,
    Facet,
    Vertex,
    events_of_facets,
    facet,
    polygons_meet,
    segments_meet,
    vector,
)
from minkref.reports.audit.space_pictures import facets_picture
from minkref.reports.audit.symbolic_space import FACETS, Flat, edge
from minkref.reports.audit.symbolic_space import facet as symbolic_facet

PART = Chapter("section-5", "Section 5: uniform scaling in space")
SEED = 5
ORACLE = ("oracle/symbolic/space/space_events.py", "oracle/symbolic/space/derive_space.py")


def _flats(kinds: tuple[str, str]) -> tuple[Flat, Flat]:
    """An edge and a facet, all symbols."""
    return edge(kinds[0], "e"), symbolic_facet(kinds[1], "f")


def _level(kind: str, at: tuple[int, int], corners: list[tuple[int, int]]) -> Facet:
    """In the plane z = slope s + constant, for `at` = (slope, constant)."""
    slope, constant = at
    if kind == "vf":
        return facet("vf", [(0, 0, slope)], [(x, y, constant) for x, y in corners])
    return facet("fv", [(x, y, slope) for x, y in corners], [(0, 0, constant)])


@PART.entry(
    "parallel-faces",
    "Parallel faces",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""For parallel faces that are not always coplanar the scale at which they are is
    found, and edges are checked at that scale; two coplanar faces may meet without any vertex
    contact (Figure 4).""",
    right=r"""With $n$ the normal and $\Delta p$, $\Delta q$ from a vertex of one to a vertex of the
    other, there is one such scale $s = -(n \cdot \Delta q) / (n \cdot \Delta p)$ if this is defined
    and positive, and none otherwise. Contacts of edges alone do occur, as in the figure; where one
    face holds the other, its vertices are in contact.""",
    code=(*ORACLE, "reference/space/critical/parallel_facets.hpp"),
)
def _(shown: Shown) -> None:
    """Level facets that rise with the scale or not, by the symbolic oracle: coplanar once, never,
    at a negative scale only, or always. The two triangles of a six-pointed star, which have six
    contacts of edges at one scale and none of a vertex; two long triangles across each other, in
    the reference's list of events of two polyhedra; a triangle inside another one, whose vertices
    are in contact."""
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
    _the_code_sees(shown)
    inner = _level("vf", (1, 0), [(0, 1), (-1, -1), (1, -1)])
    events = events_of_facets(inner, still)
    shown.equal(
        "a triangle inside: vertex events, edge events",
        (len(events["vertex"]), len(events["edge"])),
        (3, 0),
    )


def _the_code_sees(shown: Shown) -> None:
    """Two bodies per operand: one below a long triangle, and one whose top carries the other
    operand's triangle."""
    bodies = (
        ([(-9, 0, 0), (9, -1, 0), (9, 1, 0)], [(33, -1, 0), (37, -2, 0), (35, 2, -1)]),
        ([(0, -9, 0), (1, 9, 0), (-1, 9, 0)], [(32, -1, 0), (37, -3, -1), (36, 2, -1)]),
    )
    P, Q = (
        core_polyhedron(
            hull([*triangle, (0, 0, -3)]).polyhedron.with_faces_of(
                hull([*base, (35, 0, 2)]).polyhedron
            )
        )
        for triangle, base in bodies
    )
    found = _core.space_events(P, Q, "1/2", "2")
    rows = [row for row in found.rows(0, len(found)) if row[1] == "parallel"]
    shown.equal(
        "long triangles on two polyhedra: parallel events, by `minkref events`",
        [(row[0], row[2]) for row in rows],
        [("1", "touch")],
    )
    corners = [row[k] for row in rows for k in (4, 6) if row[k] is not None]
    shown.equal("corners of one triangle in the other", corners, [])


@PART.entry(
    "vertex-events-of-parallel-faces",
    "Vertex events of parallel faces need no special case",
    place="Section 5.2",
    status=Status.LITERAL,
    printed=r"""The detection of vertex events is robust enough for parallel faces, and gives the
    scale at which they are coplanar.""",
    right=r"""As printed in Section 5.1 it starts with $x(1)$ and $x(2)$, the points in which the
    line of an edge meets the plane of the face, and for parallel faces there are none. The one
    equation $n \cdot (e_i(s) - t_a(s)) = 0$ does need no special case.""",
    reading=r"""Take the path of the vertex itself to the plane of the other face, without $x(1)$
    and $x(2)$: then parallel faces are no special case.""",
    code=(*ORACLE, "reference/paper/space/facet_contacts.hpp"),
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
        scales = [paper_space.vertex_event(b.numbers, v.numbers)[:2] for v in a.vertices]
        same &= scales == [(case, at)] * len(scales)
        once += case == "once"
    pair = pair_of_family("mixed", 1, 0)
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q)
    told = contacts_as_read(P, Q, corner="lines")
    shown.true(
        "two polyhedra, in rational numbers, by `minkref events --reading corner=lines`: "
        f"{told['missed']} events are missed, all of them of parallel faces",
        told["missed"] == told["parallel_faces"] > 0,
    )
    shown.true("the denominator $n \\cdot d$ is zero for each edge of fifty pairs", zero)
    shown.true(f"each vertex has the scale of the planes, where there is one ({once} pairs)", same)


@PART.entry(
    "coplanar-faces",
    "Faces that are always coplanar",
    place="Section 5.2",
    status=Status.CONDITION,
    printed=r"""Both faces are transformed into the $xy$-plane, and the events of vertices are found
    as in the plane; edge events are impossible.""",
    right=r"""Contact does begin and end at a vertex. But in exact numbers the transformation must
    not be a rotation: that leaves the rational ones. From the plane $x + y + z = 0$ no rotation
    into the $xy$-plane keeps all rational points rational, since $(1, 1, -2)$ has the squared
    length 6, which is no sum of two rational squares. Leaving out a coordinate whose axis is not
    parallel to the plane keeps contacts and numbers.""",
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
    """Scales at which a vertex of one facet lies on a side of the other facet."""
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
    """Candidate scales for a vertex and a line in x + y + z = 0; if the vertex runs along the line
    at all scales, the scales at which the vertex meets an end of the side."""
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
