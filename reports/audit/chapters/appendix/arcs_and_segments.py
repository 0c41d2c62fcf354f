"""Arcs with line segments, and events of all kinds."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from itertools import combinations

import sympy as sp
from minkref.fuzz.judges.disc.paper_disc import Edge as Side
from minkref.fuzz.judges.disc.paper_disc import (
    circle_on_line,
    greatest_degrees,
    ring_touches,
    three_circles,
    three_lines,
)
from minkref.reports.audit.disc import corner, exact, squared_distance
from minkref.reports.audit.disc_code import (
    CODE,
    code_events,
    contacts_of_ring,
    polynomials_of_boundary,
    scales_by_both,
)
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status, text
from minkref.reports.audit.sketches import swept
from minkref.reports.audit.symbolic_disc import corner_of_normals, normal, r, s, unit, vector

PART = Chapter("appendix", "Appendix: a scaling disc")
SEED = 12
ORACLE = ("oracle/symbolic/disc/disc.py", "oracle/symbolic/disc/derive_disc.py")


@PART.entry(
    "disc-tangent-line",
    "When the circle of an arc touches an offset edge",
    place="Appendix, arcs with segments",
    status=Status.CONDITION,
    printed=r"""The points $c \pm s r (\perp l)$ of the circle are set equal to the foot on the
    line; solved for $s$ that gives the event $s_0$.""",
    right=r"""With $g = n \cdot c - h$, the distance of the centre from the edge of $P$, the circle
    meets the line $n \cdot x = h + s r$ where $|g - s r| \le s r$. For $c - s r n$ this gives
    $s_0 = g / (2 r)$, an event if $g > 0$: the circle and the line meet for $s \ge s_0$. For
    $g < 0$ they never meet. For $g = 0$ they touch at all scales; that is the only case in which
    $c + s r n$ is on the line.""",
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra; and the three cases by the symbolic oracle and the code."""
    n, c, h = unit("t"), vector("c"), sp.Symbol("h", real=True)
    g = n.dot(c) - h
    shown.identity("$c - s r n$ is on the line at $s = g / (2 r)$",
                   (n.dot(c - s * r * n) - h - s * r).subs(s, g / (2 * r)))  # fmt: skip
    shown.identity("$c + s r n$ is beside it by $g$ at all scales",
                   n.dot(c + s * r * n) - h - s * r - g)  # fmt: skip
    q = sp.Symbol("g", real=True)
    shown.identity("$(s r)^2 - (g - s r)^2 = g (2 s r - g)$",
                   (s * r) ** 2 - (q - s * r) ** 2 - q * (2 * s * r - q))  # fmt: skip
    floor: Side = ((10, 0), (-10, 0))
    arcs = [corner_of_normals((0, y), (-4, -3), (4, -3)) for y in (3, 0, -3)]
    roots = [circle_on_line(arc, floor, 1) for arc in arcs]
    shown.equal("centres above, on and below an edge: cases", [root.case for root in roots],
                ["once", "always", "never"])  # fmt: skip
    shown.equal("the scale of the first, $g = 3$ and $r = 1$", exact(roots[0]), sp.Rational(3, 2))
    shown.equal("numbers of events of arcs that look down, and of the edge, by the code",
                [len(scales_by_both(arc, floor, 1)) for arc in arcs], [2, 0, 0])  # fmt: skip


@PART.entry(
    "disc-line-moves",
    "Where the circle of an arc crosses an offset edge",
    place="Appendix, arcs with segments",
    status=Status.INCOMPLETE,
    printed=r"""The tangent line $x_0 = x_c - s_0 r$ is considered; as $s$ varies from $s_0$ the
    intersection of “this line” and the disc is sought, by the equation of the circle of radius $s
    r$, “as we pass the line through the disc”. No formula is given, and not how the line moves.""",
    right=r"""The edge is offset as the disc grows, so the line does not stay at $x_0$: it is at the
    distance $|g - s r|$ from the centre. The crossings are $c - (g - s r) n \pm \sqrt{g (2 s r -
    g)} \, t$, $t$ a unit vector along the edge. Were the line to stay, they would be at $r
    \sqrt{s^2 - s_0^2}$ from the foot, as for two arcs, the square of which is too great by $(2 s r
    - g)(2 s r - 3 g) / 4$: zero at the event and at $s = 3 s_0$ only.""",
    code=(*CODE, *ORACLE),
)  # fmt: skip
def _(shown: Shown) -> None:
    """By computer algebra the right places are on circle and line. One arc and edge with rational
    crossings, and the events of such by the code, right and with a line that stays."""
    g = sp.Symbol("g", positive=True)
    n, c = unit("t"), vector("c")
    x = c - (g - s * r) * n + sp.sqrt(g * (2 * s * r - g)) * normal(n)
    shown.identity("the place is on the circle", (x - c).dot(x - c) - (s * r) ** 2)
    shown.identity("and on the line", n.dot(x) - (n.dot(c) - g) - s * r)
    staying = r**2 * (s**2 - (g / (2 * r)) ** 2)
    right = g * (2 * s * r - g)
    shown.identity("square for a line that stays less the right one: $(2 s r - g)(2 s r - 3 g)/4$",
                   staying - right - (2 * s * r - g) * (2 * s * r - 3 * g) / 4)  # fmt: skip
    at = {g: 2, s: 5, r: 1}
    shown.equal("$g = 2$, $r = 1$, $s = 5$: square of the length for a line that stays, and right",
                (staying.subs(at), right.subs(at)), (24, 16))  # fmt: skip
    shown.equal("centre $(0, 2)$, line $y = 5$: squared distance of $(4, 5)$ from the centre, and "
                "$(s r)^2$", (4**2 + (5 - 2) ** 2, 5**2), (25, 25))  # fmt: skip
    arc = corner_of_normals((0, 2), (-4, 3), (3, -4))
    edge: Side = ((4, 0), (-4, 0))
    right_ones = scales_by_both(arc, edge, 1)
    shown.equal("an arc about $(0, 2)$ and an edge that ends at $(\\pm 4, 0)$, $r = 1$: scales of "
                "their events", right_ones, [1, sp.Rational(10, 9), 5])  # fmt: skip
    staying = code_events(arc, edge, 1, ["line"])
    shown.equal("were the line to stay", [event.scale for event in staying],
                [1, sp.Rational(5, 4)])  # fmt: skip
    shown.equal("points shared in truth just before, at and after the second of these",
                staying[1].shared, (1, 1, 1))  # fmt: skip
    ring = [(-10, -1), (10, -1), (10, 0), (-10, 0)]
    shown.draw("the circle about $(0, 2)$ and the edge, offset by 1, where they touch, and by 5",
               swept(ring, [1.0, 5.0], [(0.0, 2.0, 1.0), (0.0, 2.0, 5.0)]))  # fmt: skip


@PART.entry(
    "disc-kinds-of-events",
    "What kinds of events of two features there are",
    place="Appendix",
    status=Status.INCOMPLETE,
    printed=r"""Events are those of arcs with arcs, segments with segments, and segments with arcs,
    each with conditions of its own; of what kind the scales are is not said.""",
    right=r"""The ends of the arcs are ends of offset edges, so four conditions are all: an end on a
    line, of degree up to 4; an end on a circle, a circle and a line, two circles, up to 2, where
    $s^2$ is rational. An end $p + s r n$ of the edge itself is on a circle at $s = |p - c|^2 / (2 r
    g)$. An end that is shared by an edge and an arc gives an event of both.""",
    code=(*CODE, *ORACLE, "oracle/symbolic/solutions.json"),
)
def _(shown: Shown) -> None:
    """Degrees of the polynomials without lengths, which the symbolic oracle has for general data by
    resultants. All events of eight random polygons by the oracle: their minimal polynomials; the
    code has as many."""
    degrees = greatest_degrees()
    for name in ("end on line", "end on circle", "circle on line", "circles"):
        shown.tell(f"{name}: degree {degrees[name]} at most.")
    shown.equal(
        "greatest degree of a pair", max(x for k, x in degrees.items() if "three" not in k), 4
    )
    n, w, g = unit("t"), vector("w"), sp.Symbol("g", positive=True)
    x = w + s * r * n
    shown.identity("with $w = p - c$ and $g = -n \\cdot w$: the end of an edge is on the circle "
                   "where $|w|^2 - 2 s r g = 0$",
                   x.dot(x) - (s * r) ** 2 - w.dot(w) + 2 * s * r * -n.dot(w))  # fmt: skip
    shown.identity("that is at $|w|^2 / (2 r g)$",
                   (w.dot(w) - 2 * s * r * g).subs(s, w.dot(w) / (2 * r * g)))  # fmt: skip
    dice = random.Random(SEED)
    counts: Counter[tuple[str, int]] = Counter()
    by_code = 0
    for _ in range(8):
        ring = _drawn_ring(dice)
        by_code += contacts_of_ring(ring)
        for touch in ring_touches(ring, 1):
            found = touch.root.polynomial
            counts[touch.name, len(found) - 1] += 1
            if touch.name != "end on line" and len(found) == 3 and found[1] != 0:
                raise CheckFailed(text(touch))
    for (name, degree), count in sorted(counts.items()):
        shown.tell(f"random polygons, {name}, degree {degree}: {count} of the events.")
    shown.equal("events of these polygons by the code", by_code, counts.total())
    shown.true("none is beyond these degrees, and but for an end on a line $s^2$ is rational",
               all(degree <= degrees[name] for name, degree in counts))  # fmt: skip


def _drawn_ring(dice: random.Random) -> list[tuple[int, int]]:
    """A box with a pocket; the pocket's bottom and the lean of the walls are random."""
    u, v = (dice.randint(2, 5) for _ in "uv")
    depth = dice.randint(2, 6)
    left, right = -u - dice.randint(-1, 3), v + dice.randint(-1, 3)
    tops = dice.randint(7, 9), dice.randint(7, 9)
    return [(-12, 0), (12, 0), (12, 6), (v, tops[0]), (right, depth), (left, depth), (-u, tops[1]),
            (-12, 6)]  # fmt: skip


# A floor, and tips 4 and 5 above it.
WELL = [(-6, -3), (14, -3), (14, 5), (5, 5), (10, 0), (-2, 0), (0, 4), (-6, 4)]


@PART.entry(
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
    formula="Events of two arcs or segments are all events (Section 8.2, Appendix)",
    code=("reference/disc/diagram/diagram_events.hpp", *CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """A polygon with two tips above a floor: by computer algebra the equation of its triple event
    and the root $117 - 10 \\sqrt{130}$; the disc is empty, from exact distances; no event of two
    features of the polygon is there; and the code has an event of its boundary there. The
    degrees of the other kinds by the symbolic oracle, or by computer algebra with symbols for all
    data."""
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
    y = sp.Symbol("y")
    wanted = sp.Poly(sp.minimal_polynomial(value**2, y), y).all_coeffs()[::-1]
    shown.equal("events of the boundary with a minimal polynomial of its square, by the code",
                polynomials_of_boundary(WELL).count([str(c) for c in wanted]), 1)  # fmt: skip
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
    # Use coordinates along the first line.
    p, q, m = vector("p"), vector("q"), vector("m")
    h = sp.Symbol("h", real=True)
    for what, across, offset in (
        ("two circles and a line", q - p, (q.dot(q) - p.dot(p)) / 2),
        ("a circle and two lines", m, h + s * r),
    ):
        at = sp.Matrix([(offset - across[1] * s * r) / across[0], s * r])
        equation = sp.Poly(sp.expand((at - p).dot(at - p) - (s * r) ** 2), s)
        shown.equal(f"{what}, symbols for all data: degree in $s$", equation.degree(), 2)


def _circumradius(places: list[tuple[int, int]]) -> tuple[int, ...]:
    """The primitive polynomial $a s^2 - b$ of the radius, from the sides and the area."""
    a, b, c = places
    squares = [(u[0] - v[0]) ** 2 + (u[1] - v[1]) ** 2 for u, v in combinations(places, 2)]
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    square = Fraction(squares[0] * squares[1] * squares[2], 4 * area**2)
    return square.denominator, 0, -square.numerator
