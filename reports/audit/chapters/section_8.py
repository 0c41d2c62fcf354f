"""Section 8: a robot of uncertain size, part removal, and bridges of polygons."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction

import minkref
import sympy as sp
from minkref import _core
from minkref.fuzz.geometry.plane import cross, dot, minus, turn
from minkref.fuzz.judges.disc.paper_disc import circles, ring_touches
from minkref.fuzz.plane.families.drawing import convex, reflected
from minkref.fuzz.plane.families.small_operands import star
from minkref.motion.scale_ranges import PATH_ROUTES
from minkref.plane.operand import read_operand
from minkref.reports.audit.disc import corner, crossing, exact, reflex_pairs, squared_distance
from minkref.reports.audit.edges import Edge, Interval, answers, written
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status, text
from minkref.reports.audit.paths import (
    concurrencies,
    contacts,
    is_valid,
    moving_edges,
    operands,
    overlaps,
    valid_scales,
)
from minkref.reports.audit.plane import Place, Ring, box, operand
from minkref.reports.audit.sketches import robot_on_path, swept
from minkref.reports.audit.symbolic_edges import kinds_of

CHAPTER = Chapter("section-8", "Section 8: applications")
SEED = 8
HALF = Fraction(1, 2)
HERE: Place = (Fraction(0), Fraction(0))
# A pocket with a flat floor below overhanging walls and tips 8 apart.
POCKET = [(-16, -4), (16, -4), (16, 6), (4, 8), (12, 0), (-12, 0), (-4, 8), (-16, 6)]
NEAR = (-7.0, -2.0, 7.0, 11.0)


def _places(*path: tuple[int, int]) -> list[Place]:
    return [(Fraction(x), Fraction(y)) for x, y in path]


def _polygon(ring: list[Place]) -> _core.PolygonSet:
    return operand([[(x, y) for x, y in ring]])


def _sees_all(ring: list[Place]) -> bool:
    """Whether a simple ring, counter-clockwise, is star-shaped about the origin."""
    return all(cross(a, b) >= 0 for a, b in zip(ring, ring[1:] + ring[:1], strict=True))


def _drawn_robot(dice: random.Random) -> list[Place]:
    """Star-shaped about the origin."""
    while True:
        ring = star(dice, 4, 6)
        following = [*ring[1:], ring[0]]
        turns = [cross(a, b) for a, b in zip(ring, following, strict=True)]
        if len(ring) > 3 and min(turns) > 0:
            return [(Fraction(x), Fraction(y)) for x, y in ring]


def _drawn_obstacle(dice: random.Random) -> Ring:
    x, y = dice.randint(-9, 9), dice.randint(-9, 9)
    return [(u + x, v + y) for u, v in convex(dice, 4, 6)]


def _obstacle_in_the_way(ring: list[Place]) -> tuple[Fraction, _core.PolygonSet]:
    """A scale below 1, and a small box that the robot, not star-shaped about the origin, meets at
    this scale but neither at 1 nor at small scales. Behind the middle of an edge that turns its
    back to the origin, places towards the origin lie outside the robot."""
    following = ring[1:] + ring[:1]
    a, b = next(x for x in zip(ring, following, strict=True) if cross(*x) < 0)
    m = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
    cuts = [Fraction(0)]
    for u, v in zip(ring, following, strict=True):
        d = minus(v, u)
        across = cross(m, d)
        if across:
            t, along = cross(u, d) / across, cross(u, m) / across
            if 0 < t < 1 and 0 <= along <= 1:
                cuts.append(t)
    factor = (max(cuts) + 1) / 2
    x, y = factor * m[0], factor * m[1]
    size = max(abs(x), abs(y)) / 2
    robot = _polygon(ring)
    while True:
        obstacle = operand([box(x - size, y - size, 2 * size, 2 * size)])
        if overlaps(robot, obstacle, Fraction(1), HERE) == "empty":
            return factor, obstacle
        size /= 2


@CHAPTER.entry(
    "largest-valid-scale",
    "The largest scale for which a path is valid",
    place="Sections 1 and 8.1",
    status=Status.CONDITION,
    printed=r"""For a robot of a given size on a given path, the question is what the largest scale
    is for which the path is valid (in Section 1: the largest and the smallest); the answer is the
    scale of the first contact.""",
    right=r"""The valid scales are those at which no place of the path is a sum of inner points of
    $O$ and of $-s R$. For every path and obstacle they are an interval that begins at 0, or none,
    if and only if $R$ is star-shaped about its reference point, about which it is scaled. Then $s'
    R \subseteq s R$ for $s' < s$. Otherwise some $\lambda p$ is outside $R$ for a $p \in R$ and $0
    < \lambda < 1$, and a small obstacle there is met at the scale $\lambda$ and not at 1. The valid
    scales are then a union of intervals, all of which have to be told: the first contact above the
    given size ends one of them, beyond which there may be others, and there may be no largest
    scale.""",
    code=("reports/audit/paths.py", "reference/motion/valid_scales.hpp"),
)  # fmt: skip
def _(shown: Shown) -> None:
    """A box that does not have its reference point in it, and one obstacle: whether they overlap is
    decided exactly at all scales at which anything can change, and between any two. Then eighteen
    random robots that are star-shaped about their reference point, with random obstacles and paths,
    and the same robots with another reference point, with the obstacle of the proof."""
    robot, obstacle = operand([box(2, -HALF, 1, 1)]), operand([box(5, -1, 1, 2)])
    found = valid_scales(robot, obstacle, [HERE])
    shown.equal(r"valid scales of $R = [2, 3] \times [-1/2, 1/2]$ at $0$, with $O = [5, 6] \times "
                "[-1, 1]$", _listed(found), "(0, 5/3] and [3, ∞)")  # fmt: skip
    shown.equal("by the three routes of the code", _listed(_by_code(robot, obstacle, [HERE])),
                _listed(found))  # fmt: skip
    for s in map(Fraction, ("1", "2", "7/2")):
        shown.draw(f"the robot at the scale {s}: {overlaps(robot, obstacle, s, HERE)}",
                   robot_on_path(robot, obstacle, [HERE], s))  # fmt: skip
    dice = random.Random(SEED)
    bounded = 0
    for k in range(18):
        ring = _drawn_robot(dice)
        robot, obstacle = _polygon(ring), operand([_drawn_obstacle(dice)])
        ends = [(dice.randint(-9, 9), dice.randint(-9, 9)) for _ in range(2 if k % 3 == 0 else 1)]
        found = valid_scales(robot, obstacle, _places(*ends))
        if _by_code(robot, obstacle, _places(*ends)) != found:
            raise CheckFailed(text((ring, obstacle.to_json(), ends, found)))
        if len(found) > 1 or any(x is not None and x[0] is not None for x in found):
            raise CheckFailed(text((ring, obstacle.to_json(), ends, found)))
        bounded += any(x is not None and x[1] is not None for x in found)
    shown.true(f"18 random robots that are star-shaped: one interval from 0, or none ({bounded} "
               "have an end), also by the code", bounded > 6)  # fmt: skip
    refuted = 0
    while refuted < 18:
        ring = [(x + 5, y + 1) for x, y in _drawn_robot(dice)]
        if _sees_all(ring):
            continue
        robot = _polygon(ring)
        factor, obstacle = _obstacle_in_the_way(ring)
        scales = (factor / 1000, factor, Fraction(1))
        if [overlaps(robot, obstacle, x, HERE) for x in scales] != [
            "empty",
            "overlapping",
            "empty",
        ]:
            raise CheckFailed(text((ring, obstacle.to_json(), factor)))
        refuted += 1
    shown.tell(f"{refuted} random robots that are not: for each an obstacle that is not met at a "
               "small scale, is met at a greater one, and not at a still greater one.")  # fmt: skip


def _by_code(
    robot: _core.PolygonSet, obstacle: _core.PolygonSet, path: Sequence[Place]
) -> list[Interval]:
    """Valid scales from the command's code, by each route; raises CheckFailed unless all routes
    agree."""
    answers = []
    for route in PATH_ROUTES:
        found = minkref.valid_scales(robot, obstacle, path, route=route)
        answers.append([(one.low or None, one.high) for one in found.ranges])
    if answers != answers[:1] * len(answers):
        raise CheckFailed(text((robot.to_json(), obstacle.to_json(), path, answers)))
    return list(answers[0])


def _listed(found: list[Interval]) -> str:
    return " and ".join(map(written, found)) or "none"


@CHAPTER.entry(
    "touching-on-a-path",
    "Whether touching is valid",
    place="Section 8.1",
    status=Status.INCOMPLETE,
    printed=r"""The scale of the first contact between an obstacle's boundary and the path is
    reported as the largest valid one.""",
    right=r"""A largest one is there only if contact without overlap is valid: the interiors are
    kept apart. With contact forbidden the valid scales have a supremum that is not one of them. If
    it is allowed, what a path has to keep out of is the sum of the interiors, and not the interior
    of the sum, which may be more: at the very scale at which a robot still fits through a corridor,
    the corridor is inside $O \oplus (-s R)$ as a closed set.""",
    code=("docs/definitions.md", "reference/plane/witness.hpp"),
)
def _(shown: Shown) -> None:
    """A unit square in a corridor of width 1: the valid scales by decisions at places, the sum at
    the greatest one, and the tight passage that the sum of the interiors leaves."""
    robot = operand([box(-HALF, -HALF, 1, 1)])
    obstacle = operands([box(-5, HALF, 10, 3), box(-5, -HALF - 3, 10, 3)])
    path = _places((-2, 0), (2, 0))
    shown.equal("valid scales", _listed(valid_scales(robot, obstacle, path)), "(0, 1]")
    shown.equal("at the scale 1, in the middle of the path",
                overlaps(robot, obstacle, Fraction(1), HERE), "touching")  # fmt: skip
    P = reflected(robot)
    sum_at_1 = _core.minkowski_sum(P, obstacle, "1")
    area = Fraction(sum_at_1.region.area())
    shown.equal("the closed sum at the scale 1: components, holes, and the area of the box around "
                "it less its own", (sum_at_1.components, sum_at_1.holes, Fraction(11 * 8) - area),
                (1, 0, Fraction(0)))  # fmt: skip
    ((points, _),) = _core.tight_passages(P, obstacle, "1")
    shown.equal("the tight passage in it", [tuple(map(Fraction, x)) for x in points],
                [(Fraction(-11, 2), 0), (Fraction(11, 2), 0)])  # fmt: skip
    for scale in ("1", "6/5"):
        shown.draw(f"the robot at the scale {scale}",
                   robot_on_path(robot, obstacle, path, Fraction(scale)))  # fmt: skip


@CHAPTER.entry(
    "path-events",
    "Events of a path are easier than those of the convolution",
    place="Section 8.1",
    status=Status.HOLDS,
    printed=r"""The scales of contact of a path and the boundary of an obstacle can be computed in
    the same way as the events of two edges, and more easily, since the path does not scale.""",
    right=r"""So it is. A step of the path is a T-edge at the vertex 0: a case of two edges, with
    linear conditions and rational scales: an end $g$ of the path on the line $n \cdot x = s
    \alpha + \beta$ of a moving edge, or an end $s p + q$ of the edge on the line of the path. No
    triple events are needed: where two edges of the convolution cross on the boundary of the sum,
    the sum is on more than a half-plane around, and no path touches it there first.""",
    code=("reference/plane/critical/pair_interval.hpp", "reports/audit/paths.py"),
)
def _(shown: Shown) -> None:
    """By computer algebra both conditions are linear in s, for S- and T-edges. For 400 random steps
    and edges the code has the interval of the symbolic oracle. For eight random robots, obstacles
    and steps, where an interval of valid scales ends, the step starts or stops meeting an edge;
    and at scales at which two edges and the step pass through one point nothing changes."""
    s = sp.Symbol("s", positive=True)
    g, e = (sp.Matrix(sp.symbols(f"{name}_x {name}_y")) for name in "ge")
    for kind in "ST":
        edge, _ = kinds_of(kind + "T")
        end = edge.start(s) + edge.span(s)
        shown.identity(f"{kind}-edge, second derivative of the condition of an end of the path",
                       sp.diff(cross(edge.d, g - edge.start(s)), s, 2))  # fmt: skip
        shown.identity(f"{kind}-edge, second derivative of the condition of an end of the edge",
                       sp.diff(cross(e, end - g), s, 2))  # fmt: skip
    dice = random.Random(SEED)

    def drawn() -> tuple[int, int]:
        return dice.randint(-6, 6), dice.randint(-6, 6)

    meeting = compared = 0
    while compared < 400:
        step = Edge("T", (0, 0), drawn(), drawn())
        edge_2 = Edge(dice.choice("ST"), drawn(), drawn(), drawn())
        if cross(step.d, edge_2.d) == 0:
            continue
        told = answers(step, edge_2)
        if told.corrected != told.symbolic:
            raise CheckFailed(text((step, edge_2, told)))
        compared += 1
        meeting += told.corrected is not None
    shown.true(f"{compared} random steps and edges, {meeting} of which meet: the code has the "
               "interval of the oracle", meeting > 50)  # fmt: skip
    ends = probes = 0
    for _ in range(8):
        robot, obstacle = _polygon(_drawn_robot(dice)), operand([_drawn_obstacle(dice)])
        path = _places(drawn(), drawn())
        if path[0] == path[1]:
            continue
        known = contacts(robot, obstacle, path[0], path[1])
        found = valid_scales(robot, obstacle, path)
        bounds = [x for interval in found for x in interval or () if x is not None]
        ends += len(bounds)
        if not known.issuperset(bounds):
            raise CheckFailed(text((robot.to_json(), obstacle.to_json(), path, found)))
        edges = moving_edges(robot, obstacle)
        triples = sorted(concurrencies(edges, path[0], path[1]))
        for scale in dice.sample(triples, min(len(triples), 15)):
            probes += 1
            if is_valid(robot, obstacle, edges, path, scale) != _in_one(scale, found):
                raise CheckFailed(text((robot.to_json(), obstacle.to_json(), path, scale)))
    shown.true(f"{ends} ends of intervals of valid scales: each is a scale of contact", ends > 4)
    shown.true(f"{probes} scales at which two edges and the path pass through one point: valid as "
               "those around them", probes > 50)  # fmt: skip


def _in_one(scale: Fraction, intervals: list[Interval]) -> bool:
    return any(
        x is not None and (x[0] is None or x[0] <= scale) and (x[1] is None or scale <= x[1])
        for x in intervals
    )


@CHAPTER.entry(
    "path-starts-inside",
    "A path that is never valid need not have any contact",
    place="Section 8.1",
    status=Status.INCOMPLETE,
    printed=r"""The scale of the first contact of the path and the boundary of an obstacle is
    reported; which side is the valid one is not spoken of.""",
    right=r"""The contacts only cut the scales into intervals. Whether one is valid has to be
    decided at one of its scales, by a place of the path against the sum: a path inside of it has no
    contact. For a base size at which the path is valid, as the paper supposes, this is known for
    the interval of that size alone.""",
    code=("reports/audit/paths.py",),
)
def _(shown: Shown) -> None:
    """A robot whose path starts and stays inside a large obstacle: no edge meets it at any scale,
    and it is valid at none."""
    robot, obstacle = operand([box(-1, -1, 2, 2)]), operand([box(-10, -10, 20, 20)])
    path = _places((0, 0), (1, 0))
    shown.equal("number of scales of contact of the path and an edge of the convolution",
                len(contacts(robot, obstacle, path[0], path[1])), 0)  # fmt: skip
    shown.equal("valid scales", _listed(valid_scales(robot, obstacle, path)), "none")


@CHAPTER.entry(
    "trapping-scale",
    "The smallest scale at which a part is trapped",
    place="Section 8.1",
    status=Status.CONDITION,
    printed=r"""The smallest scale at which an assembly traps a part is found by giving one escape
    path and computing the largest scale for which it is valid.""",
    right=r"""One path gives a lower bound: the part escapes at that scale. The smallest trapping
    scale, of a part that is star-shaped about its reference point, is the supremum over all paths,
    and equal to the bound only if the path is a widest one. It is where the place of the part comes
    to lie in a bounded component of the complement of $O \oplus (-s R)$, that is, where a hole of
    the sum is born around it: a topology event.""",
    code=("reference/motion/fits_and_traps.hpp", "reports/audit/paths.py"),
)
def _(shown: Shown) -> None:
    """A cavity with two openings, of width 2 and 4, and a unit square in it: the valid scales of
    the path through each, and the scales at which the sum has a hole, from the code."""
    robot = operand([box(-HALF, -HALF, 1, 1)])
    left: Ring = [(-4, -4), (4, -4), (4, -1), (3, -1), (3, -3), (-3, -3), (-3, 3), (-2, 3),
                  (-2, 4), (-4, 4)]  # fmt: skip
    right: Ring = [(3, 1), (4, 1), (4, 4), (2, 4), (2, 3), (3, 3)]
    assembly = operands([left, right])
    paths = {"right": _places((0, 0), (8, 0)), "up": _places((0, 0), (0, 8))}
    for (way, path), wanted in zip(paths.items(), ("(0, 2]", "(0, 4]"), strict=True):
        found = valid_scales(robot, assembly, path)
        shown.equal(f"valid scales of the path to the {way}" if way == "right" else
                    "valid scales of the path upwards", _listed(found), wanted)  # fmt: skip
    lives = _core.DynamicSum(reflected(robot), assembly).lives("hole")
    shown.equal("scales of birth and death of holes of the sum",
                [(birth, death) for _, birth, death in lives], [(4, 6)])  # fmt: skip
    for scale in ("3", "5"):
        contact = overlaps(robot, assembly, Fraction(scale), HERE)
        shown.equal(f"the part in the middle of the cavity, scale {scale}", contact, "empty")
    trapped = minkref.trapped_scales(robot, assembly, HERE)
    shown.equal("scales at which the code finds it trapped in the middle, contact allowed",
                " and ".join(map(str, trapped.ranges)), "(4, 6]")  # fmt: skip
    shown.tell(r"So the part is trapped for $4 < s \le 6$ and does not fit for $s > 6$; the path "
               "to the right gives 2.")  # fmt: skip
    for way, path in paths.items():
        shown.draw(f"the part at the scale 3 on the path {'up' if way == 'up' else 'to the right'}",
                   robot_on_path(robot, assembly, path, Fraction(3)))  # fmt: skip


@CHAPTER.entry(
    "speed-up-of-figure-11",
    "The speed-up of Fig. 11",
    place="Section 8.1, Fig. 11",
    status=Status.HOLDS,
    printed=r"""96.811 ms from scratch and 2.498 ms by updates are a factor of about 38.755,
    and 38.8 in the text.""",
    right=r"""The quotient of the printed times rounds to both. Neither the environment nor that of
    the factor 68.556 in Section 8.2 is given, so the times cannot be measured again. An environment
    of ours, with 12 copies of 1, 3 or 12 shapes, is timed in `minkref report paper`.""",
)
def _(shown: Shown) -> None:
    """The quotient is computed exactly, and rounded."""
    quotient = Fraction("96.811") / Fraction("2.498")
    shown.equal("the quotient, rounded to three digits and to one",
                (round(quotient * 1000), round(quotient * 10)), (38755, 388))  # fmt: skip


@CHAPTER.entry(
    "speed-up-of-figure-12",
    "The speed-up of the decomposition",
    place="Section 8.2, Fig. 12",
    status=Status.NOT_REPRODUCIBLE,
    printed=r"""“The speed-up for the decomposition of the polygons shown in Fig. 12 using the
    proposed method is 68.556 over that of repetitive re-computation of the Minkowski sums”.""",
    right=r"""The beetle is not published, nor how many radii were taken from $0.05 \le \alpha \le
    1$, nor what was re-computed; neither pocket minima nor cuts are defined. With a beetle of ours,
    20 diameters, and definitions of our own, the Appendix's program is timed in `minkref report
    paper`.""",
    code=("docs/features.md", "reports/bench/growing_disc.py"),
)
def _(shown: Shown) -> None:
    """Our beetle: features, each with its deepest vertex, at the diameters of the figure; and
    pieces over the range."""
    P = read_operand("beetle").set
    found = _core.features(P)
    counts = [len(found.at(diameter)) for diameter in ("1/20", "1/5", "2/5")]
    shown.equal("features at $\\alpha$ = 0.05, 0.2 and 0.4", tuple(counts), (66, 62, 53))
    places = [row[:2] for row in found.notches("1/20", "3/5", "1")]
    cuts, pieces = _core.cut_at_notches(P, places)
    shown.equal("cuts and pieces for features that last for more than 0.6 of the range",
                (len(cuts), len(pieces)), (20, 21))  # fmt: skip


@CHAPTER.entry(
    "alpha-of-a-disc",
    "What alpha measures",
    place="Section 8.2",
    status=Status.CONDITION,
    printed=r"""In the notation of $\alpha$-shapes, an $\alpha$-disc has the diameter $\alpha$.""",
    right=r"""As a definition of its own it is consistent. But in the work on $\alpha$-shapes
    $\alpha$ is the radius (Edelsbrunner and Mücke 1994), or one over it (Edelsbrunner, Kirkpatrick
    and Seidel 1983): numbers such as those of Fig. 12 differ by a factor of two between the two
    readings. With the diameter the disc that is added has the radius $\alpha / 2$, and two vertices
    at the distance $D$ have a bridge from $\alpha = D$ on.""",
    code=("oracle/symbolic/disc/disc.py",),
)
def _(shown: Shown) -> None:
    """The symbolic oracle: the scale of the radius at which the circles about two vertices at the
    distance 8 touch."""
    corners = [corner(POCKET, k) for k in (3, 6)]
    radius = exact(circles(corners[0], corners[1], 1))
    shown.equal("the circles about $(4, 8)$ and $(-4, 8)$ touch at the radius", radius, 4)
    shown.equal("so alpha as diameter, and as radius", (2 * radius, radius), (8, 4))


@CHAPTER.entry(
    "bridges-end-at-triple-events",
    "Bridges are born and die at triple events as well",
    place="Section 8.2 and Appendix",
    status=Status.INCOMPLETE,
    printed=r"""The $\alpha$-bridges are updated at the critical events of the Appendix, which are
    those of pairs of segments and arcs.""",
    right=r"""A bridge belongs to an empty disc that touches $P$ at two places. It also begins or
    ends where the disc touches a third feature: its centre is a vertex of the Voronoi diagram of
    the exterior, and three curves of the convolution pass through it. There a hole of $P \oplus D$
    may end with all its bridges, and no two curves start or stop meeting.""",
    formula="Events of two arcs or segments are all events (Section 8.2, Appendix)",
    code=("oracle/symbolic/disc/disc_contact.py",),
)
def _(shown: Shown) -> None:
    """A pocket with a floor, and tips 8 apart. All scales of pairs of its features come from the
    symbolic oracle: 5 is none of them. The exact distance of the centre of a disc to the polygon
    tells whether it is empty; by computer algebra each of three discs is up to the radius 5, and
    none beyond."""
    pairs = ring_touches(POCKET, 1)
    scales = [exact(touch.root) for touch in pairs]
    shown.true(f"of the {len(scales)} pairs of features that touch, none does at the radius 5",
               all(x != 5 for x in scales) and len(scales) > 10)  # fmt: skip
    below, above = max(x for x in scales if x < 5), min(x for x in scales if x > 5)
    shown.tell(f"The radii of such contacts before and after it: ${sp.latex(below)}$ and "
               f"${sp.latex(above)}$.")  # fmt: skip
    shown.equal("squared distance from $(0, 5)$ to the polygon",
                squared_distance((Fraction(0), Fraction(5)), POCKET), 25)  # fmt: skip
    h, t = sp.symbols("h t", positive=True)
    shown.identity(r"disc at both tips, centre $(0, 8 - h)$: squared distance to the floor less "
                   r"$\rho^2$ is $16 (3 - h)$",
                   (8 - h) ** 2 - (h**2 + 16) - 16 * (3 - h))  # fmt: skip
    shown.identity("the disc on the floor with the centre $(4 - 4 t, 4 + t^2)$ is at the right tip",
                   (4 - 4 * t - 4) ** 2 + (4 + t**2 - 8) ** 2 - (4 + t**2) ** 2)  # fmt: skip
    shown.identity("squared distance to the left tip less $\\rho^2$ is $64 (1 - t)$",
                   (8 - 4 * t) ** 2 + (t**2 - 4) ** 2 - (4 + t**2) ** 2 - 64 * (1 - t))  # fmt: skip
    alive = [_bridges_of_pocket(1 + Fraction(k, 100)) for k in (-10, -1, 0, 1, 10)]
    shown.equal("of the three bridges inside the pocket, there just below, at and above the radius "
                "5", alive, [3, 3, 3, 0, 0])  # fmt: skip
    shown.draw("circles about the tips and the offset floor at the radius 4.6 leave a hole",
               swept(POCKET, [4.6], box=NEAR))  # fmt: skip
    shown.draw("at the radius 5 the hole ends; the disc touches three features",
               swept(POCKET, [5.0], [(0.0, 5.0, 5.0)], NEAR))  # fmt: skip


def _bridges_of_pocket(t: Fraction) -> int:
    """Counts empty discs: at both tips, and at a tip and the floor. Discs at the floor have radius
    4 + t^2; the other disc's radius lies on the same side of 5."""
    centres = [((4 - 4 * t) * side, 4 + t * t) for side in (1, -1)]
    h = 3 * t
    discs = [(x, x[1] ** 2) for x in centres] + [((Fraction(0), 8 - h), h * h + 16)]
    return sum(squared_distance(x, POCKET) == square for x, square in discs)


@CHAPTER.entry(
    "persistence-of-bridges",
    "Persistence is not the length of Voronoi segments",
    place="Section 8.2",
    status=Status.LITERAL,
    printed=r"""The intersections trace out the Voronoi diagram of the exterior; thus the analysis
    of the persistence of bridges, their life in $\alpha$, corresponds to measuring the length of
    its segments.""",
    right=r"""It is the change of clearance along the segment, $\Delta \alpha = 2 \Delta \rho$.
    Since the clearance $\rho$ changes by no more than the way, a life is at most twice the length,
    and may be less, down to nothing: the one does not tell the other. Between two vertices at the
    distance $D$, $\rho = \sqrt{h^2 + D^2/4}$ at the height $h$ above the middle; between parallel
    walls $\rho$ is constant; between walls at the angle $2 \theta$ it is $\sin \theta$ times the
    distance from their corner.""",
    reading=r"""Measure the segments by the change of clearance along them, in $\alpha$.""",
    code=("oracle/symbolic/disc/disc_contact.py",),
)
def _(shown: Shown) -> None:
    """By computer algebra the change of the clearance between two vertices is less than that of
    h, from an identity that leaves a positive term. Three exact instances: lives that are less than
    the length, zero, and greater."""
    h, k, c = sp.symbols("h_1 h_2 c", positive=True)
    shown.identity(r"with $\rho_i^2 = h_i^2 + c$: $(\rho_1 \rho_2)^2 = (h_1 h_2 + c)^2 + c (h_1 - "
                   r"h_2)^2$, so $(\Delta h)^2 - (\Delta \rho)^2 = 2 (\rho_1 \rho_2 - h_1 h_2 - c) "
                   "> 0$",
                   (h**2 + c) * (k**2 + c) - (h * k + c) ** 2 - c * (h - k) ** 2)  # fmt: skip
    r, q = sp.sqrt(h**2 + c), sp.sqrt(k**2 + c)
    shown.identity(
        r"$(\Delta h)^2 - (\Delta \rho)^2$ itself",
        (h - k) ** 2 - (r - q) ** 2 - 2 * (r * q - h * k - c),
    )
    low, high = (_clearance(Fraction(8) - x) for x in (Fraction(0), Fraction(3)))
    shown.equal("the bridge between the tips of the pocket: radii of its discs at $h = 0$ and $h = "
                "3$", (low, high), (4, 5))  # fmt: skip
    shown.different("its life in alpha, which is not the length of the segment", Fraction(3 - 0),
                    2 * (high - low))  # fmt: skip
    slot = [(0, 0), (12, 0), (12, 6), (8, 6), (8, 2), (4, 2), (4, 6), (0, 6)]
    radii = {squared_distance((Fraction(6), Fraction(y)), slot) for y in (4, 5, 6)}
    shown.equal("squared radii on the Voronoi segment of a slot from $(6, 4)$ to $(6, 6)$",
                sorted(radii), [4])  # fmt: skip
    shown.different("the life of a bridge of the slot", 6 - 4,
                    2 * (_root(max(radii)) - _root(min(radii))))  # fmt: skip
    theta, way = sp.symbols("theta l", positive=True)
    place = sp.Matrix([way, 0])
    normal = sp.Matrix([-sp.sin(theta), sp.cos(theta)])
    shown.identity(r"distance to a wall, $\theta$ off the bisector", sp.Abs(place.dot(normal)) -
                   way * sp.Abs(sp.sin(theta)))  # fmt: skip
    wedge = [(0, 0), (8, 6), (-10, 6), (-10, -6), (8, -6)]
    squares = [squared_distance((Fraction(x), Fraction(0)), wedge) for x in (0, 5)]
    shown.equal(r"a corner with $\sin \theta = 3/5$: squared radii at the ways 0 and 5", squares,
                [0, 9])  # fmt: skip
    shown.different("the life of that bridge over this way", 5 - 0,
                    2 * (_root(squares[1]) - _root(squares[0])))  # fmt: skip


def _clearance(y: Fraction) -> Fraction:
    """The distance from $(0, y)$ to the pocket's edges."""
    return _root(squared_distance((Fraction(0), y), POCKET))


def _root(square: Fraction) -> Fraction:
    """The square root of a number whose root is rational."""
    root = sp.sqrt(sp.Rational(*square.as_integer_ratio()))
    return Fraction(int(root.p), int(root.q))


@CHAPTER.entry(
    "limits-of-alpha",
    "Bridges for alpha near zero and near infinity",
    place="Section 8.2",
    status=Status.HOLDS,
    printed=r"""For $\alpha = 0$ bridges correspond to reflex vertices, for $\alpha = \infty$ to
    edges of the convex hull.""",
    right=r"""So it is in the limit. Below the least event the only curves that cross are the two
    offset edges at a reflex vertex, at $v + s r (n_1 + n_2) / (1 + n_1 \cdot n_2)$, and the feet of
    that disc come to $v$. For large $\alpha$ let $u$ and $v$ be vertices at the distance $D$, $m$
    their middle, and $n$ a unit vector normal to $u v$. The disc through both with the centre $m +
    h n$ has no vertex $w$ inside if $|w - m|^2 - D^2/4 - 2 h n \cdot (w - m) \ge 0$, for all large
    $h$ only if $w$ is not beyond the line $u v$. What is meant are the edges of the hull that are
    no edges of $P$.""",
    code=("oracle/symbolic/disc/disc_contact.py",),
)  # fmt: skip
def _(shown: Shown) -> None:
    """The identities by computer algebra. For a pocket, the least event from the symbolic oracle;
    at a radius below it the discs at all reflex vertices, exactly; and all pairs of vertices by the
    linear condition."""
    ring = [(-16, -4), (16, -4), (16, 6), (4, 8), (10, 0), (-10, 0), (-4, 8), (-16, 6)]
    least = exact(ring_touches(ring, 1)[0].root)
    shown.true(f"the least event of the pocket has the radius ${sp.latex(least)}$", least > 1)
    radius = Fraction(1, 10)
    reflex = reflex_pairs(ring)
    empty = sum(squared_distance(crossing(a, b, radius), ring) == radius**2 for a, b in reflex)
    shown.equal("reflex vertices of it, and how many of them have an empty disc of radius 1/10",
                (len(reflex), empty), (2, 2))  # fmt: skip
    s = sp.Symbol("s", positive=True)
    a, b = sp.symbols("a b", real=True)
    n1, n2 = (sp.Matrix([sp.cos(x), sp.sin(x)]) for x in (a, b))
    x = s * (n1 + n2) / (1 + n1.dot(n2))
    shown.identity("the crossing is on the first offset line", n1.dot(x) - s)
    shown.identity("and on the second", n2.dot(x) - s)
    foot = x - s * n1
    shown.identity("change with $s$ of the way from the vertex to a foot, divided by $s$",
                   sp.diff(foot / s, s).norm() ** 2)  # fmt: skip
    h, d, along, out = sp.symbols("h D w_1 w_2", positive=True)
    excess = along**2 + (out - h) ** 2 - (h**2 + d**2 / 4)
    shown.identity("squared distance of a vertex $w$ from the centre, less $\\rho^2$", excess -
                   (along**2 + out**2 - d**2 / 4 - 2 * h * out))  # fmt: skip
    shown.equal("bridges of the pocket that stay for all large alpha",
                _bridges_at_infinity(ring), [((4, 8), (-4, 8))])  # fmt: skip


def _bridges_at_infinity(ring: list[tuple[int, int]]) -> list[tuple[tuple[int, int], ...]]:
    """Vertex pairs, without edges, whose connecting line has every other vertex on its left, or on
    the line outside the pair."""
    sides = {frozenset(x) for x in zip(ring, ring[1:] + ring[:1], strict=True)}
    found: list[tuple[tuple[int, int], ...]] = []
    for u in ring:
        for v in ring:
            if u == v or frozenset((u, v)) in sides:
                continue
            others = [w for w in ring if w not in (u, v)]
            turns = [turn(u, v, w) for w in others]
            between = [dot(minus(w, u), minus(w, v)) for w in others]
            if all(x > 0 or (x == 0 and y >= 0) for x, y in zip(turns, between, strict=True)):
                found.append((u, v))
    return found
