"""The paper's figures of models, sums and convolutions, drawn from ours."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.offset_picture import offset_picture
from minkref.plane.operand import read_operand
from minkref.reports.bench.pairs import Pair
from minkref.reports.drawing import Layer, picture
from minkref.reports.paper.entry import Claim, Picture

# Fig. 2: four and five vertices, one of them reflex, as the paper draws them.
P_OF_FIGURE_2 = (("0", "0"), ("4", "-1"), ("5", "2"), ("1", "3"))
Q_OF_FIGURE_2 = (("0", "0"), ("6", "0"), ("6", "4"), ("3", "1"), ("0", "4"))
AT_Q0 = (0.0, 0.0, 4.0, -1.0)  # the edge p0 p1 at q0
REFLEX = (3.0, 1.0)


def figure_1(pair: Pair) -> list[Picture]:
    """The input, sums and convolutions of Q and of P at the scales 1 and 2."""
    found = [Picture(f"input: {pair.P.name} and {pair.Q.name}", _operands(pair))]
    for scale in ("1", "2"):
        total = _core.minkowski_sum(pair.P.set, pair.Q.set, scale)
        counts = f"{total.components} component(s), {total.holes} hole(s)"
        found.append(Picture(f"sum at s = {scale}: {counts}", _sum(total.region)))
    for scale in ("1", "2"):
        found.append(Picture(f"reduced convolution at s = {scale}", _edges(pair, scale, True)))
    return found


def figure_2() -> tuple[list[Picture], list[Claim]]:
    P, Q = (_core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": ring}]}))
            for ring in (P_OF_FIGURE_2, Q_OF_FIGURE_2))  # fmt: skip
    shapes = [
        Layer("first", P.approximate_rings()),
        Layer("second", Q.translated("6", "0").approximate_rings()),
    ]
    pictures = [Picture("P and Q", picture(shapes, "P and Q", 300))]
    found = {}
    total = _core.minkowski_sum(P, Q, "1").region.approximate_rings()
    for reduced, what in ((False, "convolution"), (True, "reduced convolution")):
        found[reduced] = segments = _core.convolution_segments(P, Q, "1", reduced)
        layers = [Layer("sum", total), Layer("first-edge", segments=segments)]
        pictures.append(Picture(f"{what}: {len(segments)} edges", picture(layers, what, 300)))
    left_out = set(found[False]) - set(found[True])
    shared = set(found[True]) <= set(found[False])
    of_reflex = {
        (x0 - REFLEX[0], y0 - REFLEX[1], x1 - REFLEX[0], y1 - REFLEX[1])
        for x0, y0, x1, y1 in left_out
    }
    sides = set()
    for (x0, y0), (x1, y1) in pairwise([*P_OF_FIGURE_2, P_OF_FIGURE_2[0]]):
        side = (float(x0), float(y0), float(x1), float(y1))
        sides |= {side, (*side[2:], *side[:2])}
    return pictures, [
        Claim("Edge p0p1 is compatible with q0", "Fig. 2", "the rule of Section 3, on our polygons",
              "in the convolution" if AT_Q0 in found[False] else "missing",
              AT_Q0 in found[False]),
        Claim("We exclude contributions from reflex vertices (2D)", "Sec. 3",
              "the edges that the reduced convolution leaves out",
              f"edges left out: {len(left_out)}, at the reflex vertex of Q",
              bool(left_out) and shared and of_reflex <= sides),
    ]  # fmt: skip


def figure_6() -> list[Picture]:
    """Our polygons with the paper's vertex counts."""
    found = []
    for name in ("g1", "g2", "g3", "g4", "dog145"):
        operand = read_operand(name).set
        svg = picture([Layer("first", operand.approximate_rings())], name, 180)
        found.append(Picture(f"{name} ({operand.vertices})", svg))
    return found


def figure_7_inputs(pair: Pair) -> list[Picture]:
    return [
        Picture(f"{one.name} ({one.set.vertices})",
                picture([Layer("first", one.set.approximate_rings())], one.name, 300))
        for one in (pair.P, pair.Q)
    ]  # fmt: skip


def with_true_disc(pair: Pair) -> tuple[list[Picture], list[Claim]]:
    """Sums of the second operand: with the first, a polygon about the origin, and with the disc
    through that polygon's farthest corners; with a claim that compares both."""
    corners = [(Fraction(x), Fraction(y)) for rings in pair.P.set.rings() for x, y in rings[0]]
    square = max(x * x + y * y for x, y in corners)
    disc, by_polygon = (
        _core.offset(pair.Q.set, str(square)),
        _core.minkowski_sum(pair.P.set, pair.Q.set, "1"),
    )
    radius = math.sqrt(square)
    caption = f"with a true disc of the radius {radius:g}: {_counts(disc)}"
    pictures = [
        Picture(f"with the polygon: {_counts(by_polygon)}", _sum(by_polygon.region)),
        Picture(caption, offset_picture(disc, pair.Q.set, caption)),
    ]
    area, most = float(Fraction(by_polygon.region.area())), disc.area[1]
    claim = Claim(
        "the disc is represented as a polygon with 32 vertices",
        "Fig. 1",
        "the sum with the polygon has no more area than with the true disc through its corners",
        f"areas {area:.6g} and {most:.6g}, curves {by_polygon.region.vertices:,} and "
        f"{disc.curves:,}",
        area <= most,
    )
    return pictures, [claim]


def _counts(found: _core.Sum | _core.Offset) -> str:
    return f"{found.components} component(s), {found.holes} hole(s)"


def _operands(pair: Pair) -> str:
    layers = [
        Layer("second", pair.Q.set.approximate_rings()),
        Layer("first", pair.P.set.approximate_rings()),
    ]
    return picture(layers, "the operands", 300)


def _sum(region: _core.PolygonSet) -> str:
    return picture([Layer("sum", region.approximate_rings())], "the sum", 300)


def _edges(pair: Pair, scale: str, reduced: bool) -> str:
    segments = _core.convolution_segments(pair.P.set, pair.Q.set, scale, reduced)
    return picture([Layer("convolution", segments=segments)], "the convolution", 300)
