"""Arcs with arcs."""

from __future__ import annotations

import random
from fractions import Fraction

import sympy as sp
from minkref.fuzz.judges.disc.paper_disc import Corner, circles, end_on_circle, touches
from minkref.reports.audit.disc import exact
from minkref.reports.audit.disc_code import CODE, code_events, scales_by_both, scales_of_ends
from minkref.reports.audit.entry import Chapter, Shown, Status
from minkref.reports.audit.sketches import arcs_at
from minkref.reports.audit.symbolic_disc import FIVES, corner_of_normals, normal, r, s, unit, vector

PART = Chapter("appendix", "Appendix: a scaling disc")
SEED = 12
ORACLE = ("oracle/symbolic/disc/disc.py", "oracle/symbolic/disc/derive_disc.py")


@PART.entry(
    "disc-circles-touch",
    "Two circles touch in the middle of their centres",
    place="Appendix, arcs with arcs",
    status=Status.HOLDS,
    printed=r"""Circles of one radius touch in the midpoint of their centres, which stays where it
    is; they meet on the line through it that is perpendicular to that of the centres, and not at
    all below.""",
    right=r"""So it is, at $s_0 = |c_1 - c_2| / (2 r)$: $s_0^2$ is rational, $s_0$ of degree 1 or 2.
    It is an event of the arcs only if the midpoint lies on both.""",
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra; one pair by the symbolic oracle, and by the code."""
    a, b = vector("a"), vector("b")
    x, y = sp.symbols("x y", real=True)
    difference = (x - a[0]) ** 2 + (y - a[1]) ** 2 - (x - b[0]) ** 2 - (y - b[1]) ** 2
    on_line = 2 * (b - a).dot(sp.Matrix([x, y]) - (a + b) / 2)
    shown.identity("difference of the circles' equations: the line through the midpoint, at right "
                   "angles", difference - on_line)  # fmt: skip
    arcs = (
        corner_of_normals((0, 0), (4, -3), (4, 3)),
        corner_of_normals((6, 1), (-4, 3), (-4, -3)),
    )
    root = circles(*arcs, 1)
    shown.equal("centres $(0, 0)$ and $(6, 1)$, $r = 1$: minimal polynomial of $s_0$",
                root.polynomial, (4, 0, -37))  # fmt: skip
    shown.equal("the first event of arcs of them, by the code",
                scales_by_both(*arcs, 1)[0], sp.sqrt(37) / 2)  # fmt: skip


@PART.entry(
    "disc-magnitude",
    "How far the crossings of two circles have moved",
    place="Appendix, arcs with arcs",
    status=Status.CONDITION,
    printed=r"""From $r^2 + (y - y_c)^2 = (s r)^2$ follows $y$, for the contact at the scale 1, and
    for one at $s_0$. The formulas read $\sqrt{(s^2 - 1) r} + y_c$ and $\sqrt{(s^2 - s_0^2) r} +
    y_c$, or with $r$ beyond the end of the radical: the text that was at hand does not show how far
    that reaches.""",
    right=r"""$y = r \sqrt{s^2 - s_0^2} + y_c$. So it is if the radical ends before $r$ (for which
    the parentheses would not be needed). With $r$ under it the squares differ by $r (1 - r) (s^2 -
    s_0^2)$: right for $r = 1$ only.""",
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra, and at a pair of circles with rational crossings. By the code, with $r$
    under the radical, an end of an arc is on the other circle for r = 1 only."""
    t = sp.Symbol("s_0", positive=True)
    shown.identity("$(s_0 r)^2 + (r \\sqrt{s^2 - s_0^2})^2 = (s r)^2$",
                   (t * r) ** 2 + r**2 * (s**2 - t**2) - (s * r) ** 2)  # fmt: skip
    shown.identity("with $r$ under the radical, square less the right one $r (1 - r)(s^2 - s_0^2)$",
                   (s**2 - t**2) * (r - r**2) - r * (1 - r) * (s**2 - t**2))  # fmt: skip
    scale, radius = sp.Rational(5, 4), 4
    printed, right = (sp.sqrt((scale**2 - 1) * x) for x in (radius, radius**2))
    shown.equal("$r = 4$, $s = 5/4$, centres $(0, 0)$ and $(8, 0)$: height of the crossing with "
                "$r$ under the radical, and with $r$ before it", (printed, right),
                (sp.Rational(3, 2), 3))  # fmt: skip
    found = (4**2 + right**2, (8 - 4) ** 2 + right**2, (scale * radius) ** 2)
    shown.equal("squared distances of $(4, 3)$ to both centres, and $(s r)^2$", found,
                (25, 25, 25))  # fmt: skip
    arcs = (corner_of_normals((0, 0), (3, -4), (4, 3)),
            corner_of_normals((6, 0), (-3, 4), (0, -1)))  # fmt: skip
    for radius, scales in ((1, [3, sp.Rational(15, 4), 5]), (3, [1])):
        kept = [event.scale for event in code_events(*arcs, radius, ["radical"])]
        shown.equal(f"arcs about $(0, 0)$ and $(6, 0)$, $r = {radius}$, of the three events those "
                    "with $r$ under the radical", kept, scales)  # fmt: skip


@PART.entry(
    "disc-crossing-of-circles",
    "Where two circles cross",
    place="Appendix, arcs with arcs",
    status=Status.LITERAL,
    printed=r"""$I(s) = M(s) (\pm \perp (c_1, c_2))$, where $M(s)$ is the root above plus
    $y_{c_1}$.""",
    right=r"""$I(s) = \frac{c_1 + c_2}{2} \pm r \sqrt{s^2 - s_0^2} \, n$, $n$ a unit vector
    perpendicular to $c_2 - c_1$. The midpoint is missing; $y_{c_1}$ belongs to the coordinates of
    the derivation, with both centres level, and not to the length; for $r$ and the radical see
    above. (Read as the way from the midpoint, $I(s)$ has $y_{c_1}$ too much. But the text sets
    $I(s)$ equal to the ends of arcs, which are places.)""",
    reading=r"""Put the origin in the middle of the two centres, and both on the $x$-axis: then
    $y_{c_1} = 0$, and $I(s) = M(s) (\pm \perp (c_1, c_2))$ is the place.""",
    code=ORACLE,
)
def _(shown: Shown) -> None:
    """By computer algebra the right form has the distance s r from both centres. One pair of
    circles with rational crossings, with the radical corrected in the printed form."""
    c, d, n = vector("c"), sp.Symbol("d", positive=True), unit("t")
    other = c + d * normal(n)
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
    way = (a + b) / 2 + printed
    shown.equal("and, read as the way from the midpoint",
                tuple((way - centre).dot(way - centre) for centre in (a, b)), (34, 34))  # fmt: skip


@PART.entry(
    "disc-ends-of-arcs",
    "How many solutions an end of an arc has",
    place="Appendix, arcs with arcs",
    status=Status.CONDITION,
    printed=r"""Setting $I(s)$ equal to the end-points of the arc gives 0, 1 or 2 solutions.""",
    right=r"""So it is for both ends of an arc together. Each end $v + s r m$ has at most one: with
    $D = v - v'$ it is on the circle about $v'$ where $|D|^2 + 2 s r m \cdot D = 0$, which is
    linear, so at $s = -|D|^2 / (2 r m \cdot D)$ if $m \cdot D < 0$. Again $s^2$ is rational. No
    crossing of circles needs to be computed for it.""",
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra. Three arcs about one vertex have ends that come to a circle 0, 1 and 2
    times, by the formula, by the symbolic oracle and by the code."""
    D, m = vector("D"), unit("t")
    x = D + s * r * m
    condition = x.dot(x) - (s * r) ** 2
    shown.identity("the condition is $|D|^2 + 2 s r m \\cdot D$",
                   condition - D.dot(D) - 2 * s * r * m.dot(D))  # fmt: skip
    shown.identity("it holds at $s = -|D|^2 / (2 r m \\cdot D)$",
                   condition.subs(s, -D.dot(D) / (2 * r * m.dot(D))))  # fmt: skip
    target = corner_of_normals((0, 0), (3, -4), (3, 4))
    for normals, wanted in (
        (((0, -5), (4, 3)), ()),
        (((0, 5), (-4, 3)), (Fraction(15, 4),)),
        (((-3, 4), (-4, -3)), (Fraction(15, 4), Fraction(5))),
    ):
        arc = corner_of_normals((6, 0), *normals)
        by_formula = tuple(sorted(Fraction(-36, 2 * 6 * x) * 5 for x, _ in normals if x < 0))
        roots = [end_on_circle(1, arc[:2], target, 1), end_on_circle(0, arc[1:], target, 1)]
        told = sorted(exact(x) for x in roots if x.case == "once")
        same = told == [sp.Rational(str(x)) for x in by_formula] == scales_of_ends(arc, target)
        shown.true(f"arc about $(6, 0)$ from the direction {normals[0]} to {normals[1]}: oracle, "
                   "code and formula agree", same)  # fmt: skip
        shown.equal("scales at which an end of it is on the circle about $0$, $r = 1$",
                    by_formula or "none", wanted or "none")  # fmt: skip


@PART.entry(
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
    code=(*CODE, *ORACLE),
)
def _(shown: Shown) -> None:
    """By computer algebra the angle grows. Two arcs with three events, and 150 random pairs, by the
    code and by the symbolic oracle: those that touch as circles do, have three scales at most,
    others two."""
    t = sp.Symbol("s_0", positive=True)
    growth = sp.diff(sp.acos(t / s), s)
    shown.identity(r"$d \varphi / d s = s_0 / (s \sqrt{s^2 - s_0^2})$",
                   growth - t / (s * sp.sqrt(s**2 - t**2)))  # fmt: skip
    a = corner_of_normals((0, 0), (3, -4), (4, 3))
    b = corner_of_normals((6, 0), (-3, 4), (0, -1))
    shown.equal("events of arcs about $(0, 0)$ and $(6, 0)$, $r = 1$", scales_by_both(a, b, 1),
                [3, sp.Rational(15, 4), 5])  # fmt: skip
    shown.equal("points that they share before, at and after each, by the code",
                [event.shared for event in code_events(a, b, 1)],
                [(0, 1, 2), (2, 2, 1), (1, 1, 0)])  # fmt: skip
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
        number = len(scales_by_both(first, second, 1))
        as_circles = any(touch.name == "circles" for touch in found)
        most[as_circles] = max(most[as_circles], number)
    shown.equal("most events of 150 random pairs: of those whose circles touch on both arcs, and "
                "of the others", (most[True], most[False]), (3, 2))  # fmt: skip


def _drawn_corner(dice: random.Random) -> Corner:
    start = dice.randrange(12)
    turn = dice.randint(1, 5)
    at = dice.randint(-8, 8), dice.randint(-8, 8)
    return corner_of_normals(at, FIVES[start], FIVES[(start + turn) % 12])
