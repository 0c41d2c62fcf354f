"""Section 4: uniform scaling in the plane."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from itertools import product
from math import lcm
from typing import Any

import sympy as sp
from minkref import _core
from minkref.fuzz.geometry.plane import cross, in_box, turn
from minkref.fuzz.plane.families.drawing import convex
from minkref.model_catalogue import all_models, or_look_alike
from minkref.plane.operand import read_operand
from minkref.reports.audit.edges import (
    Answers,
    Edge,
    Interval,
    answers,
    s_edge,
    symbolic_interval,
    t_edge,
    written,
)
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status
from minkref.reports.audit.pictures import moving_edges
from minkref.reports.audit.plane import box, operand, random_operand, rings_of
from minkref.reports.audit.symbolic_edges import ends, kinds_of, moving

CHAPTER = Chapter("section-4", "Section 4: uniform scaling in the plane")
KINDS = ("SS", "ST", "TT")
s = sp.Symbol("s", positive=True)
SEED = 4
Point = tuple[Fraction, Fraction]
DRAWS = 400


def _drawn(dice: random.Random, kind: str, size: int = 6) -> Edge:
    """A random edge with a nonzero direction."""
    p, q = ((dice.randint(-size, size), dice.randint(-size, size)) for _ in "pq")
    while True:
        d = dice.randint(-size, size), dice.randint(-size, size)
        if d != (0, 0):
            return Edge(kind, p, q, d)


def _pairs(count: int) -> list[tuple[Edge, Edge]]:
    """`count` random pairs per kind, none parallel."""
    dice = random.Random(SEED)
    found: list[tuple[Edge, Edge]] = []
    for kinds in KINDS:
        kept = 0
        while kept < count:
            pair = _drawn(dice, kinds[0]), _drawn(dice, kinds[1])
            if cross(pair[0].d, pair[1].d) != 0:
                found.append(pair)
                kept += 1
    return found


def _parallel_pairs(count: int) -> list[tuple[Edge, Edge]]:
    """`count` parallel pairs per kind; every second pair lies on one line at all scales."""
    dice = random.Random(SEED)
    found: list[tuple[Edge, Edge]] = []
    for kinds in KINDS:
        for k in range(count):
            a = _drawn(dice, kinds[0], 3)
            factor = dice.choice((-2, -1, 1, 2))
            d = factor * a.d[0], factor * a.d[1]
            if k % 2:
                found.append((a, Edge(kinds[1], _drawn(dice, "S", 3).p, _drawn(dice, "S", 3).q, d)))
                continue
            u, v = (dice.randint(-3, 3) for _ in "pq")
            p = a.p[0] + u * a.d[0], a.p[1] + u * a.d[1]
            q = a.q[0] + v * a.d[0], a.q[1] + v * a.d[1]
            found.append((a, Edge(kinds[1], p, q, d)))
    return found


@CHAPTER.entry(
    "constant-convolution",
    "The edges of the convolution are the same at all scales",
    place="Sections 3 and 4",
    status=Status.HOLDS,
    printed=r"""Where $P$ is scaled uniformly the normals of its edges stay, so that the structure
    of the reduced convolution does not change; the lengths and places of its edges do.""",
    right=r"""So it is: which edge is compatible with which vertex goes by directions alone, also
    where edges are parallel, and a positive factor keeps them.""",
    code=("reference/plane/convolution/convolution.hpp",),
)
def _(shown: Shown) -> None:
    """The convolutions of sixty random pairs, with parallel edges, at four random scales each: the
    same edges at the same vertices."""
    dice = random.Random(SEED)
    count = 0
    same = True
    for _ in range(60):
        P, Q = random_operand(dice), random_operand(dice)
        edges = _core.reduced_convolution(P, Q)
        for _ in range(4):
            scale = Fraction(dice.randint(1, 50), dice.randint(1, 50))
            same &= _core.reduced_convolution(P.scaled(str(scale)), Q) == edges
            count += len(edges)
    shown.true(f"240 convolutions with {count:,} edges together: as at the scale 1", same)


@CHAPTER.entry(
    "intersection-parameter",
    "The parameter of the intersection of two lines",
    place="Section 4.1, Observation 1",
    status=Status.MISPRINT,
    printed=r"""For $l_a(r) = a_0 + r v$, $l_b(t) = b_0 + t w$ and $u = a_0 - b_0$ the lines meet at
    $r_I = \frac{v_y u_x - v_x u_x}{v_x w_y - v_y w_x}$ on $l_a$.""",
    right=r"""$r_I = \frac{w_x u_y - w_y u_x}{v_x w_y - v_y w_x}$. Three things differ: the second
    $u_x$ has to be $u_y$; with that the formula is minus the parameter $t$ on $l_b$, so $v$ has to
    be $w$; and with that it still has the other sign, for the order of the difference $u$.""",
    code=("reference/plane/critical/line_intersection.hpp",),
)
def _(shown: Shown) -> None:
    """By computer algebra the point $a_0 + r v$ of the right form lies on $l_b$, for all $a_0$,
    $b_0$, $v$ and $w$; each step of the correction is an identity. At one pair of lines both forms
    of the code are evaluated."""
    a = sp.Matrix(sp.symbols("a_x a_y"))
    b = sp.Matrix(sp.symbols("b_x b_y"))
    v = sp.Matrix(sp.symbols("v_x v_y"))
    w = sp.Matrix(sp.symbols("w_x w_y"))
    u, den = a - b, cross(v, w)
    right = cross(w, u) / den
    t = cross(v, u) / den
    shown.identity("$a_0 + r v$ on $l_b$", cross(a + right * v - b, w))
    shown.identity("$a_0 + r v = b_0 + t w$", a + right * v - b - t * w)
    once = (v[1] * u[0] - v[0] * u[1]) / den
    shown.identity("with $u_y$ for $u_x$, the printed form is $-t$", once + t)
    twice = (w[1] * u[0] - w[0] * u[1]) / den
    shown.identity("with $w$ for $v$ as well, it is $-r$", twice + right)
    printed, corrected = (
        _core.observation_1(("2", "1"), ("1", "3"), ("-4", "1"), form)
        for form in ("printed", "corrected")
    )
    shown.different(
        "$v = (2, 1)$, $w = (1, 3)$, $u = (-4, 1)$", Fraction(printed), Fraction(corrected)
    )
    shown.equal("the place on $l_a$ from $a_0$ and on $l_b$ from $b_0$, $t = 6/5$",
                (2 * Fraction(corrected), Fraction(corrected)),
                (4 + Fraction(6, 5), -1 + 3 * Fraction(6, 5)))  # fmt: skip


@CHAPTER.entry(
    "parallel-lines",
    "Parallel edges",
    place="Sections 4.1 and 4.2",
    status=Status.INCOMPLETE,
    printed=r"""The intersection of $l_a$ and $l_b$ is a quotient with the denominator $v_x w_y -
    v_y w_x$. Parallel edges are not spoken of.""",
    right=r"""With $d$ the common direction, $m = d \times (p_b - p_a)$ and $n = d \times (q_b -
    q_a)$ the lines coincide where $m s + n = 0$: always, never, or at the one scale $-n/m$, which
    counts if it is positive. On a line that they have at all scales two edges meet in an interval
    of scales, which the order of their ends along it bounds. Where two edges come to one line a
    hole may close all at once.""",
    code=("reference/plane/critical/parallel_pair.hpp",),
)
def _(shown: Shown) -> None:
    """By computer algebra the quotient has the denominator zero at all scales, and the one line is
    off the other by $m s + n$. One pair of each kind: the code and the symbolic oracle agree. A box
    that fills a hole in one direction."""
    for kinds in product("ST", repeat=2):
        a, b = kinds_of("".join(kinds))
        b = replace(b, d=a.d)
        name = "".join(kinds)
        shown.identity(f"{name}: the denominator, for one direction", cross(a.span(s), b.span(s)))
        m, n = cross(a.d, b.p - a.p), cross(a.d, b.q - a.q)
        shown.identity(f"{name}: $d \\times (b_0(s) - a_0(s)) = m s + n$",
                       cross(a.d, b.start(s) - a.start(s)) - m * s - n)  # fmt: skip
    always = t_edge((0, 0), (2, 0), (0, 0)), s_edge((1, 0), (2, 0), (1, 0))
    once = t_edge((0, 3), (2, 3), (0, 0)), s_edge((0, 1), (2, 1), (0, 0))
    never = t_edge((0, 3), (2, 3), (0, 1)), s_edge((0, 1), (2, 1), (0, 0))
    for what, pair, wanted in (
        ("on one line at all scales", always, "(0, 1]"),
        ("on one line at the scale 3", once, "[3, 3]"),
        ("on parallel lines at all scales", never, "empty"),
    ):
        ((_, empty, low, high),) = _core.pair_intervals([(pair[0].numbers, pair[1].numbers)])
        bounds = [None if x is None else Fraction(x) for x in (low, high)]
        found = None if empty else (bounds[0], bounds[1])
        shown.equal(f"two edges {what} meet for $s$ in", written(found), wanted)
        shown.true(
            f"the symbolic oracle agrees on the edges {what}", symbolic_interval(*pair) == found
        )
    P, Q = operand([box(0, 0, 1, 1)]), operand([box(0, 0, 9, 7), box(2, 2, 5, 3)])
    told = _core.ArrangementEvents(P, Q, "3", "3")
    parallel = [row for row in told.rows(told.of_kind("arrangement")) if row[1] == "parallel"]
    shown.equal("a box and a frame: events of parallel edges at the scale 3", len(parallel), 1)
    holes = [_core.minkowski_sum(P, Q, scale).holes for scale in ("29/10", "3", "31/10")]
    shown.equal("holes just below, at and above it", tuple(holes), (1, 0, 0))


@CHAPTER.entry(
    "moving-intersection",
    "The intersection moves along a line, at a constant rate",
    place="Section 4.2",
    status=Status.CONDITION,
    printed=r"""$x(s) = x_0 + (s - 1) \sigma$ with $\sigma = x(2) - x(1)$, for the intersection of
    the lines of two edges of the convolution.""",
    right=r"""So it is for S- and T-edges in all combinations, if the lines are not parallel: both
    lines are $n \cdot x = s \alpha + \beta$ with a constant normal $n$, and Cramer's rule has a
    constant determinant. The parameters $r$ and $t$ are not affine on S-edges: there $s r$ is.""",
    code=("reference/plane/critical/line_intersection.hpp",),
)
def _(shown: Shown) -> None:
    """By computer algebra, with symbols for all coordinates: the second derivative of x(s) is zero,
    for SS, ST and TT; that of r is not on an S-edge, and is on a T-edge."""
    for kinds in KINDS:
        a, b = kinds_of(kinds)
        x, r = moving(a, b, s)
        shown.identity(f"{kinds}: the second derivative of $x(s)$", x.diff(s, 2))
        one, two = x.subs(s, 1), x.subs(s, 2)
        shown.identity(
            f"{kinds}: $x(1) + (s-1)(x(2) - x(1)) = x(s)$", one + (s - 1) * (two - one) - x
        )
        second = sp.simplify(sp.diff(r, s, 2))
        affine = kinds == "TT"
        shown.true(f"{kinds}: $r$ on the first edge is {'' if affine else 'not '}affine in $s$",
                   (second == 0) == affine)  # fmt: skip
        if not affine:
            shown.identity(f"{kinds}: $s r$ is affine", sp.diff(s * r, s, 2))


@CHAPTER.entry(
    "contact-at-an-end",
    "Two edges start and stop meeting at an end of one of them",
    place="Section 4.2",
    status=Status.HOLDS,
    printed=r"""If two edges start to meet as $P$ scales, they do so at an end of one of them, and
    likewise where they separate.""",
    right=r"""So it is, for closed edges, also where they lie on one line. Where two edges that are
    not parallel cross between their ends they do so shortly before and after as well, for the
    parameters $r$ and $t$ are continuous; and where they lie on one line the ends alone decide. A
    pair may begin and stop meeting at one scale.""",
    code=("reference/plane/critical/pair_events.hpp",),
)
def _(shown: Shown) -> None:
    """At each end of the interval of 1,200 pairs with small integers that are not parallel and
    1,200 that are, of all kinds, an end of one edge is on the other one, exactly; the intervals are
    those of the symbolic oracle."""
    checked = 0
    for a, b in (*_pairs(DRAWS), *_parallel_pairs(DRAWS)):
        interval = symbolic_interval(a, b)
        for scale in interval or ():
            if scale is None:
                continue
            shown_at = ends(a, scale), ends(b, scale)
            on = any(_is_on(p, *other) for e, other in (shown_at, shown_at[::-1]) for p in e)
            if not on:
                raise CheckFailed(f"{a} and {b} at {scale}")
            checked += 1
    shown.true(f"{checked:,} ends of intervals: an end of one edge is on the other", checked > 600)


def _is_on(p: Point, a: Point, b: Point) -> bool:
    return turn(a, b, p) == 0 and in_box(a, b, p)


@CHAPTER.entry(
    "conditions-of-ends",
    "The condition of an end: alpha and beta",
    place="Sections 4.2.1 and 4.2.2",
    status=Status.HOLDS,
    printed=r"""$x(s) = a_0(s)$ is $s \alpha = \beta$ with $\alpha = e_{p0} - \sigma$ and
    $\beta = x_0 - \sigma - v_q$ for an S-edge, and of the same form for a T-edge.""",
    right=r"""So it is; for a T-edge $\alpha = v_p - \sigma$ and $\beta = x_0 - \sigma - e_{q0}$.
    (Where the text has $b_1 s$, $b_1(s)$ is meant.)""",
    code=("reference/plane/critical/pair_interval.hpp",),
)
def _(shown: Shown) -> None:
    """By computer algebra: $s\\alpha - \\beta = a_0(s) - x(s)$ for both kinds of the first edge."""
    for kinds in product("ST", repeat=2):
        a, b = kinds_of("".join(kinds))
        x, _ = moving(a, b, s)
        sigma = x.subs(s, 2) - x.subs(s, 1)
        p, q = a.p, a.q
        alpha, beta = p - sigma, x.subs(s, 1) - sigma - q
        gap = s * alpha - beta - (a.start(s) - x)
        shown.identity(f"{''.join(kinds)}, first coordinate", gap[0])
        shown.identity(f"{''.join(kinds)}, second coordinate", gap[1])


@CHAPTER.entry(
    "overdetermined",
    "The conditions are called overdetermined",
    place="Sections 4.2.1 and 4.2.2",
    status=Status.CONDITION,
    printed=r"""$s \alpha = \beta$ is an overdetermined system; there is no solution for $s$ if it
    is inconsistent, and otherwise it gives a bound.""",
    right=r"""It is two equations with one unknown, and in exact numbers the words are right. But
    $\alpha$ and $\beta$ are always multiples of the edge's direction, so that the two are one
    linear equation. It has no solution only if the slope is zero and the constant is not: then $x$
    moves with the end and never reaches it. If both are zero, $x$ is the end at every scale, of
    which the text does not speak. In floating point, which the implementation of the paper uses
    (MPFR), they are multiples only nearly: a test whether both equations have one solution rejects
    many that do, for some operands nearly all, and more bits do not help.""",
    code=("reference/plane/critical/scale_solve.hpp",),
)
def _(shown: Shown) -> None:
    """By computer algebra $\\alpha \\times d = \\beta \\times d = 0$. Then the conditions of all
    pairs of edges of small models, in doubles, in MPFR with 200 bits and in rational numbers: of
    those that have a solution, how many the test for consistency, without a tolerance, rejects, and
    how many the one equation does."""
    for kinds in product("ST", repeat=2):
        a, b = kinds_of("".join(kinds))
        x, _ = moving(a, b, s)
        sigma = x.subs(s, 2) - x.subs(s, 1)
        name = "".join(kinds)
        shown.identity(rf"{name}: $\alpha \times d$", cross(a.p - sigma, a.d))
        shown.identity(rf"{name}: $\beta \times d$", cross(x.subs(s, 1) - sigma - a.q, a.d))
    for names, words, arithmetic in (
        (("g1", "dog145"), "in doubles", "double"),
        (("g1", "g2"), "in doubles", "double"),
        (("g1", "g2"), "in MPFR with 200 bits", "mpfr:200"),
        (("g1", "g2"), "in rationals", "rational"),
    ):
        P, Q = (read_operand(name).set for name in names)
        found = [_core.precision_trial(P, Q, arithmetic, form) for form in ("printed", "corrected")]
        rejected, other = (int(each["false_inconsistent"]) for each in found)
        roots = int(found[0]["roots"])
        shown.true(
            f"{' and '.join(names)} {words}: of {roots:,} conditions with a solution the test for "
            f"consistency rejects {rejected:,}, the one equation {other:,}",
            other == 0 and (rejected == 0 if arithmetic == "rational" else 2 * rejected > roots),
        )


INTERVALS: tuple[tuple[str, Edge, Edge, str, str], ...] = (
    ("TT", t_edge((3, 3), (0, 4), (-4, -4)), t_edge((2, -3), (-6, 6), (-3, 2)), "empty",
     "[2/3, 1]"),
    ("SS", s_edge((3, 6), (6, -5), (-2, -5)), s_edge((1, 6), (1, 1), (4, 0)), "empty",
     "[81/37, 3]"),
    ("ST", s_edge((-5, 2), (4, -4), (-4, 6)), t_edge((-4, -4), (-1, -2), (-5, 5)),
     "empty", "[2, 10/3]"),
)  # fmt: skip


@CHAPTER.entry(
    "interval-of-a-pair",
    "The interval in which two edges meet",
    place="Section 4.2.3",
    status=Status.LITERAL,
    printed=r"""$[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1}, B_{b_1}\}]$, where $B_u$ is the scale at
    which $x(s)$ is the end $u$.""",
    right=r"""With $c = d_a \times d_b$, $A(s) = \pm (s \Delta p + \Delta q) \times d_b$ and
    $B(s) = \pm (s \Delta p + \Delta q) \times d_a$, the sign that of $c$, the edges meet where
    $0 \le A(s) \le |c| L_a(s)$ and $0 \le B(s) \le |c| L_b(s)$, $L$ being $s$ for an S-edge and 1
    for a T-edge: four linear inequalities, each of which bounds $s$ from below or from above, as
    its slope is, or holds at all scales or at none if that is zero. The interval may be empty, a
    point, or have no end. The printed form takes each start for a lower bound and each end for an
    upper one.""",
    reading=r"""Take $B_{a_0}$ and $B_{b_0}$ for the lower bounds of the intervals of the two edges,
    and $B_{a_1}$ and $B_{b_1}$ for the upper ones, whichever end each belongs to: then it is the
    intersection of the intervals, as the same sentence says.""",
    formula="The interval in which two edges meet (Section 4.2.3)",
    code=("reference/plane/critical/scale_interval.hpp",
          "reference/plane/critical/pair_interval.hpp"),
)  # fmt: skip
def _(shown: Shown) -> None:
    """Three pairs with small integers, one of each kind: printed and corrected code, and the
    symbolic oracle, which solves the contact of the segments with none of this. Then 1,200 random
    pairs: the corrected form is that of the oracle in all, the printed one in some."""
    for kinds, a, b, printed, right in INTERVALS:
        found = answers(a, b)
        _agree(shown, kinds, found)
        shown.equal(f"{kinds}, as printed", written(found.printed), printed)
        shown.equal(f"{kinds}, corrected", written(found.corrected), right)
        shown.draw(f"{kinds}: the edges from scale 0.2 to 4; they meet for s in {right}",
                   moving_edges(a, b, found.corrected))  # fmt: skip
    met = good = 0
    for a, b in _pairs(DRAWS):
        found = answers(a, b)
        if found.corrected != found.symbolic:
            raise CheckFailed(f"{a} and {b}: {found}")
        met += found.corrected is not None
        good += found.corrected is not None and found.printed == found.corrected
    shown.true(
        f"of {3 * DRAWS:,} random pairs {met} meet; the corrected form is right on all, the "
        f"printed one on {good} of those that meet",
        good < met,
    )


def _agree(shown: Shown, kinds: str, found: Answers) -> None:
    shown.equal(f"{kinds}, by the symbolic oracle", written(found.symbolic),
                written(found.corrected))  # fmt: skip


@CHAPTER.entry(
    "interval-invented",
    "The printed interval is also given to edges that never meet",
    place="Section 4.2.3",
    status=Status.LITERAL,
    printed=r"""$[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1}, B_{b_1}\}]$.""",
    right=r"""A pair of S-edges that meets at no scale gets $[20/49, 40/53]$.""",
    reading=r"""With lower and upper bounds for starts and ends the interval is empty.""",
    formula="The interval in which two edges meet (Section 4.2.3)",
    code=("reference/plane/critical/pair_interval.hpp",),
)
def _(shown: Shown) -> None:
    """One pair, by the printed and the corrected code and the symbolic oracle."""
    a, b = s_edge((-6, 2), (-1, 2), (5, -4)), s_edge((4, 6), (6, -3), (-1, 3))
    found = answers(a, b)
    shown.equal("as printed", written(found.printed), "[20/49, 40/53]")
    shown.equal("corrected", written(found.corrected), "empty")
    _agree(shown, "SS", found)
    shown.draw("the edges from scale 0.2 to 4", moving_edges(a, b, None))


@CHAPTER.entry(
    "interval-sorted",
    "Sorting the scales of each edge does not correct the interval",
    place="Section 4.2.3",
    status=Status.CONDITION,
    printed=r"""Not printed so; but one might read $[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1},
    B_{b_1}\}]$ generously as the intersection of the intervals between the two scales of each edge,
    in the right order.""",
    right=r"""If the slopes are not zero that is right for two T-edges: $A(s) \ge 0$ and $c - A(s)
    \ge 0$ have opposite slopes, $c > 0$ being $|d_a \times d_b|$. But both ends of an S-edge may
    bound $s$ from below: of $A(s) \ge 0$ and $c s - A(s) \ge 0$ the slopes add up to $c$, so that
    none or one of them is negative.""",
    formula="The interval in which two edges meet (Section 4.2.3)",
    code=("reference/plane/critical/scale_interval.hpp",),
)
def _(shown: Shown) -> None:
    """Two counterexamples, by the code and the symbolic oracle; by computer algebra the condition
    of the other end, from its place; and no failure for 400 random pairs of T-edges."""
    for kinds, a, b, wrong, right in (
        ("ST", s_edge((1, -5), (-6, -2), (0, -1)), t_edge((0, 6), (-3, -2), (-5, -2)),
         "(0, 21/8]", "[21/8, 16/3]"),
        ("SS", s_edge((-5, 1), (-6, 0), (0, 3)), s_edge((6, 6), (-6, 5), (1, -2)),
         "[61/60, 6/5]", "[6/5, 61/49]"),
    ):  # fmt: skip
        found = answers(a, b)
        shown.equal(f"{kinds}, sorted", written(found.sorted), wrong)
        shown.equal(f"{kinds}, corrected", written(found.corrected), right)
        _agree(shown, kinds, found)
    for kind, words in (("S", "$c s - A(s)$"), ("T", "$c - A(s)$")):
        x, y = kinds_of(kind + "T")
        A, c = cross(y.start(s) - x.start(s), y.d), cross(x.d, y.d)
        other = -cross(y.start(s) - x.start(s) - x.span(s), y.d)
        shown.identity(f"{kind}-edge: the condition of the other end is {words}",
                       other - (c * s if kind == "S" else c) + A)  # fmt: skip
    pairs = [pair for pair in _pairs(DRAWS) if pair[0].kind == pair[1].kind == "T"]
    found_all = [answers(*pair) for pair in pairs]
    complete = [x for x in found_all if None not in x.ends.values()]
    shown.true(f"{len(complete)} random pairs of T-edges whose four scales exist: sorting is right",
               all(x.sorted == x.corrected for x in complete))  # fmt: skip


def _whole(*operands: list[list[Any]]) -> list[list[list[tuple[int, int]]]]:
    numbers = [c for operand in operands for ring in operand for place in ring for c in place]
    factor = lcm(*(Fraction(c).denominator for c in numbers))
    return [
        [[(int(x * factor), int(y * factor)) for x, y in ring] for ring in operand]
        for operand in operands
    ]


def _edges_of(P: _core.PolygonSet, Q: _core.PolygonSet) -> list[Edge]:
    """Edges of the reduced convolution, after one factor has made both operands whole."""
    of_P, of_Q = _whole(rings_of(P), rings_of(Q))
    rings = {"S": (of_P, of_Q), "T": (of_Q, of_P)}
    found = []
    for kind, _, edge_ring, edge, vertex_ring, vertex in _core.reduced_convolution(P, Q):
        edges, vertices = rings[kind]
        ring = edges[edge_ring]
        a, b, v = ring[edge], ring[(edge + 1) % len(ring)], vertices[vertex_ring][vertex]
        found.append(s_edge(a, b, v) if kind == "S" else t_edge(a, b, v))
    return found


@CHAPTER.entry(
    "interval-for-convex-p",
    "For convex P there is a rule of this form, another one",
    place="Section 4.2.3",
    status=Status.LITERAL,
    printed=r"""$[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1}, B_{b_1}\}]$, for all operands.""",
    right=r"""If the operand that is scaled, $P$, is convex and edges run with it on the left, the
    interval of two edges that meet is
    $[\max\{B_{a_0}, B_{b_1}\}, \min\{B_{a_1}, B_{b_0}\}]$ where $d_a \times d_b > 0$ and
    $[\max\{B_{a_1}, B_{b_0}\}, \min\{B_{a_0}, B_{b_1}\}]$ where it is negative: the start of $a$
    pairs with the end of $b$, never with its start, as printed. For every vertex $p$ of $P$ lies
    on the left of each edge or on its line, which gives every slope its sign. (Where a scale does
    not exist, its slope being zero, it is left out.)""",
    reading=r"""With lower and upper bounds for starts and ends it is the rule on the right.""",
    formula="The interval in which two edges meet (Section 4.2.3)",
    code=("reference/plane/critical/pair_interval.hpp",),
)
def _(shown: Shown) -> None:
    """All pairs of edges of the convolutions of thirty random pairs of a convex polygon and any
    polygon: the convex rule is the corrected form, and the symbolic oracle's, wherever the edges
    meet."""
    dice = random.Random(SEED)
    met = complete = points = printed = 0
    for _ in range(30):
        P, Q = operand([convex(dice, dice.randint(3, 6), 8)]), random_operand(dice)
        edges = _edges_of(P, Q)
        for i, a in enumerate(edges):
            for b in edges[i + 1 :]:
                if cross(a.d, b.d) == 0:
                    continue
                found = answers(a, b)
                if found.corrected is None:
                    continue
                met += 1
                if not found.corrected == found.symbolic == _convex_rule(a, b, found):
                    raise CheckFailed(f"{a} and {b}: {found}")
                if None in found.ends.values():
                    continue
                complete += 1
                if found.convex != found.corrected:
                    raise CheckFailed(f"{a} and {b}: {found}")
                points += found.corrected[0] == found.corrected[1]
                printed += (
                    found.printed == found.corrected and found.corrected[0] != found.corrected[1]
                )
    shown.true(
        f"{met:,} pairs of edges that meet: the rule for convex $P$ is right on all",
        met > 200 and complete > 50,
    )
    shown.equal(f"of the {complete} that have all four scales, the {points} that meet at one scale "
                "aside, the printed form is right on", printed, 0)  # fmt: skip


def _convex_rule(a: Edge, b: Edge, found: Answers) -> Interval:
    """The interval by the rule for convex P, for edges that meet; absent scales are skipped."""
    names = ("a0", "b1"), ("a1", "b0")
    if cross(a.d, b.d) < 0:
        names = names[::-1]
    lows, highs = ([x for x in map(found.ends.get, each) if x is not None] for each in names)
    low = max(lows, default=Fraction(0))
    return low if low > 0 else None, min(highs, default=None)


@CHAPTER.entry(
    "share-of-right-intervals",
    "How often the printed interval is right on the paper's pairs",
    place="Section 4.2.3, Fig. 7 and 8",
    status=Status.LITERAL,
    printed=r"""The interval $[\max\{B_{a_0}, B_{b_0}\}, \min\{B_{a_1}, B_{b_1}\}]$ is computed for
    all pairs of edges.""",
    right=r"""Of the pairs of edges of monkey and bird that meet on an interval, the printed form,
    with exact scales, is right on about a fifth; of disc and neuron, the scaled operand being
    convex, on none.""",
    reading=r"""With lower and upper bounds for starts and ends it is right for all pairs.""",
    formula="The interval in which two edges meet (Section 4.2.3)",
    code=("reference/plane/critical/pair_interval.hpp",),
    slow=True,
    of_models=True,
)
def _(shown: Shown) -> None:
    """Every pair of edges of both convolutions, exact (the paper's models where they are at hand,
    else look-alikes of the same sizes)."""
    for names in (("disc1", "neuron"), ("monkey", "bird")):
        P, Q = (read_operand(or_look_alike(name, all_models())) for name in names)
        told = _core.compare_forms(P.set, Q.set)
        right, meeting = told["printed_right_by_roots"], told["intersecting"]
        shown.true(
            f"{P.name} and {Q.name}: {meeting:,} pairs meet, the printed form is right on "
            f"{right:,} ({right / meeting:.1%})",
            right == 0 if names[0] == "disc1" else right < meeting / 3,
        )


@CHAPTER.entry(
    "upwards-only",
    "The arrangement is stepped upwards only",
    place="Section 4.2.4",
    status=Status.INCOMPLETE,
    printed=r"""From $s_0$ the events are stepped through until one has $s_{event} > s_{final}$.""",
    right=r"""That is for $s_{final} > s_0$. Downwards the same events are passed in the other
    order, with insertions and deletions exchanged.""",
    formula="Stepping through the array of events (Section 4.2.4)",
    code=("reference/plane/dynamic/dynamic_arrangement.hpp",),
)
def _(shown: Shown) -> None:
    """A dynamic sum is stepped up and down between random scales, and compared with a static one
    each time: arrangement and canonical sum are the same."""
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    dynamic = _core.DynamicSum(P, Q, "1/10", "10")
    dice = random.Random(SEED)
    at = Fraction(1)
    down = 0
    for _ in range(12):
        scale = Fraction(dice.randint(1, 100), 10)
        dynamic.move_to(str(scale))
        down += scale < at
        at = scale
        if dynamic.difference_from_scratch():
            raise CheckFailed(f"at {scale}: {dynamic.difference_from_scratch()}")
    shown.true(
        f"12 moves of g1 and g2, {down} of them downwards: the same as from scratch", down > 2
    )


@CHAPTER.entry(
    "simultaneous-events",
    "Events at one scale",
    place="Section 4.2.4",
    status=Status.INCOMPLETE,
    printed=r"""The array of events pairs each scale with a list of insertions or deletions; these
    are done until one has $s_{event} > s_{final}$.""",
    right=r"""A list for each scale is needed: events at one scale are the rule, not the exception,
    for where an edge passes a vertex of the convolution it leaves one of its edges and enters the
    other at the same scale. At a final scale that is itself an event the lists have to be divided,
    of which the text does not speak: edges that start to meet there do so, and those that stop
    still do, since edges are closed.""",
    formula="Stepping through the array of events (Section 4.2.4)",
    code=("reference/plane/dynamic/dynamic_arrangement.hpp",),
)
def _(shown: Shown) -> None:
    """The events of small models: at how many scales they are. Then two edges whose interval is
    closed, at its end."""
    for names in (("g1", "g2"), ("g3", "g4")):
        P, Q = (read_operand(name).set for name in names)
        told = _core.pair_events(P, Q).counts()
        shown.true(
            f"{' and '.join(names)}: {told['count']:,} pair events at {told['distinct']:,} scales",
            told["distinct"] < told["count"],
        )
    _, a, b, _, _ = INTERVALS[2]
    last = Fraction(10, 3)
    interval = answers(a, b).corrected
    shown.equal("two edges meet for $s$ in", written(interval), "[2, 10/3]")
    at_end = ends(a, last), ends(b, last)
    touching = any(_is_on(p, *other) for e, other in (at_end, at_end[::-1]) for p in e)
    shown.true("at 10/3 they still touch", touching)
