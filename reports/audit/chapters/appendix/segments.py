"""Line segments with line segments."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

import sympy as sp
from minkref import _core
from minkref.fuzz.geometry.plane import cross
from minkref.fuzz.judges.disc.paper_disc import Edge as Side
from minkref.fuzz.judges.disc.paper_disc import end_on_line, touches
from minkref.fuzz.judges.plane.paper_pairs import contact_interval
from minkref.reports.audit.disc import along, exact, moving, squared_distance
from minkref.reports.audit.disc_code import (
    CODE,
    code_events,
    lines_of_sum,
    polynomials_of_boundary,
    scales_by_both,
)
from minkref.reports.audit.edges import answers, written
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status, text
from minkref.reports.audit.pictures import moving_edges
from minkref.reports.audit.symbolic_disc import FIVES, r, s, unit, vector, z

PART = Chapter("appendix", "Appendix: a scaling disc")
SEED = 12
ORACLE = ("oracle/symbolic/disc/disc.py", "oracle/symbolic/disc/derive_disc.py")


@PART.entry(
    "disc-centre",
    "The centre of the scaled disc",
    place="Appendix",
    status=Status.CONDITION,
    printed=r"""The disc $s Q$ has the centre $c$ of $Q$, and the radius $s r$.""",
    right=r"""$s Q = \{s q\}$, as in the rest of the paper, has the centre $s c$. The Appendix
    holds for $c = 0$, or if the disc is scaled about its own centre: both sums differ by the
    translation $(s - 1) c$, and their events are the same.""",
    code=("docs/definitions.md", "reference/disc/diagram/diagram_events.hpp"),
)
def _(shown: Shown) -> None:
    """By computer algebra, for a point of the circle. By the code, for a polygon that is moved by a
    centre: the events of its sum with a disc, which is about the origin, stay."""
    c, u = vector("c"), unit("t")
    gap = s * (c + r * u) - (c + s * r * u) - (s - 1) * c
    shown.identity("$s (c + r u) = c + s r u + (s - 1) c$, first coordinate", gap[0])
    shown.identity("$s (c + r u) = c + s r u + (s - 1) c$, second coordinate", gap[1])
    ring = [(0, 0), (9, 0), (9, 7), (6, 2), (2, 5)]
    moved = [(x + 7, y - 5) for x, y in ring]
    events = polynomials_of_boundary(ring)
    shown.equal("events of the boundary, by the code, of a polygon and of it moved by "
                "$(7, -5)$", len(events), len(polynomials_of_boundary(moved)))  # fmt: skip
    shown.true("there are some, and their squares have the same polynomials",
               bool(events) and events == polynomials_of_boundary(moved))  # fmt: skip


@PART.entry(
    "disc-moving-edges",
    "How the segments of a polygon and a disc move",
    place="Appendix, segments with segments",
    status=Status.CONDITION,
    printed=r"""$p(s) = p + (s - 1) r (\perp l)$, $\perp l$ being the unit vector in the direction
    from the centre $c$ and perpendicular to the segment $l$.""",
    right=r"""So it is if $p$ is the end at $s = 1$ and $\perp l$ is the unit normal $n$ that points
    out of $P$: the end of the edge itself plus $s r n$, on the line $n \cdot x = h + s r$. Taken
    from the centre of a disc that stands on the edge this is meant; taken from a fixed point $c$
    the vector points into $P$ at each edge that turns its outer side to $c$. An offset edge is a
    T-edge at the vertex $r n$, so all of Section 4 applies to it, and the crossing of two moves
    along a line, at a constant rate.""",
    code=(
        "reference/plane/critical/line_intersection.hpp",
        "reference/disc/curves/offset_form.hpp",
        *ORACLE,
    ),
)
def _(shown: Shown) -> None:
    """By computer algebra the ends are on the line, and the second derivative of the crossing of
    two lines is zero. For a box and the fixed centre 0, the exact distance of both places to the
    box, and the line that the code has."""
    n, m, a, b = unit("t"), unit("u"), vector("a"), vector("b")
    shown.identity("$n \\cdot p(s) = n \\cdot a + s r$ for $p = a + r n$",
                   n.dot(a + r * n + (s - 1) * r * n) - n.dot(a) - s * r)  # fmt: skip
    lines = sp.Matrix([n.T, m.T])
    x = lines.inv() * sp.Matrix([n.dot(a) + s * r, m.dot(b) + s * r])
    for k, name in enumerate(("first", "second")):
        shown.identity(f"second derivative of the crossing, {name} coordinate", x[k].diff(s, 2))
    ring = [(10, 0), (20, 0), (20, 10), (10, 10)]
    p = Fraction(9), Fraction(5)  # at s = 1, r = 1, on the side that is next to 0
    right, wrong = ((p[0] + sign, p[1]) for sign in (-1, 1))
    shown.different("$P = [10, 20] \\times [0, 10]$, $r = 1$, $c = 0$: where $(9, 5)$ is at "
                    "$s = 2$", wrong, right)  # fmt: skip
    shown.true("the code has the line $-x = -10 + s r$ for that side: $x = 8$ at $s = 2$",
               ("0", "-1", "-10") in lines_of_sum(ring))  # fmt: skip
    shown.equal("squared distance of both to $P$",
                tuple(squared_distance(x, ring) for x in (wrong, right)), (0, 4))  # fmt: skip


TWO: tuple[tuple[str, Side, Side, str, int], ...] = (
    ("before and after a convex vertex", ((0, 0), (10, 0)), ((10, 0), (10, 10)), "empty", 0),
    ("before and after a reflex vertex", ((20, 10), (10, 10)), ((10, 10), (10, 20)), "(0, 2]", 1),
    ("that face each other", ((3, 8), (-7, 8)), ((-4, 5), (-12, 11)), "[3/5, 3]", 2),
    ("that pass each other", ((0, 10), (10, 10)), ((-10, 0), (-10, 5)), "[2, 2]", 1),
)


def _drawn_side(dice: random.Random) -> Side:
    x, y = dice.randint(-10, 10), dice.randint(-10, 10)
    (u, v), times = dice.choice(FIVES), dice.randint(1, 3)
    return (x, y), (x + times * u, y + times * v)


@PART.entry(
    "disc-two-events",
    "Two offset edges have exactly two events, or never meet",
    place="Appendix, segments with segments",
    status=Status.LITERAL,
    printed=r"""Since the segments do not grow there are exactly two events, both at an end of a
    segment, or else the segments do not intersect at all.""",
    right=r"""The scales $s > 0$ at which two offset edges that are not parallel meet are a bounded
    interval, and its ends are such events. There is one event at a reflex vertex, whose edges meet
    from 0 on, or if the interval is a single scale; there is none at a convex vertex, whose edges
    share a point at $s = 0$ only. (With scales of zero and below there would always be two, which
    may coincide; but the Appendix has $s > 0$.)""",
    reading=r"""Of all real scales, and a scale counted twice at which the edges only touch.""",
    code=("reference/plane/critical/pair_interval.hpp", *CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """Four pairs of edges, radius 5: the code for T-edges at the vertex r n, that for discs, the
    symbolic oracle for segments, and that for discs agree. Then 500 random pairs, with the same
    four. The sentence by itself, as the code reads it, against what is."""
    for what, a, b, wanted, events in TWO:
        edges = moving(a, 5), moving(b, 5)
        shown.equal(f"edges {what} meet for $s$ in", _interval(a, b), wanted)
        shown.equal(f"edges {what}: events", len(scales_by_both(a, b, 5)), events)
        kept = len(code_events(a, b, 5, ["number"]))
        shown.equal(f"edges {what}: events if there are two or none", kept, 2 * (events == 2))
        if events:
            shown.draw(f"edges {what}: they meet for s in {wanted}",
                       moving_edges(*edges, answers(*edges).corrected))  # fmt: skip
    dice = random.Random(SEED)
    counts: Counter[str] = Counter()
    for _ in range(500):
        a, b = _drawn_side(dice), _drawn_side(dice)
        if cross(along(a), along(b)) == 0:
            continue
        told = answers(moving(a, 5), moving(b, 5))
        ends = {x for x in told.corrected or () if x is not None}
        found = set(scales_by_both(a, b, 5))
        if told.corrected != told.symbolic or {sp.Rational(str(x)) for x in ends} != found:
            raise CheckFailed(text((a, b, told, found)))
        counts[f"{len(ends)}"] += 1
    shown.true(f"random pairs with 0, 1 and 2 events: {counts['0']}, {counts['1']} and "
               f"{counts['2']}, by all four", min(counts[x] for x in "012") > 0)  # fmt: skip


def _interval(a: Side, b: Side) -> str:
    """The interval from the code; raises CheckFailed if the symbolic oracle finds another
    interval."""
    told = answers(moving(a, 5), moving(b, 5))
    if told.corrected != told.symbolic:
        raise CheckFailed(text((a, b, told)))
    return written(told.corrected)


@PART.entry(
    "disc-rejected-parameters",
    "Which parameters are rejected",
    place="Appendix, segments with segments",
    status=Status.MISPRINT,
    printed=r"""Solutions with $0 < t$ or $t > 1$ are rejected, and likewise for $k$.""",
    right=r"""Those with $t < 0$ or $t > 1$.""",
    code=("reference/plane/critical/scale_interval.hpp", *CODE),
)
def _(shown: Shown) -> None:
    """The sets of the parameters that are kept, by computer algebra. Two pairs of edges by the
    code, with this sentence as printed and as it should be."""
    beyond = sp.Interval.open(1, sp.oo)
    printed, right = (
        sp.Union(x, beyond).complement(sp.S.Reals)
        for x in (sp.Interval.open(0, sp.oo), sp.Interval.open(-sp.oo, 0))
    )
    shown.true("as printed all $t \\le 0$ are kept and no others",
               printed == sp.Interval(-sp.oo, 0))  # fmt: skip
    shown.true("with $t < 0$ the segment $[0, 1]$ is kept", right == sp.Interval(0, 1))
    for what, a, b, _, _ in TWO[2:]:
        told = [code_events(a, b, 5, sentences) for sentences in (["rejected"], [])]
        kept, wanted = ([event.scale for event in events] for events in told)
        shown.equal(f"edges {what}: scales of their events, as printed and right", (kept, wanted),
                    ([], [sp.Rational(3, 5), 3]) if wanted[1:] else ([2], [2]))  # fmt: skip


@PART.entry(
    "disc-parallel-edges",
    "Parallel edges of the polygon",
    place="Appendix, segments with segments",
    status=Status.INCOMPLETE,
    printed=r"""The crossing of two lines is expressed in terms of $s$; parallel ones are not spoken
    of.""",
    right=r"""With one normal the offset lines coincide at all scales or at none. With opposite ones
    they coincide at one scale $s = n_2 \cdot (p_1 - p_2) / (2 r)$, if that is positive: walls that
    face each other meet when the disc fills the room between them, and along a segment.""",
    code=("reference/plane/critical/parallel_pair.hpp", *CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra; and the walls of a slot of width 4, and the tops beside it, by the code
    and both oracles."""
    n, p, q = unit("t"), vector("p"), vector("q")
    gap = n.dot(p + s * r * n - q) - s * r
    shown.identity("one normal: derivative of the gap of the lines", sp.diff(gap, s))
    gap = n.dot(p - s * r * n - q) - s * r
    shown.identity("opposite normals: the gap at $s = n_2 \\cdot (p_1 - p_2) / (2 r)$",
                   gap.subs(s, n.dot(p - q) / (2 * r)))  # fmt: skip
    walls: tuple[Side, Side] = ((8, 6), (8, 2)), ((4, 2), (4, 6))
    tops: tuple[Side, Side] = ((12, 6), (8, 6)), ((4, 6), (0, 6))
    shown.equal("walls at the distance 4, $r = 1$, meet for $s$ in", _parallel(*walls), "[2, 2]")
    shown.equal("scales of their events by the code and the oracle for discs",
                scales_by_both(*walls, 1), [2])  # fmt: skip
    shown.equal("what becomes of the points that they share, by the code",
                [event.change for event in code_events(*walls, 1)], ["overlap"])  # fmt: skip
    shown.equal("the tops beside them, always on one line, meet for $s$ in", _parallel(*tops),
                "empty")  # fmt: skip
    shown.equal("case of an end of one on the line of the other",
                end_on_line(0, tops[0], tops[1], 1).case, "always")  # fmt: skip


def _parallel(a: Side, b: Side) -> str:
    """The interval for radius 1 from the code; raises CheckFailed if the symbolic oracle finds
    another interval."""
    rows = moving(a, 1).numbers, moving(b, 1).numbers
    ((_, empty, low, high),) = _core.pair_intervals([rows])
    found = None if empty else (low, high)
    if found != contact_interval(*rows):
        raise CheckFailed(text((a, b, found)))
    return "empty" if found is None else f"[{found[0]}, {found[1]}]"


@PART.entry(
    "disc-degree-of-scales",
    "The scales are irrational in general",
    place="Appendix, segments with segments",
    status=Status.INCOMPLETE,
    printed=r"""The crossing is set equal to each of the ends in turn, and solved for $s$.""",
    right=r"""The equation is linear, over the field of the lengths $l_1$ and $l_2$ of the edges:
    with $A = (p_1 - p_2) \times d_2$ and $B = d_1 \cdot d_2$ the end $p_1$ comes to the second line
    at $s = A l_1 (l_1 l_2 + B) / (r (d_1 \times d_2)^2)$, if they are not parallel and this is
    positive. For a polygon with rational coordinates and a rational $r$ that is an algebraic number
    of degree 1, 2 or 4, which is in general neither a rational nor a double.""",
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra the formula solves the condition. An instance of the symbolic oracle has
    the degree 4: its polynomial is compared with that of sympy, and found irreducible; the edges
    themselves touch there, also by the code. Degrees of 150 random pairs by the oracle."""
    k, m, A, B = sp.symbols("l_1 l_2 A B", positive=True)
    scale = A * k * (k * m + B) / (r * (k**2 * m**2 - B**2))
    condition = A / m + s * r * B / (k * m) - s * r
    shown.identity("the formula, in $n_2 \\cdot (p_1 + s r n_1 - p_2) = s r$",
                   condition.subs(s, scale))  # fmt: skip
    d, e = vector("d"), vector("e")
    across = (d[0] * e[1] - d[1] * e[0]) ** 2
    shown.identity("$(d_1 \\times d_2)^2 = l_1^2 l_2^2 - B^2$",
                   across - d.dot(d) * e.dot(e) + d.dot(e) ** 2)  # fmt: skip
    of: Side = ((7, 2), (9, 3))
    line: Side = ((3, -9), (2, -6))
    root = end_on_line(0, of, line, 1)
    value = sp.Rational(23, 49) * (5 * sp.sqrt(10) + sp.sqrt(5))
    shown.equal("edges along $(2, 1)$ and $(-1, 3)$: minimal polynomial of the oracle",
                root.polynomial, (2401, 0, -269790, 0, 6996025))  # fmt: skip
    shown.identity(f"its scale is ${sp.latex(value)}$", exact(root) - value)
    polynomial = sp.Poly(sp.minimal_polynomial(value, z), z)
    shown.equal("the polynomial by sympy", tuple(int(x) for x in polynomial.all_coeffs()),
                root.polynomial)  # fmt: skip
    shown.true("it is irreducible over the rationals", polynomial.is_irreducible)
    shown.true("the edges themselves touch at that scale",
               root in [touch.root for touch in touches(of, line, 1)])  # fmt: skip
    shown.true("so they do by the code",
               any(sp.simplify(found - value) == 0
                   for found in scales_by_both(of, line, 1)))  # fmt: skip
    dice = random.Random(SEED)
    degrees: Counter[int] = Counter()
    while sum(degrees.values()) < 150:
        x = [(dice.randint(-6, 6), dice.randint(-6, 6)) for _ in range(4)]
        if x[0] != x[1] and x[2] != x[3]:
            found = end_on_line(0, (x[0], x[1]), (x[2], x[3]), 1)
            if found.case == "once":
                degrees[len(found.polynomial) - 1] += 1
    told = ", ".join(f"degree {x}: {degrees[x]}" for x in sorted(degrees))
    shown.true(f"{told} of 150 random ends and lines", set(degrees) == {1, 2, 4})  # fmt: skip
