"""The Appendix: a disc that is scaled."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from itertools import combinations

import sympy as sp
from minkref import _core
from minkref.fuzz.judges.paper_disc import (
    Corner,
    circle_on_line,
    circles,
    end_on_circle,
    end_on_line,
    greatest_degrees,
    ring_touches,
    three_circles,
    three_lines,
    touches,
)
from minkref.fuzz.judges.paper_disc import Edge as Side
from minkref.fuzz.judges.paper_pairs import contact_interval
from minkref.reports.audit.disc import along, corner, exact, moving, squared_distance
from minkref.reports.audit.edges import answers, written
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.pictures import moving_edges
from minkref.reports.audit.sketches import arcs_at, swept

CHAPTER = Chapter("appendix", "Appendix: a scaling disc")
SEED = 12
ORACLE = ("oracle/symbolic/disc.py", "oracle/symbolic/derive_disc.py")
s, r, z = sp.symbols("s r z", positive=True)
# Directions of length 5 with whole coordinates.
FIVES = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
         (3, -4), (4, -3)]  # fmt: skip


def _vector(name: str) -> sp.Matrix:
    return sp.Matrix(sp.symbols(f"{name}_x {name}_y", real=True))


def _unit(name: str) -> sp.Matrix:
    angle = sp.Symbol(name, real=True)
    return sp.Matrix([sp.cos(angle), sp.sin(angle)])


def _normal(d: sp.Matrix) -> sp.Matrix:
    """To the right of a direction, and as long."""
    return sp.Matrix([d[1], -d[0]])


def _corner(at: tuple[int, int], start: tuple[int, int], end: tuple[int, int]) -> Corner:
    """The arc about a vertex from one normal to another, given by vectors in their direction."""
    x, y = at
    return (x + start[1], y - start[0]), at, (x - end[1], y + end[0])


@CHAPTER.entry(
    "disc-centre",
    "The centre of the scaled disc",
    place="Appendix",
    status=Status.CONDITION,
    printed=r"""The disc $s Q$ has the centre $c$ of $Q$, and the radius $s r$.""",
    right=r"""$s Q = \{s q\}$, as in the rest of the paper, has the centre $s c$. The Appendix
    holds for $c = 0$, or if the disc is scaled about its own centre: both sums differ by the
    translation $(s - 1) c$, and their events are the same.""",
    code=("docs/definitions.md",),
)
def _(shown: Shown) -> None:
    """By computer algebra, for a point of the circle."""
    c, u = _vector("c"), _unit("t")
    gap = s * (c + r * u) - (c + s * r * u) - (s - 1) * c
    shown.identity("$s (c + r u) = c + s r u + (s - 1) c$, first coordinate", gap[0])
    shown.identity("$s (c + r u) = c + s r u + (s - 1) c$, second coordinate", gap[1])


@CHAPTER.entry(
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
    code=("reference/plane/critical/line_intersection.hpp", *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra the ends are on the line, and the second derivative of the crossing of
    two lines is zero. For a box and the fixed centre 0, the exact distance of both places to the
    box."""
    n, m, a, b = _unit("t"), _unit("u"), _vector("a"), _vector("b")
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


@CHAPTER.entry(
    "disc-two-events",
    "Two offset edges have exactly two events, or never meet",
    place="Appendix, segments with segments",
    status=Status.FALSE,
    printed=r"""Since the segments do not grow there are exactly two events, both at an end of a
    segment, or else the segments do not intersect at all.""",
    right=r"""The scales $s > 0$ at which two offset edges that are not parallel meet are a bounded
    interval, and its ends are such events. There is one event at a reflex vertex, whose edges meet
    from 0 on, or if the interval is a single scale; there is none at a convex vertex, whose edges
    share a point at $s = 0$ only.""",
    code=("reference/plane/critical/pair_interval.hpp", *ORACLE),
)
def _(shown: Shown) -> None:
    """Four pairs of edges, radius 5: the code for T-edges at the vertex r n, the symbolic oracle
    for segments, and that for discs agree. Then 500 random pairs, with the same three."""
    for what, a, b, wanted, events in TWO:
        edges = moving(a, 5), moving(b, 5)
        shown.equal(f"edges {what} meet for $s$ in", _interval(a, b), wanted)
        shown.equal(f"edges {what}: events", len({x.root for x in touches(a, b, 5)}), events)
        if events:
            shown.draw(f"edges {what}: they meet for s in {wanted}",
                       moving_edges(*edges, answers(*edges).corrected))  # fmt: skip
    dice = random.Random(SEED)
    counts: Counter[str] = Counter()
    for _ in range(500):
        a, b = _drawn_side(dice), _drawn_side(dice)
        if along(a)[0] * along(b)[1] == along(a)[1] * along(b)[0]:
            continue
        told = answers(moving(a, 5), moving(b, 5))
        ends = {x for x in told.corrected or () if x is not None}
        found = {exact(touch.root) for touch in touches(a, b, 5)}
        if told.corrected != told.symbolic or {sp.Rational(str(x)) for x in ends} != found:
            raise AssertionError((a, b, told, found))
        counts[f"{len(ends)}"] += 1
    shown.true(f"random pairs with 0, 1 and 2 events: {counts['0']}, {counts['1']} and "
               f"{counts['2']}, by all three", min(counts[x] for x in "012") > 0)  # fmt: skip


def _interval(a: Side, b: Side) -> str:
    """By the code; raises AssertionError where the symbolic oracle has another one."""
    told = answers(moving(a, 5), moving(b, 5))
    if told.corrected != told.symbolic:
        raise AssertionError((a, b, told))
    return written(told.corrected)


@CHAPTER.entry(
    "disc-rejected-parameters",
    "Which parameters are rejected",
    place="Appendix, segments with segments",
    status=Status.MISPRINT,
    printed=r"""Solutions with $0 < t$ or $t > 1$ are rejected, and likewise for $k$.""",
    right=r"""Those with $t < 0$ or $t > 1$.""",
    code=("reference/plane/critical/scale_interval.hpp",),
)
def _(shown: Shown) -> None:
    """The sets of the parameters that are kept, by computer algebra."""
    beyond = sp.Interval.open(1, sp.oo)
    printed, right = (
        sp.Union(x, beyond).complement(sp.S.Reals)
        for x in (sp.Interval.open(0, sp.oo), sp.Interval.open(-sp.oo, 0))
    )
    shown.true("as printed all $t \\le 0$ are kept and no others",
               printed == sp.Interval(-sp.oo, 0))  # fmt: skip
    shown.true("with $t < 0$ the segment $[0, 1]$ is kept", right == sp.Interval(0, 1))


@CHAPTER.entry(
    "disc-parallel-edges",
    "Parallel edges of the polygon",
    place="Appendix, segments with segments",
    status=Status.INCOMPLETE,
    printed=r"""The crossing of two lines is expressed in terms of $s$; parallel ones are not spoken
    of.""",
    right=r"""With one normal the offset lines coincide at all scales or at none. With opposite ones
    they coincide at one scale $s = n_2 \cdot (p_1 - p_2) / (2 r)$, if that is positive: walls that
    face each other meet when the disc fills the room between them, and along a segment.""",
    code=("reference/plane/critical/parallel_pair.hpp", *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra; and the walls of a slot of width 4, and the tops beside it, by the code
    and both oracles."""
    n, p, q = _unit("t"), _vector("p"), _vector("q")
    gap = n.dot(p + s * r * n - q) - s * r
    shown.identity("one normal: derivative of the gap of the lines", sp.diff(gap, s))
    gap = n.dot(p - s * r * n - q) - s * r
    shown.identity("opposite normals: the gap at $s = n_2 \\cdot (p_1 - p_2) / (2 r)$",
                   gap.subs(s, n.dot(p - q) / (2 * r)))  # fmt: skip
    walls: tuple[Side, Side] = ((8, 6), (8, 2)), ((4, 2), (4, 6))
    tops: tuple[Side, Side] = ((12, 6), (8, 6)), ((4, 6), (0, 6))
    shown.equal("walls at the distance 4, $r = 1$, meet for $s$ in", _parallel(*walls), "[2, 2]")
    shown.equal("scales of their events by the oracle for discs",
                sorted({exact(touch.root) for touch in touches(*walls, 1)}), [2])  # fmt: skip
    shown.equal("the tops beside them, always on one line, meet for $s$ in", _parallel(*tops),
                "empty")  # fmt: skip
    shown.equal("case of an end of one on the line of the other",
                end_on_line(0, tops[0], tops[1], 1).case, "always")  # fmt: skip


def _parallel(a: Side, b: Side) -> str:
    """For the radius 1, by the code; raises AssertionError where the symbolic oracle has another
    one."""
    rows = moving(a, 1).numbers, moving(b, 1).numbers
    ((_, empty, low, high),) = _core.pair_intervals([rows])
    found = None if empty else (low, high)
    if found != contact_interval(*rows):
        raise AssertionError((a, b, found))
    return "empty" if found is None else f"[{found[0]}, {found[1]}]"


@CHAPTER.entry(
    "disc-degree-of-scales",
    "The scales are irrational",
    place="Appendix, segments with segments",
    status=Status.INCOMPLETE,
    printed=r"""The crossing is set equal to each of the ends in turn, and solved for $s$.""",
    right=r"""The equation is linear, over the field of the lengths $l_1$ and $l_2$ of the
    edges: with $A = (p_1 - p_2) \times d_2$ and $B = d_1 \cdot d_2$ the end $p_1$ comes to the
    second line at $s = A l_1 (l_1 l_2 + B) / (r (d_1 \times d_2)^2)$. For a polygon with rational
    coordinates that is an algebraic number of degree 1, 2 or 4, which is in general neither a
    rational nor a double.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra the formula solves the condition. An instance of the symbolic oracle has
    the degree 4: its polynomial is compared with that of sympy, and found irreducible; the edges
    themselves touch there. Degrees of 150 random pairs by the oracle."""
    k, m, A, B = sp.symbols("l_1 l_2 A B", positive=True)
    scale = A * k * (k * m + B) / (r * (k**2 * m**2 - B**2))
    condition = A / m + s * r * B / (k * m) - s * r
    shown.identity("the formula, in $n_2 \\cdot (p_1 + s r n_1 - p_2) = s r$",
                   condition.subs(s, scale))  # fmt: skip
    d, e = _vector("d"), _vector("e")
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


@CHAPTER.entry(
    "disc-circles-touch",
    "Two circles touch in the middle of their centres",
    place="Appendix, arcs with arcs",
    status=Status.HOLDS,
    printed=r"""Circles of one radius touch in the midpoint of their centres, which stays where it
    is; they meet on the line through it that is perpendicular to that of the centres, and not at
    all below.""",
    right=r"""So it is, at $s_0 = |c_1 - c_2| / (2 r)$: $s_0^2$ is rational, $s_0$ of degree 1 or 2.
    It is an event of the arcs only if the midpoint lies on both.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra; one pair by the symbolic oracle."""
    a, b = _vector("a"), _vector("b")
    x, y = sp.symbols("x y", real=True)
    difference = (x - a[0]) ** 2 + (y - a[1]) ** 2 - (x - b[0]) ** 2 - (y - b[1]) ** 2
    on_line = 2 * (b - a).dot(sp.Matrix([x, y]) - (a + b) / 2)
    shown.identity("difference of the circles' equations: the line through the midpoint, at right "
                   "angles", difference - on_line)  # fmt: skip
    root = circles(_corner((0, 0), (4, -3), (4, 3)), _corner((6, 1), (-4, 3), (-4, -3)), 1)
    shown.equal("centres $(0, 0)$ and $(6, 1)$, $r = 1$: minimal polynomial of $s_0$",
                root.polynomial, (4, 0, -37))  # fmt: skip


@CHAPTER.entry(
    "disc-magnitude",
    "How far the crossings of two circles have moved",
    place="Appendix, arcs with arcs",
    status=Status.MISPRINT,
    printed=r"""From $r^2 + (y - y_c)^2 = (s r)^2$: $y = \sqrt{(s^2 - 1) r} + y_c$, and
    $\sqrt{(s^2 - s_0^2) r} + y_c$ for a contact at $s_0$. How far the radical reaches, and whether
    $r$ is squared under it, the text that was at hand does not show beyond doubt.""",
    right=r"""$y = r \sqrt{s^2 - s_0^2} + y_c$, so $r^2$ under the radical. With $r$ the squares
    differ by $r (1 - r) (s^2 - s_0^2)$: right for $r = 1$ only.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra, and at a pair of circles with rational crossings."""
    t = sp.Symbol("s_0", positive=True)
    shown.identity("$(s_0 r)^2 + (r \\sqrt{s^2 - s_0^2})^2 = (s r)^2$",
                   (t * r) ** 2 + r**2 * (s**2 - t**2) - (s * r) ** 2)  # fmt: skip
    shown.identity("printed square less the right one is $r (1 - r) (s^2 - s_0^2)$",
                   (s**2 - t**2) * (r - r**2) - r * (1 - r) * (s**2 - t**2))  # fmt: skip
    scale, radius = sp.Rational(5, 4), 4
    printed, right = (sp.sqrt((scale**2 - 1) * x) for x in (radius, radius**2))
    shown.different("$r = 4$, $s = 5/4$, centres $(0, 0)$ and $(8, 0)$: height of the crossing",
                    printed, right)  # fmt: skip
    found = (4**2 + right**2, (8 - 4) ** 2 + right**2, (scale * radius) ** 2)
    shown.equal("squared distances of $(4, 3)$ to both centres, and $(s r)^2$", found,
                (25, 25, 25))  # fmt: skip


@CHAPTER.entry(
    "disc-crossing-of-circles",
    "Where two circles cross",
    place="Appendix, arcs with arcs",
    status=Status.FALSE,
    printed=r"""$I(s) = M(s) (\pm \perp (c_1, c_2))$ with $M(s) = \sqrt{(s^2 - s_0^2) r} +
    y_{c_1}$.""",
    right=r"""$I(s) = \frac{c_1 + c_2}{2} \pm r \sqrt{s^2 - s_0^2} \, n$, $n$ a unit vector
    perpendicular to $c_2 - c_1$. Three things differ: the midpoint is missing; $y_{c_1}$ belongs to
    the coordinates of the derivation, with $c_1$ in a special place, and not to the length; and $r$
    under the radical, as above.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra the right form has the distance s r from both centres. One pair of
    circles with rational crossings, with the radical mended in the printed form."""
    c, d, n = _vector("c"), sp.Symbol("d", positive=True), _unit("t")
    other = c + d * _normal(n)
    h = r * sp.sqrt(s**2 - (d / (2 * r)) ** 2)
    x = (c + other) / 2 + h * n
    for name, centre in (("c_1", c), ("c_2", other)):
        gap = x - centre
        shown.identity(f"$|I(s) - {name}|^2 = (s r)^2$", gap.dot(gap) - (s * r) ** 2)
    a, b, length = sp.Matrix([0, 1]), sp.Matrix([6, 1]), sp.Integer(4)  # r = 5, s = 1
    n = sp.Matrix([0, 1])
    printed, right = (length + a[1]) * n, (a + b) / 2 + length * n
    shown.different("centres $(0, 1)$ and $(6, 1)$, $r = 5$, $s = 1$: the upper crossing",
                    tuple(printed), tuple(right))  # fmt: skip
    found = [tuple((x - centre).dot(x - centre) for centre in (a, b)) for x in (printed, right)]
    shown.equal("squared distances of both from the centres", found, [(16, 52), (25, 25)])


@CHAPTER.entry(
    "disc-ends-of-arcs",
    "How many solutions an end of an arc has",
    place="Appendix, arcs with arcs",
    status=Status.CONDITION,
    printed=r"""Setting $I(s)$ equal to the ends of the arc gives 0, 1 or 2 solutions.""",
    right=r"""For both ends of an arc together. Each end $v + s r m$ has at most one: with $D = v -
    v'$ it is on the circle about $v'$ where $|D|^2 + 2 s r m \cdot D = 0$, which is linear, so at
    $s = -|D|^2 / (2 r m \cdot D)$ if $m \cdot D < 0$. Again $s^2$ is rational. No crossing of
    circles needs to be computed for it.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra. Three arcs about one vertex have ends that come to a circle 0, 1 and 2
    times, by the formula and by the symbolic oracle."""
    D, m = _vector("D"), _unit("t")
    x = D + s * r * m
    condition = x.dot(x) - (s * r) ** 2
    shown.identity("the condition is $|D|^2 + 2 s r m \\cdot D$",
                   condition - D.dot(D) - 2 * s * r * m.dot(D))  # fmt: skip
    shown.identity("it holds at $s = -|D|^2 / (2 r m \\cdot D)$",
                   condition.subs(s, -D.dot(D) / (2 * r * m.dot(D))))  # fmt: skip
    target = _corner((0, 0), (3, -4), (4, 3))
    for normals, wanted in (
        (((0, -5), (4, 3)), ()),
        (((0, 5), (-4, 3)), (Fraction(15, 4),)),
        (((-3, 4), (-4, -3)), (Fraction(15, 4), Fraction(5))),
    ):
        arc = _corner((6, 0), *normals)
        by_formula = tuple(sorted(Fraction(-36, 2 * 6 * x) * 5 for x, _ in normals if x < 0))
        roots = [end_on_circle(1, arc[:2], target, 1), end_on_circle(0, arc[1:], target, 1)]
        told = sorted(exact(x) for x in roots if x.case == "once")
        same = told == [sp.Rational(str(x)) for x in by_formula]
        shown.true(f"arc about $(6, 0)$ from the direction {normals[0]} to {normals[1]}: oracle "
                   "and formula agree", same)  # fmt: skip
        shown.equal("scales at which an end of it is on the circle about $0$, $r = 1$",
                    by_formula or "none", wanted or "none")  # fmt: skip


@CHAPTER.entry(
    "disc-events-of-arcs",
    "Events of two arcs",
    place="Appendix, arcs with arcs",
    status=Status.INCOMPLETE,
    printed=r"""Events are the contact of the circles, and those at the ends of the arcs.""",
    right=r"""The two crossings have to be kept apart. Seen from a centre they are at the angles
    $\pm \varphi$ with $\cos \varphi = s_0 / s$, which grows from 0 to a right angle, so each lies
    on both arcs in one interval of scales, or in none. Both begin at $s_0$ where the midpoint is on
    both arcs; each then ends by itself, so two arcs may have three events. Where the midpoint is
    not on both, one crossing at most is ever there, since an arc of less than 180 degrees that has
    places on both sides of the middle has the middle.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra the angle grows. Two arcs with three events, and 150 random pairs, by the
    symbolic oracle: those that touch as circles do, have three scales at most, others two."""
    t = sp.Symbol("s_0", positive=True)
    growth = sp.diff(sp.acos(t / s), s)
    shown.identity(r"$d \varphi / d s = s_0 / (s \sqrt{s^2 - s_0^2})$",
                   growth - t / (s * sp.sqrt(s**2 - t**2)))  # fmt: skip
    a = _corner((0, 0), (3, -4), (4, 3))
    b = _corner((6, 0), (-3, 4), (0, -1))
    scales = {exact(touch.root) for touch in touches(a, b, 1)}
    shown.equal("events of arcs about $(0, 0)$ and $(6, 0)$, $r = 1$", sorted(scales),
                [3, sp.Rational(15, 4), 5])  # fmt: skip
    marks = [(Fraction(3), y) for y in (Fraction(0), Fraction(9, 4), Fraction(-4))]
    shown.draw("the arcs at the scales 3, 15/4 and 5: one crossing is there from 3 to 15/4, the "
               "other from 3 to 5", arcs_at([a, b], (3, 3.75, 5), marks))  # fmt: skip
    dice = random.Random(SEED)
    most = {True: 0, False: 0}
    kept = 0
    while kept < 150:
        first, second = _drawn_corner(dice), _drawn_corner(dice)
        if first[1] == second[1]:
            continue
        kept += 1
        found = touches(first, second, 1)
        number = len({touch.root for touch in found})
        as_circles = any(touch.name == "circles" for touch in found)
        most[as_circles] = max(most[as_circles], number)
    shown.equal("most events of 150 random pairs: of those whose circles touch on both arcs, and "
                "of the others", (most[True], most[False]), (3, 2))  # fmt: skip


def _drawn_corner(dice: random.Random) -> Corner:
    start = dice.randrange(12)
    turn = dice.randint(1, 5)
    at = dice.randint(-8, 8), dice.randint(-8, 8)
    return _corner(at, FIVES[start], FIVES[(start + turn) % 12])


@CHAPTER.entry(
    "disc-tangent-line",
    "When the circle of an arc touches an offset edge",
    place="Appendix, arcs with segments",
    status=Status.CONDITION,
    printed=r"""The points $c \pm s r (\perp l)$ of the circle are set equal to the foot on the
    line; solved for $s$ that gives the event $s_0$.""",
    right=r"""With $g = n \cdot c - h$, the distance of the centre from the edge of $P$, the circle
    meets the line $n \cdot x = h + s r$ where $|g - s r| \le s r$. For $c - s r n$ this gives
    $s_0 = g / (2 r)$, an event if $g > 0$: the circle and the line meet for $s \ge s_0$. For
    $g < 0$ they never meet. For $g = 0$ they touch at all scales, which is what $c + s r n$ gives,
    and nothing else.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra; and the three cases by the symbolic oracle."""
    n, c, h = _unit("t"), _vector("c"), sp.Symbol("h", real=True)
    g = n.dot(c) - h
    shown.identity("$c - s r n$ is on the line at $s = g / (2 r)$",
                   (n.dot(c - s * r * n) - h - s * r).subs(s, g / (2 * r)))  # fmt: skip
    shown.identity("$c + s r n$ is beside it by $g$ at all scales",
                   n.dot(c + s * r * n) - h - s * r - g)  # fmt: skip
    q = sp.Symbol("g", real=True)
    shown.identity("$(s r)^2 - (g - s r)^2 = g (2 s r - g)$",
                   (s * r) ** 2 - (q - s * r) ** 2 - q * (2 * s * r - q))  # fmt: skip
    floor: Side = ((10, 0), (-10, 0))
    arcs = [_corner((0, y), (-4, -3), (4, -3)) for y in (3, 0, -3)]
    roots = [circle_on_line(arc, floor, 1) for arc in arcs]
    shown.equal("centres above, on and below an edge: cases", [root.case for root in roots],
                ["once", "always", "never"])  # fmt: skip
    shown.equal("the scale of the first, $g = 3$ and $r = 1$", exact(roots[0]), sp.Rational(3, 2))


@CHAPTER.entry(
    "disc-line-moves",
    "Where the circle of an arc crosses an offset edge",
    place="Appendix, arcs with segments",
    status=Status.FALSE,
    printed=r"""The crossings are sought on the tangent line $x_0 = x_c - s_0 r$, by the equation of
    the circle of radius $s r$. Taken at its word, with this line, that puts them at $r \sqrt{s^2 -
    s_0^2}$ from the foot, as for two arcs. No formula is given.""",
    right=r"""The edge is offset as the disc grows, so the line does not stay: it is at the distance
    $|g - s r|$ from the centre. The crossings are $c - (g - s r) n \pm \sqrt{g (2 s r - g)} \, t$,
    $t$ along the edge. The square of the printed length is too great by $(2 s r - g)(2 s r - 3 g) /
    4$, which is zero at the event and at $s = 3 s_0$ only.""",
    code=ORACLE,
)  # fmt: skip
def _(shown: Shown) -> None:
    """By computer algebra the right places are on circle and line. One arc and edge with rational
    crossings."""
    g = sp.Symbol("g", positive=True)
    n, c = _unit("t"), _vector("c")
    x = c - (g - s * r) * n + sp.sqrt(g * (2 * s * r - g)) * _normal(n)
    shown.identity("the place is on the circle", (x - c).dot(x - c) - (s * r) ** 2)
    shown.identity("and on the line", n.dot(x) - (n.dot(c) - g) - s * r)
    printed = r**2 * (s**2 - (g / (2 * r)) ** 2)
    right = g * (2 * s * r - g)
    shown.identity("printed square less the right one is $(2 s r - g)(2 s r - 3 g)/4$",
                   printed - right - (2 * s * r - g) * (2 * s * r - 3 * g) / 4)  # fmt: skip
    at = {g: 2, s: 5, r: 1}
    shown.different("$g = 2$, $r = 1$, $s = 5$: square of the length", printed.subs(at),
                    right.subs(at))  # fmt: skip
    shown.equal("centre $(0, 2)$, line $y = 5$: squared distance of $(4, 5)$ from the centre, and "
                "$(s r)^2$", (4**2 + (5 - 2) ** 2, 5**2), (25, 25))  # fmt: skip
    ring = [(-10, -1), (10, -1), (10, 0), (-10, 0)]
    shown.draw("the circle about $(0, 2)$ and the edge, offset by 1, where they touch, and by 5",
               swept(ring, [1.0, 5.0], [(0.0, 2.0, 1.0), (0.0, 2.0, 5.0)]))  # fmt: skip


@CHAPTER.entry(
    "disc-kinds-of-events",
    "What kinds of events of two features there are",
    place="Appendix",
    status=Status.INCOMPLETE,
    printed=r"""Events are those of arcs with arcs, segments with segments, and segments with arcs,
    each with conditions of its own; their numbers are not spoken of.""",
    right=r"""The ends of the arcs are ends of offset edges, so four conditions are all: an end on a
    line, of degree up to 4; an end on a circle, a circle and a line, two circles, up to 2, where
    $s^2$ is rational. An end $p + s r n$ of the edge itself is on a circle at $s = |p - c|^2 / (2 r
    g)$. An end that is shared by an edge and an arc gives an event of both.""",
    code=(*ORACLE, "oracle/symbolic/solutions.json"),
)
def _(shown: Shown) -> None:
    """Degrees of the polynomials without lengths, which the symbolic oracle has for general data by
    resultants. All events of eight random polygons by the oracle: their minimal polynomials."""
    degrees = greatest_degrees()
    for name in ("end on line", "end on circle", "circle on line", "circles"):
        shown.tell(f"{name}: degree {degrees[name]} at most.")
    shown.equal(
        "greatest degree of a pair", max(x for k, x in degrees.items() if "three" not in k), 4
    )
    n, w, g = _unit("t"), _vector("w"), sp.Symbol("g", positive=True)
    x = w + s * r * n
    shown.identity("with $w = p - c$ and $g = -n \\cdot w$: the end of an edge is on the circle "
                   "where $|w|^2 - 2 s r g = 0$",
                   x.dot(x) - (s * r) ** 2 - w.dot(w) + 2 * s * r * -n.dot(w))  # fmt: skip
    shown.identity("that is at $|w|^2 / (2 r g)$",
                   (w.dot(w) - 2 * s * r * g).subs(s, w.dot(w) / (2 * r * g)))  # fmt: skip
    dice = random.Random(SEED)
    counts: Counter[tuple[str, int]] = Counter()
    for _ in range(8):
        for touch in ring_touches(_drawn_ring(dice), 1):
            found = touch.root.polynomial
            counts[touch.name, len(found) - 1] += 1
            if touch.name != "end on line" and len(found) == 3 and found[1] != 0:
                raise AssertionError(touch)
    for (name, degree), count in sorted(counts.items()):
        shown.tell(f"random polygons, {name}, degree {degree}: {count} of the events.")
    shown.true("none is beyond these degrees, and but for an end on a line $s^2$ is rational",
               all(degree <= degrees[name] for name, degree in counts))  # fmt: skip


def _drawn_ring(dice: random.Random) -> list[tuple[int, int]]:
    """A box with a pocket: the bottom of it, and how far its walls lean, are random."""
    u, v = (dice.randint(2, 5) for _ in "uv")
    depth = dice.randint(2, 6)
    left, right = -u - dice.randint(-1, 3), v + dice.randint(-1, 3)
    tops = dice.randint(7, 9), dice.randint(7, 9)
    return [(-12, 0), (12, 0), (12, 6), (v, tops[0]), (right, depth), (left, depth), (-u, tops[1]),
            (-12, 6)]  # fmt: skip


# A floor, and tips 4 and 5 above it.
WELL = [(-6, -3), (14, -3), (14, 5), (5, 5), (10, 0), (-2, 0), (0, 4), (-6, 4)]


@CHAPTER.entry(
    "disc-triple-events",
    "Three curves through one point",
    place="Appendix",
    status=Status.INCOMPLETE,
    printed=r"""The events of the three kinds of pairs are all, with which the convolution is
    updated.""",
    right=r"""As for polygons, the order along a curve also changes, and holes end, where three
    curves pass through one point. For three lines the scale is of degree up to 8; for three circles
    $s^2$ is the squared circumradius over $r^2$, a rational; two circles and a line, or a circle
    and two lines, give a quadratic equation over the field of the lengths.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """A polygon with two tips above a floor: by computer algebra the equation of its triple event
    and the root $117 - 10 \\sqrt{130}$; the disc is empty, from exact distances; and no event of
    two features of the polygon is there. The degrees of the other kinds by the symbolic oracle,
    or by computer algebra with symbols for all data."""
    x = sp.Symbol("x", real=True)
    (a, b), tips = (0, 4), (5, 5)
    first = (x - a) ** 2 + (s - b) ** 2 - s**2
    second = (x - tips[0]) ** 2 + (s - tips[1]) ** 2 - s**2
    equation = sp.Poly(sp.resultant(first, second, x), s).primitive()[1]
    shown.equal("tips $(0, 4)$ and $(5, 5)$ over the floor $y = 0$: coefficients of the equation",
                tuple(int(k) for k in equation.all_coeffs()), (1, -234, 689))  # fmt: skip
    value = 117 - 10 * sp.sqrt(130)
    place = ((34 - 2 * value) / 10, value)
    shown.identity(f"${sp.latex(value)}$ is a root", equation.as_expr().subs(s, value))
    shown.identity("squared distance of the centre to the polygon, less the squared radius",
                   squared_distance(place, WELL) - value**2)  # fmt: skip
    pairs = [touch.root.polynomial for touch in ring_touches(WELL, 1)]
    shown.true(f"none of its {len(pairs)} events of pairs has that scale",
               (1, -234, 689) not in pairs and len(pairs) > 10)  # fmt: skip
    u, v = float(place[0]), float(value)
    shown.draw("the offset curves at that scale, and the disc that touches three features",
               swept(WELL, [v], [(u, v, v)]))  # fmt: skip
    root = three_lines((((2, 1), (0, 0)), ((8, 5), (9, 2)), ((1, 4), (3, 7))), 1)
    turned = three_lines((((0, 0), (2, 1)), ((9, 2), (8, 5)), ((3, 7), (1, 4))), 1)
    degree = max(len(root.polynomial), len(turned.polynomial)) - 1
    shown.equal("three lines with squared lengths 5, 10 and 13: degree", degree, 8)
    corners = [corner([(0, 0), (7, 1), (3, 5)], k) for k in range(3)]
    found = three_circles(corners, 1)
    shown.equal("circles about $(0, 0)$, $(7, 1)$ and $(3, 5)$: minimal polynomial of $s$",
                found.polynomial, _circumradius([c[1] for c in corners]))  # fmt: skip
    # In coordinates along the first line.
    p, q, m = _vector("p"), _vector("q"), _vector("m")
    h = sp.Symbol("h", real=True)
    for what, normal, offset in (
        ("two circles and a line", q - p, (q.dot(q) - p.dot(p)) / 2),
        ("a circle and two lines", m, h + s * r),
    ):
        at = sp.Matrix([(offset - normal[1] * s * r) / normal[0], s * r])
        equation = sp.Poly(sp.expand((at - p).dot(at - p) - (s * r) ** 2), s)
        shown.equal(f"{what}, symbols for all data: degree in $s$", equation.degree(), 2)


def _circumradius(places: list[tuple[int, int]]) -> tuple[int, ...]:
    """The primitive polynomial $a s^2 - b$ of the radius, from the sides and the area."""
    a, b, c = places
    squares = [(u[0] - v[0]) ** 2 + (u[1] - v[1]) ** 2 for u, v in combinations(places, 2)]
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    square = Fraction(squares[0] * squares[1] * squares[2], 4 * area**2)
    return square.denominator, 0, -square.numerator
