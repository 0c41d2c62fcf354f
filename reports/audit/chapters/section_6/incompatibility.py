"""The degree of incompatibility, and the descent."""

from __future__ import annotations

import random

import sympy as sp
from minkref.reports.audit.bodies import (
    Body,
    Whole,
    cross,
    dot,
    drawn_body,
    drawn_scaling,
    hull,
    minus,
    random_body,
    scaled,
    scaled_normal,
    support,
)
from minkref.reports.audit.convex_code import descent
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import vector
from minkref.reports.audit.space_pictures import solids_picture
from minkref.reports.audit.symbolic_space import place

PART = Chapter("section-6", "Section 6: convex polyhedra under non-uniform scaling")
SEED = 6
UP: Whole = (0, 0, 1)
OCTAHEDRON = hull([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)])
FIVE = hull([(2, -3, -3), (3, -3, 0), (-3, 3, 3), (-1, -2, -1), (-3, 3, 1)])
CUBE = hull([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


def _drawn_vector(dice: random.Random) -> Whole:
    while True:
        found = dice.randint(-9, 9), dice.randint(-9, 9), dice.randint(-9, 9)
        if any(found):
            return found


def _rise(body: Body, v: int, w: int, n: Whole) -> int:
    return dot(n, minus(body.points[w], body.points[v]))


def _printed_witness(body: Body, v: int, n: Whole) -> tuple[int, int]:
    """IC times the length of n, and the other end of the edge with this value."""
    return max((abs(_rise(body, v, w, n)), w) for w in body.neighbours[v])


def _printed_walk(body: Body, v: int, n: Whole) -> list[int]:
    """Along witnesses until a vertex is compatible or comes again."""
    walk = [v]
    top = support(body.points, n)
    while walk[-1] not in top and walk.count(walk[-1]) < 2:
        walk.append(_printed_witness(body, walk[-1], n)[1])
    return walk


def _walk(points: list[Whole] | tuple[Whole, ...], near: list[list[int]], v: int, n: Whole) -> int:
    """Walks to the highest neighbour while one is higher; returns the last vertex."""
    while True:
        best = max(near[v], key=lambda w: dot(n, points[w]))
        if dot(n, points[best]) <= dot(n, points[v]):
            return v
        v = best


@PART.entry(
    "degree-of-incompatibility",
    "The degree of incompatibility",
    place="Section 6",
    status=Status.LITERAL,
    printed=r"""All edges at a compatible vertex are below or on the half-plane of $f$. For a vertex
    that is not compatible $IC(f, v)$ is the longest Euclidean distance of a point on an edge at $v$
    from $f$, and the edge that has it is the witness; descent goes on until the pair is
    compatible.""",
    right=r"""With the plane of $f$ moved to $v$, a distance does not tell above from below: the
    witness may lead downwards, and the descent go to and fro between vertices that are not
    compatible, without end. (And taken at a compatible vertex, where the text does not define it,
    the distance is not zero.) What tells both is $IC(f, v) = \max(0, \max_w n_f \cdot (w - v))$
    over the neighbours $w$ of $v$. (A half-space is meant, bounded by the plane through $v$ that is
    parallel to $f$.) Only signs and the order of heights are needed, so that $n_f$ may have any
    length.""",
    reading=r"""Take $d(e, f)$ with a sign, positive above the plane of $f$ through $v$: then the
    witness leads upwards, and descent ends at a compatible vertex.""",
)
def _(shown: Shown) -> None:
    """A body with five vertices and a level facet, for which the printed descent goes to and fro
    between two vertices, neither of which is compatible. Then 300 random bodies with 5 to 8
    vertices, directions and start vertices that are not compatible: where either walk ends. At its
    upper apex an octahedron has distances that are not zero."""
    body = FIVE
    shown.equal("heights of the vertices of a body", [p[2] for p in body.points], [-3, 0, 3, -1, 1])
    shown.equal("the one that is compatible", sorted(support(body.points, UP)), [2])
    shown.equal("neighbours of vertex 0", sorted(body.neighbours[0]), [1, 3, 4])
    walk = _printed_walk(body, 0, UP)
    shown.equal("the printed descent from vertex 0 visits", walk, [0, 4, 0])
    near = [list(each) for each in body.neighbours]
    shown.equal("the right one ends at", _walk(body.points, near, 0, UP), 2)
    first, second = (vector(body.points[k]) for k in (0, 4))
    shown.draw(
        "the body, and the edge along which the printed descent goes to and fro",
        solids_picture([(body.polyhedron, "second")], "a body", first, [(first, second)]),
    )
    dice = random.Random(SEED)
    endless = right = kept = 0
    while kept < 300:
        body, n = random_body(dice, dice.randint(5, 8)), _drawn_vector(dice)
        start, top = dice.randrange(len(body.points)), support(body.points, n)
        if start in top:
            continue
        kept += 1
        endless += _printed_walk(body, start, n)[-1] not in top
        near = [list(each) for each in body.neighbours]
        right += _walk(body.points, near, start, n) in top
    shown.true(f"of 300 random walks as printed {endless} never end", endless > 0)
    shown.equal("walks by the right $IC$ that end at a compatible vertex", right, 300)
    found = [descent(CUBE, UP, FIVE, 0, form) for form in ("printed", "corrected")]
    shown.equal("the code from vertex 0, as printed (none: in a circle) and corrected", found,
                [None, 2])  # fmt: skip
    shown.different(
        "apex of the octahedron, $n_f = (0, 0, 1)$, where the distances have to tell that it is "
        "compatible",
        _printed_witness(OCTAHEDRON, 0, UP)[0],
        max(0, *(_rise(OCTAHEDRON, 0, w, UP) for w in OCTAHEDRON.neighbours[0])),
    )


@PART.entry(
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
        P, Q, s = drawn_body(dice), drawn_body(dice), drawn_scaling(dice)
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


@PART.entry(
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
    shown.equal(
        "a cube, from the middle of its lower facet: heights of the vertex found, of the highest",
        (points[end][2], max(p[2] for p in points)),
        (-1, 1),
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
