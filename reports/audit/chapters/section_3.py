"""Sections 1 and 3: the convolution and its consequences."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.plane.operand import read_operand
from minkref.reports.audit.chapters import static_methods
from minkref.reports.audit.entry import Chapter, CheckFailed, Shown, Status, text
from minkref.reports.audit.pictures import sum_and_convolution
from minkref.reports.audit.plane import (
    Ring,
    bay,
    box,
    covered,
    crossings,
    operand,
    random_operand,
    reduced_by_rings,
    reduced_by_rule,
    rings_of,
    winding,
)

CHAPTER = Chapter("section-3", "Sections 1 and 3: the convolution")
SEED = 3
DRAWS = 60


def _boundary(P: Any, Q: Any) -> list[Any]:
    region = json.loads(_core.minkowski_sum(P, Q, "1").region.canonical_json())
    found = []
    for polygon in region["polygons"]:
        for ring in (polygon["outer"], *polygon["holes"]):
            places = [(Fraction(x), Fraction(y)) for x, y in ring]
            found += [(places[k - 1], places[k]) for k in range(len(places))]
    return found


def _missing(P: Any, Q: Any, ends: str) -> int:
    """Counts sum edges that the reduced convolution, with these ends of turns, does not cover."""
    segments = reduced_by_rule(P, Q, ends)
    return sum(not covered(edge, segments) for edge in _boundary(P, Q))


@CHAPTER.entry(
    "range-of-scales",
    "The range of scales",
    place="Sections 1, 4.1 and 7.1",
    status=Status.MISPRINT,
    printed=r"""$s \in (0, \infty)$ in Sections 1 and 4.1, and of neuron and disc in Section 7.1;
    $s \in (0, \infty]$ of monkey and bird in Section 7.1.""",
    right=r"""$s \in (0, \infty)$: no operand is scaled by infinity.""",
    code=("reference/plane/critical/scale_interval.hpp",),
)
def _(shown: Shown) -> None:
    """The events of a pair have scales that are positive numbers; asked for a scale of zero or
    below the code refuses. The operands are a triangle and a box with a triangular hole."""
    hole: Ring = [(0, 20), (17, -11), (-19, -9)]
    P, Q = operand([[(-3, -2), (4, -1), (1, 3)]]), operand([box(-40, -40, 80, 80), hole])
    told = _core.ArrangementEvents(P, Q)
    scales = [Fraction(row[0]) for row in told.rows(told.of_kind("arrangement"))]
    shown.true(
        f"all {len(scales)} events have a positive scale",
        len(scales) > 0 and all(x > 0 for x in scales),
    )
    for scale in ("0", "-1"):
        try:
            _core.minkowski_sum(P, Q, scale)
        except _core.BadInput:
            shown.tell(f"the scale {scale} is refused.")
        else:
            shown.true(f"the scale {scale} is refused", False)


@CHAPTER.entry(
    "sum-in-convolution",
    "The convolution is called a superset of the sum",
    place="Section 3",
    status=Status.LITERAL,
    printed=r"""$P \oplus Q \subseteq P \otimes Q$, and $\partial(P \oplus Q) = \partial(P \otimes
    Q)$.""",
    right=r"""The convolution is a set of curves, which no region is a part of. What holds is
    $\partial(P \oplus Q) \subseteq$ reduced convolution $\subseteq$ full convolution
    $\subseteq P \oplus Q$. Read of the region that the curves enclose, the first statement is true,
    and the second is true of the outer boundaries: the region has no holes, and the sum may have
    some.""",
    reading=r"""Read of the region that the curves enclose, the first statement is true, and the
    second is true of the outer boundaries.""",
    code=("reference/plane/convolution/convolution.hpp",),
)
def _(shown: Shown) -> None:
    """The centre of a sum of two boxes is in the sum and on no edge of the convolution. For sixty
    random pairs, with holes, every edge of the sum is covered by the reduced convolution, and the
    ends and middles of all segments of the full one are in the sum. The sum of a box and a frame
    with a wide hole has a hole."""
    P, Q = operand([box(0, 0, 2, 2)]), operand([box(0, 0, 2, 2)])
    shown.equal("contact of $P$ and $x - Q$ at $x = (2, 2)$",
                _core.decide(P, Q, "1", "2", "2")["contact"], "overlapping")  # fmt: skip
    x = (Fraction(2), Fraction(2))
    shown.true(
        "$x$ is on no edge of the reduced convolution",
        not covered((x, x), reduced_by_rule(P, Q, "[)(]")),
    )
    dice = random.Random(SEED)
    edges = bare = outside = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice), random_operand(dice)
        segments = reduced_by_rule(P, Q, "[)(]")
        for edge in _boundary(P, Q):
            edges += 1
            bare += not covered(edge, segments)
        places = [
            p
            for a, b in reduced_by_rule(P, Q, "[)(]", reflex=True)
            for p in (a, b, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2))
        ]
        contacts = _core.decide_many(P, Q, "1", [(str(u), str(v)) for u, v in places])
        outside += contacts.count("empty")
    shown.equal(f"of {edges:,} edges of sums, not covered by the reduced convolution", bare, 0)
    shown.equal("ends and middles of the full convolution outside the sum", outside, 0)
    frame = operand([box(0, 0, 9, 9), box(2, 2, 5, 5)])
    shown.equal("holes of the sum of a box and a frame",
                _core.minkowski_sum(operand([box(0, 0, 1, 1)]), frame, "1").holes, 1)  # fmt: skip


@CHAPTER.entry(
    "between",
    "What “between” means at its ends",
    place="Section 3",
    status=Status.INCOMPLETE,
    printed=r"""An edge and a vertex are compatible if the edge's direction is on the
    counter-clockwise turn from the vertex's incoming edge to its outgoing one.""",
    right=r"""The turn has to be half-open, with complementary ends: $[d_{in}, d_{out})$ at
    vertices of $Q$ and $(d_{in}, d_{out}]$ at vertices of $P$, or both the other way round. With
    the same ends on both sides, or with open ones, parallel edges leave parts of the boundary
    bare; with closed ones parts of it are covered twice.""",
    code=("reference/plane/convolution/convolution.cpp", "docs/definitions.md"),
)
def _(shown: Shown) -> None:
    """Two boxes, all of whose edges are parallel, and sixty random pairs on small grids: edges of
    the sum that are not covered by the convolution, for each rule of ends. The rule is written
    down here once more, in plain Python; the one with complementary ends has the edges of the
    code, one by one."""
    P, Q = operand([box(0, 0, 2, 1)]), operand([box(0, 0, 3, 4)])
    told = {rule: _missing(P, Q, rule) for rule in RULES}
    for rule, words in RULES.items():
        shown.tell(f"two boxes, {words}: {told[rule]} of 4 edges are not covered.")
    shown.equal("with complementary ends, not covered", (told["[)(]"], told["(][)"]), (0, 0))
    shown.true("with the same ends, or open ones, some are not covered",
               all(told[rule] > 0 for rule in ("[)[)", "(](]", "()()")))  # fmt: skip
    dice = random.Random(SEED)
    pairs = [(random_operand(dice), random_operand(dice)) for _ in range(DRAWS)]
    sums = {rule: sum(_missing(P, Q, rule) for P, Q in pairs) for rule in RULES}
    for rule, words in RULES.items():
        shown.tell(f"{DRAWS} random pairs, {words}: {sums[rule]} edges are not covered.")
    shown.equal("random pairs, complementary ends", (sums["[)(]"], sums["(][)"]), (0, 0))
    shown.true("random pairs, the others, closed ones aside: some are bare",
               min(sums["[)[)"], sums["(](]"], sums["()()"]) > 0)  # fmt: skip
    P, Q = operand([box(0, 0, 2, 1)]), operand([box(0, 0, 3, 4)])
    lengths = [sum(abs(b[0] - a[0]) + abs(b[1] - a[1]) for a, b in reduced_by_rule(P, Q, rule))
               for rule in ("[)(]", "[][]")]  # fmt: skip
    shown.equal("two boxes, lengths of all edges, complementary ends and closed ones; the boundary "
                "of the sum has the length 20", lengths, [20, 40])  # fmt: skip
    same = all(sorted(reduced_by_rule(P, Q, "[)(]")) == _edges_of_code(P, Q) for P, Q in pairs)
    shown.true("the code has the edges of the rule, for each pair", same)


def _edges_of_code(P: Any, Q: Any) -> list[Any]:
    rings = {"S": (rings_of(P), rings_of(Q)), "T": (rings_of(Q), rings_of(P))}
    found = []
    for kind, _, edge_ring, edge, vertex_ring, vertex in _core.reduced_convolution(P, Q):
        edges, vertices = rings[kind]
        ring, v = edges[edge_ring], vertices[vertex_ring][vertex]
        a, b = ring[edge], ring[(edge + 1) % len(ring)]
        found.append(((a[0] + v[0], a[1] + v[1]), (b[0] + v[0], b[1] + v[1])))
    return sorted(found)


RULES = {
    "[)(]": "$[d_{in}, d_{out})$ at $Q$, $(d_{in}, d_{out}]$ at $P$",
    "(][)": "$(d_{in}, d_{out}]$ at $Q$, $[d_{in}, d_{out})$ at $P$",
    "[)[)": "$[d_{in}, d_{out})$ at both",
    "(](]": "$(d_{in}, d_{out}]$ at both",
    "()()": "open at both",
    "[][]": "closed at both",
}


@CHAPTER.entry(
    "orientation",
    "How the rings run",
    place="Section 3, Fig. 1",
    status=Status.INCOMPLETE,
    printed=r"""Both polygons are counter-clockwise. (The neuron of Fig. 1 has 18 holes, whose
    orientation is not spoken of.)""",
    right=r"""Holes have to run clockwise: the operand is on the left of each of its edges. Then the
    sum is on the left of each edge of the convolution.""",
    code=("reference/plane/convolution/convolution.cpp", "docs/definitions.md"),
)
def _(shown: Shown) -> None:
    """A triangle and a frame: edges of the sum that the convolution does not cover, the hole being
    clockwise, and being counter-clockwise. Then, for sixty random pairs, places just beside the
    middle of each edge of the convolution, on its left."""
    P, hole = operand([[(0, 0), (2, 1), (0, 1)]]), box(2, 2, 5, 5)
    Q = operand([box(0, 0, 9, 9), hole])
    outer, inner = rings_of(Q)
    boundary = _boundary(P, Q)
    for words, ring, wanted in (("clockwise", inner, 0), ("counter-clockwise", inner[::-1], 4)):
        segments = reduced_by_rings(rings_of(P), [outer, ring], "[)(]")
        shown.equal(f"the hole {words}: of {len(boundary)} edges of the sum, not covered",
                    sum(not covered(edge, segments) for edge in boundary), wanted)  # fmt: skip
    dice = random.Random(SEED)
    count = left = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice), random_operand(dice)
        places = []
        for a, b in reduced_by_rule(P, Q, "[)(]"):
            d = (b[0] - a[0]) / 10**6, (b[1] - a[1]) / 10**6
            places.append((str((a[0] + b[0]) / 2 - d[1]), str((a[1] + b[1]) / 2 + d[0])))
        count += len(places)
        left += _core.decide_many(P, Q, "1", places).count("overlapping")
    shown.true(f"{count:,} edges of random pairs: just left of all middles is the sum",
               0 < count == left)  # fmt: skip


@CHAPTER.entry(
    "straight-vertices",
    "Vertices in the middle of straight edges",
    place="Sections 1 and 3",
    status=Status.INCOMPLETE,
    printed=r"""Reflex vertices, those with an interior angle above 180 degrees, are left out.
    Vertices with 180 degrees are not spoken of.""",
    right=r"""They are to be left out as well: with half-open turns theirs is empty, and the
    boundary stays covered by the pieces of the edge that they cut.""",
    code=("reference/plane/convolution/convolution.cpp",),
)
def _(shown: Shown) -> None:
    """A box with three vertices inside its edges and a triangle: with complementary ends the
    boundary is covered, and the convolution has the edges of the box without these vertices, three
    of them cut once more."""
    P = operand([[(0, 0), (1, 0), (3, 0), (3, 2), (3, 3), (0, 3), (0, 1)]])
    Q = operand([[(0, 0), (2, 0), (0, 1)]])
    shown.equal("edges of the sum that are not covered", _missing(P, Q, "[)(]"), 0)
    plain = operand([box(0, 0, 3, 3)])
    same = (
        _core.minkowski_sum(P, Q, "1").region.canonical_json()
        == _core.minkowski_sum(plain, Q, "1").region.canonical_json()
    )
    shown.true("the sum is that of the box without these vertices", same)
    shown.equal("edges of the convolution, and without these vertices",
                (len(_core.reduced_convolution(P, Q)), len(_core.reduced_convolution(plain, Q))),
                (10, 7))  # fmt: skip


@CHAPTER.entry(
    "reflex-vertices",
    "Reflex vertices contribute nothing to the boundary",
    place="Section 3",
    status=Status.HOLDS,
    printed=r"""Contributions of reflex vertices are interior to the sum.""",
    right=r"""So it is in the plane: near a reflex vertex an operand has more than a half-plane,
    and with the half-plane beside the edge of the other one it gives a neighbourhood. (Of all inner
    points of the contributed segments; that is what extraction needs.)""",
    code=("reference/plane/convolution/convolution.cpp",),
)
def _(shown: Shown) -> None:
    """The middles of all segments that reflex vertices contribute to sixty random pairs, with
    half-open ends of the turn, are in the interior of the sum."""
    dice = random.Random(SEED)
    count = inside = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice), random_operand(dice)
        own = reduced_by_rule(P, Q, "[)(]")
        both = reduced_by_rule(P, Q, "[)(]", reflex=True)
        extra = both[len(own) :]
        middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in extra]
        contacts = _core.decide_many(P, Q, "1", [(str(u), str(v)) for u, v in middles])
        count += len(extra)
        inside += contacts.count("overlapping")
    shown.true(f"{count:,} segments from reflex vertices, all middles inside", 0 < count == inside)


@CHAPTER.entry(
    "winding-numbers",
    "Cells with winding numbers that are not zero",
    place="Section 3 (of earlier work)",
    status=Status.CONDITION,
    printed=r"""The cells of the arrangement of the convolution whose winding number is not zero
    are kept.""",
    right=r"""The number at $x$ is the Euler characteristic of $P \cap (x - Q)$. It is positive
    inside the sum if the operands are simply connected. With holes it may be zero inside.""",
    code=("degeneracies/pages/euler-zero.md", "reference/plane/routes/winding_route.cpp"),
)
def _(shown: Shown) -> None:
    """A box with a hole and a larger box: a point inside, around which the full convolution winds
    zero times. For sixty random pairs without holes, the winding number is positive exactly inside:
    at a point of each bounded face of the arrangement, holes of the sum among them, and at ten
    random points of the box around the sum."""
    P = operand([box(0, 0, 8, 8), box(3, 3, 2, 2)[::-1]])
    Q = operand([box(0, 0, 20, 20)])
    x = (Fraction(151, 10), Fraction(149, 10))
    shown.equal("winding number at $x = (15.1, 14.9)$", winding(P, Q, x), 0)
    shown.equal("contact of $P$ and $x - Q$", _core.decide(P, Q, "1", *map(str, x))["contact"],
                "overlapping")  # fmt: skip
    shown.draw("the sum and its convolution, and the point", sum_and_convolution(P, Q, "1", x))
    dice = random.Random(SEED)
    inside = outside = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice, holes=False), bay(dice)
        full = reduced_by_rule(P, Q, "[)(]", reflex=True, signed=True)
        points = _generic_points(P, Q, dice)
        contacts = _core.decide_many(P, Q, "1", points)
        for (u, v), contact in zip(points, contacts, strict=True):
            number = crossings(full, (Fraction(u), Fraction(v)))
            if contact == "touching" or (number > 0) != (contact == "overlapping"):
                raise CheckFailed(text((P.to_json(), Q.to_json(), u, v)))
            inside += number > 0
            outside += number <= 0
    shown.true(
        f"{inside:,} points inside, {outside:,} outside, without holes: positive exactly inside",
        min(inside, outside) > 100,
    )


def _generic_points(P: Any, Q: Any, dice: random.Random) -> list[tuple[str, str]]:
    """A point from each bounded face of the arrangement, plus ten points with a denominator that
    none of its lines has."""
    found = [(u, v) for u, v, _ in _core.face_points(P, Q, "1")]
    rows = [place for edge in reduced_by_rule(P, Q, "[)(]") for place in edge]
    (left, right), (low, high) = ((min(x), max(x)) for x in zip(*rows, strict=True))
    for _ in range(10):
        t, u = (Fraction(dice.randint(0, 10006), 10007) for _ in "xy")
        place = str(left + t * (right - left)), str(low + u * (high - low))
        if _core.decide(P, Q, "1", *place)["contact"] != "touching":
            found.append(place)
    return found


@CHAPTER.entry(
    "reduced-is-no-cycle",
    "The reduced convolution is no cycle",
    place="Section 3",
    status=Status.INCOMPLETE,
    printed=r"""The updates can be used in any method based on the convolution, that by winding
    numbers among them; they are explained on the reduced convolution.""",
    right=r"""Winding numbers need the full convolution, which is a closed cycle. The reduced one
    need not be: crossing numbers with respect to it do not tell inside from outside. It needs the
    test of a point of each face.""",
    code=("reference/plane/routes/paper_route.hpp",),
)
def _(shown: Shown) -> None:
    """Of sixty random pairs: whether there are nodes at which not as many edges of the convolution
    arrive as leave, for the full and the reduced one. Then the signed crossings of the reduced one
    and a ray, from a point of each bounded face of pairs without holes."""
    dice = random.Random(SEED)
    full = reduced = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice), random_operand(dice)
        full += _unbalanced(reduced_by_rule(P, Q, "[)(]", reflex=True, signed=True))
        reduced += _unbalanced(reduced_by_rule(P, Q, "[)(]"))
    shown.equal("pairs whose full convolution is not closed", full, 0)
    shown.true(f"pairs whose reduced convolution is not closed: {reduced}", reduced > 0)
    points = wrong = 0
    for _ in range(DRAWS):
        P, Q = random_operand(dice, holes=False), bay(dice)
        segments = reduced_by_rule(P, Q, "[)(]")
        for u, v, inside in _core.face_points(P, Q, "1"):
            points += 1
            wrong += (crossings(segments, (Fraction(u), Fraction(v))) > 0) != inside
    shown.true(f"crossing numbers of the reduced one are wrong at {wrong} of {points:,} points",
               wrong > 0)  # fmt: skip


def _unbalanced(segments: list[Any]) -> bool:
    nodes: dict[Any, int] = {}
    for a, b in segments:
        nodes[a] = nodes.get(a, 0) + 1
        nodes[b] = nodes.get(b, 0) - 1
    return any(nodes.values())


@CHAPTER.entry(
    "updates-by-winding-numbers",
    "The updates serve a method by winding numbers",
    place="Section 3",
    status=Status.HOLDS,
    printed=r"""The methods of updating can be used in any method based on the convolution.""",
    right=r"""So they can with the full convolution. Its events are those of the same formulas, for
    more edges; between two events the faces keep their winding numbers, and what changes them at an
    event are signs of edges. Operands with holes have to be cut first. The price is the number of
    events.""",
    code=("reference/plane/dynamic/winding_status.hpp",),
)
def _(shown: Shown) -> None:
    """The full convolutions of random pairs, with holes too, are stepped between random scales, and
    compared with static ones each time: points on the edges, winding numbers and canonical sum are
    the same. Then the pair events of both convolutions of a disc and our net of nerve cells."""
    dice = random.Random(SEED)
    moves = 0
    for _ in range(DRAWS // 6):
        P, Q = random_operand(dice), random_operand(dice)
        sums = _core.DynamicSum(P, Q, route="winding")
        for _ in range(6):
            sums.move_to(str(Fraction(dice.randint(1, 90), dice.randint(1, 30))))
            moves += 1
            if wrong := sums.difference_from_scratch():
                raise CheckFailed(text((P.to_json(), Q.to_json(), wrong)))
    shown.true(f"{moves} moves of {DRAWS // 6} pairs: the same as from scratch", moves > 50)
    disc, cells = (read_operand(name) for name in ("disc1", "cells1815"))
    full, reduced = (
        _core.pair_events(disc.set, cells.set, kind="pair", route=route).counts()["count"]
        for route in ("winding", "dynamic")
    )
    shown.true(
        f"{disc.name} and {cells.name}: {full:,} pair events of the full convolution, "
        f"{reduced:,} of the reduced one",
        full > reduced,
    )


@CHAPTER.entry(
    "orientable-loops",
    "Nested orientable loops, and collision detection",
    place="Section 3",
    status=Status.CONDITION,
    printed=r"""Properly nested orientable loops are extracted from the intersections, and a step
    of collision detection removes those that are left in error.""",
    right=r"""For each face of the arrangement the collision of $P$ and $x - Q$, $x$ inside the
    face, decides alone, and nothing else does: orientability is necessary for a face outside the
    sum, and not sufficient. Loops have to be taken as faces, since they may touch at vertices.""",
    code=("reference/plane/routes/paper_route.hpp",),
)
def _(shown: Shown) -> None:
    """Pairs of a random polygon and a box with a bay. The code takes a bounded face whose boundary
    does not run clockwise all around for one inside, without more ado, and decides the others by
    collision detection. For all faces this is compared with the definition, decided otherwise, by
    triangles. Of the faces that are orientable some are inside the sum after all."""
    dice = random.Random(SEED)
    faces = outside = orientable = 0
    agreed = True
    for _ in range(3 * DRAWS):
        P, Q = random_operand(dice), bay(dice)
        points = _core.face_points(P, Q, "1")
        contacts = _core.decide_many(P, Q, "1", [(u, v) for u, v, _ in points])
        faces += len(points)
        outside += contacts.count("empty")
        orientable += _core.minkowski_sum(P, Q, "1").statistics["orientable_faces"]
        agreed &= all(
            (contact != "empty") == inside
            for contact, (_, _, inside) in zip(contacts, points, strict=True)
        )
    shown.true(f"{faces:,} bounded faces: inside exactly where $P$ and $x - Q$ meet", agreed)
    shown.true(
        f"{orientable} of them are orientable, {outside} are outside the sum",
        0 < outside < orientable,
    )


@CHAPTER.entry(
    "events-of-pairs",
    "The arrangement changes at critical scales of pairs only",
    place="Sections 1, 3 and 4",
    status=Status.INCOMPLETE,
    printed=r"""The structure of the arrangement changes only at critical scales (Section 3), which
    are those at which intersections of two edges come or go (Sections 1 and 4).""",
    right=r"""The set of intersecting edges changes at these only, as Section 1 has it. But the
    structure of the arrangement also changes where three edges come to pass through one point: the
    order of nodes along an edge changes, and holes begin and end. The condition is a determinant of
    three lines $n_i \cdot x = s \alpha_i + \beta_i$, linear in $s$. There may be of the order of
    $N^3$ such scales. An update that sorts the nodes along each edge anew at the final scale, and
    extracts the loops anew, is right without them; but what happens between two events of pairs
    they alone can tell.""",
    code=("reference/plane/dynamic/triple_events.hpp",),
)
def _(shown: Shown) -> None:
    """A triangle and a box with a triangular hole: the hole of the sum ends at 541/186, where no
    two edges start or stop meeting; sums just below, at and above it. The determinant is linear in
    s, by computer algebra."""
    import sympy as sp

    P = operand([[(-3, -2), (4, -1), (1, 3)]])
    hole: Ring = [(0, 20), (17, -11), (-19, -9)]
    Q = operand([box(-40, -40, 80, 80), hole])
    s = Fraction(541, 186)
    pairs = _core.pair_events(P, Q)
    at = {Fraction(row[0]) for row in pairs.rows(0, len(pairs))}
    shown.true("541/186 is no scale of an event of two edges", s not in at)
    near = Fraction(1, 10**6)
    holes = [_core.minkowski_sum(P, Q, str(x)).holes for x in (s - near, s, s + near)]
    shown.equal("holes just below, at and above it", tuple(holes), (1, 0, 0))
    told = _core.ArrangementEvents(P, Q, str(s), str(s))
    kinds = {row[1] for row in told.rows(told.of_kind("arrangement"))}
    shown.equal("kinds of events there", tuple(sorted(kinds)), ("triple",))
    t = sp.Symbol("s")
    rows = [
        [*sp.symbols(f"n{i}x n{i}y"), t * sp.Symbol(f"alpha{i}") + sp.Symbol(f"beta{i}")]
        for i in range(3)
    ]
    shown.identity("second derivative of the determinant", sp.Matrix(rows).det().diff(t, 2))
    shown.draw("the sum and its convolution at 2.5", sum_and_convolution(P, Q, "5/2"))


@CHAPTER.entry(
    "worst-case",
    "The worst case of the static sum",
    place="Section 3",
    status=Status.CONDITION,
    printed=r"""The worst-case complexity of the algorithms is $O(m^d n^d)$, “which is optimal with
    respect to the worst-case complexity of the Minkowski sum boundary”.""",
    right=r"""So it is of the arrangement and of the boundary, in the plane: two combs of $m$ and
    $n$ teeth, each beside squares that belong to the same operand, have a sum with $(m n - 1)^2$
    holes. (For operands of one polygon each the bound is known, and not checked here.) As a bound
    of the time it leaves out the logarithm of sorting, and the step of collision detection, which
    is done for each loop and is not constant. (In space nothing is checked here.)""",
    code=("degeneracies/plane/convolutions.py",),
)
def _(shown: Shown) -> None:
    """Sums of growing combs: the number of their holes, and of the vertices of both operands."""
    from minkref.reports.audit.plane import combs

    for m, n in ((2, 2), (2, 3), (3, 3), (3, 5), (4, 4), (5, 5)):
        P, Q = combs(m, n)
        shown.equal(f"$m = {m}$, $n = {n}$: holes of the sum, which are $(m n - 1)^2$",
                    _core.minkowski_sum(P, Q, "1").holes, (m * n - 1) ** 2)  # fmt: skip
        shown.equal("vertices", (P.vertices, Q.vertices), (8 * m, 8 * n))


@CHAPTER.entry(
    "size-of-preprocessing",
    "Pre-processing in O(n²)",
    place="Sections 4.2.3 and 7.1",
    status=Status.CONDITION,
    printed=r"""Intervals for all pairs of segments are computed in $O(n^2)$.""",
    right=r"""So it is if $n$ is the number $N$ of edges of the convolution, which may be $\Theta(m
    n)$ for operands of $m$ and $n$ vertices: then it is $m^2 n^2$ pairs. Sorting the events adds a
    logarithm. “Output-sensitive” (Section 1) is not true of it. Nor is it of updates without
    reservation: they pass all events in between, also those that the boundary does not show, and
    then move every node.""",
    code=("reference/plane/critical/pair_events.hpp",),
)
def _(shown: Shown) -> None:
    """Edges of the convolutions of stars, against the product of the numbers of vertices."""
    from minkref.reports.audit.plane import star

    shares: list[Fraction] = []
    for n in (8, 16, 32):
        P, Q = star(n, 1), star(n, 2)
        edges = len(_core.reduced_convolution(P, Q))
        shares.append(Fraction(edges, 4 * n * n))
        shown.tell(
            f"two stars of {2 * n} vertices: {edges:,} edges, {float(shares[-1]):.2f} times the "
            "product."
        )
    shown.true("the share of the product does not fall", shares == sorted(shares))


CHAPTER.entries.extend(static_methods.PART.entries)
