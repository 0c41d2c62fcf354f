"""Face-vertex pairs, chains of edges, and the boundary."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

from minkref.fuzz.space.hull import sum_of_convex
from minkref.reports.audit.bodies import (
    Body,
    Edge,
    Pairs,
    compatible_pairs,
    cross,
    drawn_body,
    drawn_scaling,
    facet_pairs,
    hull,
    minus,
    random_body,
    support,
)
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import Vector, vector
from minkref.reports.audit.space_pictures import solids_picture

PART = Chapter("section-6", "Section 6: convex polyhedra under non-uniform scaling")
SEED = 6
OCTAHEDRON = hull([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)])
CUBE = hull([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


@PART.entry(
    "one-vertex-for-each-face",
    "Each face is paired with precisely one vertex",
    place="Section 6",
    status=Status.CONDITION,
    printed=r"""For convex pairs each face of $P$ is paired with precisely one vertex of $Q$, and
    the other way round; errors are found by this.""",
    right=r"""Only if no normal of a facet is orthogonal to an edge of the other operand that is
    farthest along it. Two boxes have four vertices for each facet, at every scaling along the axes.
    Then a facet of the sum may be the sum of a facet and an edge or of two facets, for which there
    is no rule in the text; or ties are broken by one fixed perturbation for both operands.""",
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
        fv, vf = facet_pairs(P, Q, drawn_scaling(dice))
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


@PART.entry(
    "chain-of-edges",
    "The edges that are compatible with an edge",
    place="Section 6",
    status=Status.MISPRINT,
    printed=r"""From the vertex of one facet at $e$ to that of the other one goes along compatible
    edges, ignoring the one just found; at the end all compatible vertices have been enumerated.""",
    right=r"""All compatible edges have been. The walk is right where no facet has several vertices:
    the vertices on the way are those of the regions that $g(e)$ runs through.""",
    formula="The chain of compatible edges (Section 6)",
)
def _(shown: Shown) -> None:
    """All edges of $P$ in 200 random pairs of bodies: at each vertex of the walk one edge leads on,
    and those found are all compatible ones, by supports."""
    dice = random.Random(SEED)
    walks = edges = 0
    right = True
    for _ in range(200):
        P, Q = drawn_body(dice), drawn_body(dice)
        pairs = compatible_pairs(P, Q)
        if not pairs.unique:
            continue
        for e, (left, beyond) in P.edges.items():
            found = _chain(Q, e, pairs.ee, min(pairs.fv[left]), min(pairs.fv[beyond]))
            right &= sorted(found) == sorted(g for own, g in pairs.ee if own == e)
            walks += 1
            edges += len(found)
    shown.true(f"{walks:,} walks find all {edges:,} compatible edges", right and edges > 1000)


@PART.entry(
    "cost-of-a-chain",
    "The cost of a chain",
    place="Section 6",
    status=Status.HOLDS,
    printed=r"""“The complexity of this update is O(|E|), where E is the set of edges incident to at
    least one vertex in the path”.""",
    right=r"""So it is for one chain: at each vertex of the path the incident edges are looked at
    once, and an edge has two ends, so that at most $2 |E|$ are looked at. $|E|$ is no bound by the
    change: a vertex with many edges has all of them looked at for one edge that changes. And the
    text first checks all facets for errors, $O(m + n)$ of them, with the edges at their
    vertices.""",
)
def _(shown: Shown) -> None:
    """All edges of $P$ in 200 random pairs of bodies: the edges that the walk looks at, vertex by
    vertex, against the edges incident to a vertex of the path."""
    dice = random.Random(SEED)
    walks = looked = incident = 0
    within = True
    for _ in range(200):
        P, Q = drawn_body(dice), drawn_body(dice)
        pairs = compatible_pairs(P, Q)
        if not pairs.unique:
            continue
        for e, (left, beyond) in P.edges.items():
            first, last = min(pairs.fv[left]), min(pairs.fv[beyond])
            path = {first, last, *(v for g in _chain(Q, e, pairs.ee, first, last) for v in g)}
            of_path = sum(not path.isdisjoint(g) for g in Q.edges)
            tests = sum(len(Q.neighbours[v]) for v in path - {last})
            within &= tests <= 2 * of_path
            walks, looked, incident = walks + 1, looked + tests, incident + of_path
    shown.true(f"{walks:,} walks look at {looked:,} edges, of {incident:,} incident to their "
               "paths; none at more than twice its own", within and walks > 1000)  # fmt: skip


@PART.entry(
    "chain-through-a-normal",
    "An edge whose arc passes through the normal of a facet",
    place="Section 6",
    status=Status.INCOMPLETE,
    printed=r"""At each vertex the edge is found with which $e$ is compatible.""",
    right=r"""Where $g(e)$ passes through the normal of a facet $f$ of $Q$, so that $e$ and $f$ are
    farthest in one direction, there is none in the strict sense, and two with ties. The sum has the
    face $e \oplus f$ there, which is neither an fv-facet nor an ee-facet.""",
    formula="The chain of compatible edges (Section 6)",
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
    """Whether both edges are farthest along some direction orthogonal to them, perhaps with other
    features."""
    n = cross(P.along(e), Q.along(g))
    return any(n) and any(
        support(P.points, way) >= set(e) and support(Q.points, way) >= set(g)
        for way in (n, minus((0, 0, 0), n))
    )


@PART.entry(
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
    """The hull of all sums of two vertices of 150 random pairs: its faces are the sums of the
    compatible pairs, vertex by vertex. Two boxes: the sum has 6 faces, the strict rule gives no
    facet, and the one with ties 48 of facets and vertices."""
    dice = random.Random(SEED)
    count = faces = 0
    same = True
    for _ in range(150):
        P, Q = drawn_body(dice), drawn_body(dice)
        pairs = compatible_pairs(P, Q)
        if not pairs.unique:
            continue
        total = sum_of_convex(P.polyhedron, Q.polyhedron, Fraction(1))
        found = {frozenset(total.vertices[k] for k in face) for face in total.faces}
        same &= found == _faces_of_pairs(P, Q, pairs) and len(found) == len(total.faces)
        count += 1
        faces += len(found)
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


def _faces_of_pairs(P: Body, Q: Body, pairs: Pairs) -> set[frozenset[Vector]]:
    """Vertex sets of the pairs' sums, for all compatible pairs."""
    rows = [
        *zip(P.facets, map(tuple, pairs.fv), strict=True),
        *zip(map(tuple, pairs.vf), Q.facets, strict=True),
        *pairs.ee,
    ]
    return {
        frozenset(
            vector([x + y for x, y in zip(P.points[i], Q.points[j], strict=True)])
            for i in of_P
            for j in of_Q
        )
        for of_P, of_Q in rows
    }


@PART.entry(
    "uniform-scaling-of-convex-bodies",
    "Uniform scaling of convex bodies",
    place="Section 7.2.2",
    status=Status.LITERAL,
    printed=r"""Scaling convex models uniformly makes their sums scale uniformly.""",
    right=r"""That is true where both models are scaled by one factor, and then of all sets. But the
    method scales one of them, and $s P \oplus Q$ is not $s (P \oplus Q)$: $2 [0, 1] \oplus [0, 1] =
    [0, 3]$, not $[0, 4]$. What stays is the structure: normals do not turn, so that the compatible
    pairs are the same at all scales, and there are no events; but areas grow by $s^2$ for
    fv-facets, by $s$ for ee-facets, and not at all for vf-facets.""",
    reading=r"""Of both models scaled by one factor; or of the structure of the sum alone, which is
    what the argument needs: there are no events.""",
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
        P, Q = drawn_body(dice), drawn_body(dice)
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
