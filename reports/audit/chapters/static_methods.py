"""Section 3: the reduced convolution beside decompositions and winding numbers."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from statistics import median

from minkref import _core
from minkref.fuzz.cgal.executables import available_targets
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.plane.operand import read_operand
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status
from minkref.reports.bench.pairs import SMALL
from minkref.reports.bench.spread import spread

PART = Chapter("section-3", "Sections 1 and 3: the convolution")
ALIKE = (("g1", "g2"), ("g3", "g4"), ("dog145", "dog145"), ("disc1", "cells1815"),
         ("glyph1204", "glyph275"))  # fmt: skip
TARGETS = ("cgal-reduced", "cgal-full")
PASSES = 3
MUCH = 2  # times as fast, a threshold of ours


@PART.entry(
    "fewer-primitives",
    "Far fewer primitives than pairwise sums",
    place="Section 3",
    status=Status.CONDITION,
    printed=r"""“there are far fewer primitives in the convolution of two shapes than there are
    pairwise Minkowski sums from their decompositions”.""",
    right=r"""So it is for decompositions into triangles: the convolution of the polygons below has
    from a quarter down to a twentieth as many edges. For decompositions into few parts it need not
    be: a disc is convex, one part, and a polygon has fewer triangles than its convolution with the
    disc has edges. Counted in edges, of which each pairwise sum has those of both parts, the
    pairwise sums of any two decompositions have at least twice as many. Convex operands have one
    pairwise sum, with as many edges.""",
    code=("reference/plane/convolution/convolution_size.hpp",),
)
def _(shown: Shown) -> None:
    """Edges of reduced convolutions, counted by the code, against two bounds for decompositions. At
    least: a polygon of $n$ edges, $r$ reflex vertices and $h$ holes has $r/2 + 1 - h$ convex parts
    or more, whatever points are added, and its $k$ parts have $n$ and $3 k$ edges or more. By
    triangles: $n + 2 h - 2$ parts of three edges. All models come with the project."""
    fewest: list[Fraction] = []
    by_triangles: list[Fraction] = []
    for names in ALIKE:
        P, Q = (read_operand(name).set for name in names)
        edges = len(_core.reduced_convolution(P, Q))
        least, triangles = (
            _pairwise(*(parts(operand) for operand in (P, Q))) for parts in (_fewest, _triangles)
        )
        shown.tell(
            f"{' and '.join(names)}: {edges:,} edges of the convolution; {least[0]:,} pairwise "
            f"sums with {least[1]:,} edges at least, {triangles[0]:,} with {triangles[1]:,} by "
            "triangles"
        )
        fewest.append(Fraction(least[1], edges))
        by_triangles.append(Fraction(triangles[0], edges))
    shown.true(f"by triangles there are {float(min(by_triangles)):.1f} to "
               f"{float(max(by_triangles)):.1f} times as many pairwise sums as edges of the "
               "convolution", min(by_triangles) > 3)  # fmt: skip
    shown.true(f"the pairwise sums have {float(min(fewest)):.1f} times as many edges, or more",
               min(fewest) > 2)  # fmt: skip
    disc, cells = (read_operand(name).set for name in ("disc1", "cells1815"))
    sums = _pairwise(_fewest(disc), _triangles(cells))[0]
    shown.true(f"the disc in one part has {sums:,} pairwise sums, fewer than primitives",
               sums < len(_core.reduced_convolution(disc, cells)))  # fmt: skip


Parts = tuple[int, int]  # convex parts, and their edges


def _pairwise(P: Parts, Q: Parts) -> tuple[int, int]:
    """The pairwise sums, and their edges: those of both parts."""
    return P[0] * Q[0], Q[0] * P[1] + P[0] * Q[1]


def _fewest(operand: _core.PolygonSet) -> Parts:
    corners, reflex, holes = _counts(operand)
    parts = max(1, (reflex + 1) // 2 + 1 - holes)
    return parts, max(corners, 3 * parts)


def _triangles(operand: _core.PolygonSet) -> Parts:
    corners, _, holes = _counts(operand)
    parts = corners + 2 * holes - 2
    return parts, 3 * parts


def _counts(operand: _core.PolygonSet) -> tuple[int, int, int]:
    """Corners (not straight ones), reflex corners, and holes of one polygon."""
    corners = reflex = 0
    rings = next(iter(operand.rings()))
    for ring in rings:
        at = [(Fraction(x), Fraction(y)) for x, y in ring]
        for k in range(len(at)):
            (x0, y0), (x1, y1), (x2, y2) = at[k - 2], at[k - 1], at[k]
            turn = (x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1)
            corners, reflex = corners + (turn != 0), reflex + (turn < 0)
    return corners, reflex, len(rings) - 1


@PART.entry(
    "faster-than-winding",
    "Much faster than Wein's method",
    place="Section 3",
    status=Status.CONDITION,
    printed=r"""“experimentally, our method is shown to be much faster than Wein's”.""",
    right=r"""CGAL, by other authors, has both: the reduced convolution, and Wein's full one with
    winding numbers. In one run over 25 pairs of polygons with the paper's numbers of vertices the
    reduced convolution was 7.6 times as fast in the median (quartiles 5.1 to 10.2; 2.3 to 18.4).
    The paper's own program is not at hand here, and for convex operands both convolutions are the
    same.""",
    code=("oracle/cgal/reduced.cpp", "oracle/cgal/full.cpp"),
    slow=True,
)
def _(shown: Shown) -> None:
    """CGAL's own seconds, the least among three, reduced and full convolution in turn, 25 pairs of
    our models."""
    if missing := set(TARGETS) - set(available_targets()):
        shown.tell(f"not built here: {', '.join(sorted(missing))}; nothing was timed")
        return
    reduced, full = CgalOracle("reduced"), CgalOracle("full")
    try:
        ratios = [_seconds(full, *pair) / _seconds(reduced, *pair)
                  for pair in product(SMALL, repeat=2)]  # fmt: skip
    finally:
        reduced.close()
        full.close()
    shown.tell(f"full over reduced: {spread(ratios).in_words()}; {min(ratios):.1f} to "
               f"{max(ratios):.1f}, {len(ratios)} pairs")  # fmt: skip
    shown.true(f"the median is above {MUCH}", median(ratios) > MUCH)


def _seconds(oracle: CgalOracle, first: str, second: str) -> float:
    P, Q = (read_operand(name).set.to_json() for name in (first, second))
    taken = []
    for _ in range(PASSES):
        answer = oracle.sum(P, Q)
        if answer.seconds is None:
            raise CheckFailed(f"{first} and {second}: {answer.status}, {answer.reason}")
        taken.append(answer.seconds)
    return min(taken)
