"""Section 7.2: collision detection, in time and for convex polyhedra."""

from __future__ import annotations

import random
from statistics import median

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.reports.audit.bodies import (
    Body,
    compatible_pairs,
    cross,
    dot,
    drawn_body,
    drawn_scaling,
    minus,
    scaled,
    support,
)
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.bench.space_pairs import PAIRS
from minkref.reports.bench.spread import spread

PART = Chapter("section-7", "Section 7: tables, figures and times")
SEED = 7
PASSES = 3
TIMED = (0, 1, 2, 5, 6)  # of the pairs of solids, those that take a second or so


@PART.entry(
    "collision-detection-in-space",
    "Collision detection takes about half of the time in space",
    place="Section 7.2.1",
    status=Status.NOT_REPRODUCIBLE,
    printed=r"""“the collision detection step that we use to filter out boundaries interior to the
    Minkowski sum boundary takes about 50% of the total computation time”.""",
    right=r"""Their program and models are not at hand. Our exact sum from scratch, another program,
    tests places beside edges, not shells: collision tests took 52 to 77 % of the time for five
    pairs, the median 69 %, in one run on one thread of a busy machine.""",
    code=("reference/space/edges/collision.hpp",),
    slow=True,
)
def _(shown: Shown) -> None:
    """Sums from edges of our solids, one thread: collision tests' share of the time, median of
    three runs."""
    shares = []
    for pair in map(PAIRS.__getitem__, TIMED):
        P, Q = map(core_polyhedron, pair.solids())
        runs = [_core.timed_edge_sum(P, Q, ("1", "1", "1")) for _ in range(PASSES)]
        share = median(100 * tested / taken for taken, tested, _ in runs)
        shares.append(share)
        shown.tell(f"{pair.name}: {runs[0][2]:,} collision tests, {share:.0f} % of "
                   f"{runs[0][0]:.2f} s")  # fmt: skip
    shown.tell(f"per cent of the time: {spread(shares).in_words()}; {min(shares):.0f} to "
               f"{max(shares):.0f}")  # fmt: skip
    shown.true("each share is between nothing and all", 0 < min(shares) and max(shares) < 100)


@PART.entry(
    "no-collision-detection",
    "No collision detection for convex polyhedra",
    place="Section 7.2.2, Table 2",
    status=Status.HOLDS,
    printed=r"""“There is no collision detection component here” (Table 2); “no culling is
    necessary”.""",
    right=r"""True: each facet of compatible features lies in a supporting plane, hence on the
    boundary. Nothing of the convolution is inside. (Ties are another matter, see the [boundary of
    convex sums](section-6.md#boundary-of-convex-sums).)""",
    code=("reference/space/convex/static_convex_sum.hpp",),
)
def _(shown: Shown) -> None:
    """100 random pairs under random scalings along the axes: for each compatible pair of features
    the farthest height of the sum along the facet's normal is that of the pair, exactly."""
    dice = random.Random(SEED)
    facets = inside = 0
    for _ in range(100):
        P, Q, s = drawn_body(dice), drawn_body(dice), drawn_scaling(dice)
        big = Body(tuple(scaled(s, point) for point in P.points), P.facets)
        for n, of_P, of_Q in _facets(big, Q):
            facets += 1
            inside += not (of_P <= support(big.points, n) and of_Q <= support(Q.points, n))
    shown.true(f"{facets:,} facets of compatible features", facets > 1000)
    shown.equal("of these not on a supporting plane of the sum", inside, 0)


Whole = tuple[int, int, int]


def _facets(P: Body, Q: Body) -> list[tuple[Whole, set[int], set[int]]]:
    """Each convolution facet: outward normal, vertices of P, vertices of Q."""
    pairs = compatible_pairs(P, Q)
    found = [(n, set(facet), {min(of_Q)})
             for n, facet, of_Q in zip(P.normals, P.facets, pairs.fv, strict=True)]  # fmt: skip
    found += [(n, {min(of_P)}, set(facet))
              for n, facet, of_P in zip(Q.normals, Q.facets, pairs.vf, strict=True)]  # fmt: skip
    for e, g in pairs.ee:
        n = cross(P.along(e), Q.along(g))
        inner = next(k for k in range(len(P.points)) if k not in e)
        if dot(n, P.points[inner]) > dot(n, P.points[e[0]]):
            n = minus((0, 0, 0), n)
        found.append((n, set(e), set(g)))
    return found
