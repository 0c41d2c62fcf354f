"""Entangled normals: what the first half of Theorem 1 rests on."""

from __future__ import annotations

import random
from itertools import product
from math import prod

import sympy as sp
from minkref.fuzz.geometry.space import cross, dot
from minkref.reports.audit.bodies import (
    ONE,
    Body,
    Whole,
    drawn_body,
    drawn_scaling,
    edge_pairs,
    facet_pairs,
    hull,
)
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.space import vector

PART = Chapter("section-6", "Section 6: convex polyhedra under non-uniform scaling")
SEED = 61

# Found by a directed search: two normals are drawn so that they are entangled, then the bodies.
KEPT: tuple[tuple[Body, Body, Whole], ...] = (
    (hull([(0, 0, 0), (-120, 120, -120), (-29, 36, -26), (-33, 38, -31)]),
     hull([(0, 0, 0), (-45, 94, -36), (-21, 59, -16), (-61, 120, -49)]), (35, 2425, 14)),
    (hull([(0, 0, 0), (-207, -231, -205), (-90, -141, -86), (-250, -250, -250)]),
     hull([(0, 0, 0), (-34, -12, -37), (-183, -48, -221), (-206, -53, -250)]), (135, 7, 225)),
    (hull([(0, 0, 0), (250, 250, -250), (128, 112, -75), (155, 115, -66)]),
     hull([(0, 0, 0), (94, 22, -7), (250, 95, -42), (88, 17, -4)]), (14000, 310, 23)),
    (hull([(0, 0, 0), (-500, 500, 500), (-106, 80, 140), (-74, 51, 104)]),
     hull([(0, 0, 0), (-18, 10, 32), (-22, 13, 37), (-317, 193, 500)]), (240, 97, 760)),
)  # fmt: skip


def entangled(n: Whole, m: Whole, s: Whole) -> bool:
    """Whether n = D m for a diagonal D > 0 in the lens between the chord from I to S and the
    inverse of the chord from I to 1/S, both up to factors. Its sides: the sign of a determinant of
    powers 0, 1 and 1/2 is known, as Vandermonde's."""
    if any(a * b <= 0 for a, b in zip(n, m, strict=True)):
        return False
    one, scaling = vector(ONE), vector(s)
    ratio = vector([a / b for a, b in zip(vector(n), vector(m), strict=True)])
    order = prod(((s[1] - s[0]), (s[2] - s[0]), (s[2] - s[1])))
    chord = dot(cross(one, scaling), ratio)
    inverse = dot(cross(one, vector([1 / x for x in scaling])), vector([1 / x for x in ratio]))
    return chord * order < 0 < inverse * order


def table(P: Body, Q: Body, s: Whole) -> list[list[bool]]:
    """Entangled or not, for each normal of P and each of Q."""
    return [[entangled(n, m, s) for m in Q.normals] for n in P.normals]


def sums(P: Body, Q: Body, pairs: list[list[bool]]) -> list[int]:
    """Entangled pairs among the four of each edge of P and each edge of Q."""
    return [
        sum(pairs[i][k] for i in e for k in a)
        for e, a in product(P.edges.values(), Q.edges.values())
    ]


def changed(P: Body, Q: Body, s: Whole) -> list[bool]:
    """Of each edge of P and each edge of Q, whether they are compatible at one end only."""
    before, after = edge_pairs(P, Q, ONE), edge_pairs(P, Q, s)
    return [((e, a) in before) != ((e, a) in after) for e, a in product(P.edges, Q.edges)]


def keeps(P: Body, Q: Body, s: Whole) -> bool:
    """Whether each facet has one vertex, and the same one after the scaling."""
    before = facet_pairs(P, Q, ONE)
    return before == facet_pairs(P, Q, s) and all(
        len(each) == 1 for each in (*before[0], *before[1])
    )


@PART.entry(
    "theorem-1-entangled",
    "Theorem 1, first half: entangled normals",
    place="Section 6, Theorem 1",
    status=Status.CONDITION,
    printed=r"""Where there is an ee-error there is an fv-error.""",
    right=r"""Let all facets of both operands keep their vertices from $I$ to $S$. Call a
    normal $n$ of $P$ and a normal $m$ of $Q$ entangled if $n$ lies in the lens between the chord
    from $m$ to $S m$ and the curve $((1 - t) I + t S^{-1})^{-1} m$. Then an edge of $P$, between
    the normals $n_1$ and $n_2$, and an edge of $Q$, between $m_1$ and $m_2$, are compatible at one
    end and not at the other if and only if an odd number of the four pairs $(n_i, m_j)$ is
    entangled. So the half holds wherever no pair is entangled. Proof. Follow the path $S_t = (1 -
    t) I + t S$ with the normals of $P$ fixed. $S_t m$ runs along the chord, whose ends are in the
    cell of one vertex of $P$, which is convex: no end of an arc of $Q$ ever meets an arc of $P$.
    So a pair changes as often as $n_1$ or $n_2$ passes the arc $m_1 m_2$. Seen from $Q$, $n_i$
    runs from $n_i$ to $S^{-1} n_i$ along $S_t^{-1} n_i$; back along the chord it stays in the
    convex cell of its vertex and passes no arc. This loop, which bounds the lens of $n_i$, passes
    an arc an odd number of times if and only if one of its ends is inside; and $m$ is in the lens
    of $n$ if and only if $n$ is in that of $m$, by taking inverses. That entangled normals come
    with errors of facets is not so: there are bodies with all facets kept and many entangled
    pairs. In all that are known each of the sums of four is even, and no edge pair changes; that
    this is always so is not proved.""",
    formula="Theorem 1, first half",
)
def _(shown: Shown) -> None:
    """The side of the chord on which the lens is, by computer algebra. Four pairs of tetrahedra
    with entangled normals, found by a directed search, by supports alone. Then random pairs of
    bodies, where facets keep their vertices: pairs of edges change as the four say."""
    u, x = sp.symbols("u x", positive=True)
    root = sp.Matrix([[1, 1, 1], [1, u**2, x**2], [1, u, x]]).det()
    order = (u**2 - 1) * (x**2 - 1) * (x**2 - u**2)
    factors = -(u - 1) * (x - 1) * (x - u)
    shown.identity("side of the root of $S$ on the chord", sp.expand(root - factors))
    shown.identity(
        "its sign is that of the order", sp.expand(order + factors * (u + 1) * (x + 1) * (x + u))
    )
    for P, Q, s in KEPT:
        pairs = table(P, Q, s)
        count = sum(map(sum, pairs))
        shown.true(
            f"scaled by {s}: all facets keep their vertices, and {count} pairs of normals are "
            "entangled",
            keeps(P, Q, s) and count > 0,
        )
        shown.equal("odd sums of four", sum(k % 2 for k in sums(P, Q, pairs)), 0)
        shown.equal("pairs of edges that change", sum(changed(P, Q, s)), 0)
    dice = random.Random(SEED)
    kept = same = 0
    for _ in range(1500):
        P, Q, s = drawn_body(dice), drawn_body(dice), drawn_scaling(dice)
        if len(set(s)) == 3 and keeps(P, Q, s):
            kept += 1
            odd = [k % 2 == 1 for k in sums(P, Q, table(P, Q, s))]
            same += odd == changed(P, Q, s)
    shown.true(f"in {kept} random trials without an error of a facet pairs change as the four say",
               kept == same > 50)  # fmt: skip
