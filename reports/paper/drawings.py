"""The paper's figures of models, sums and convolutions, drawn from ours."""

from __future__ import annotations

from minkref import _core
from minkref.operand import read_operand
from minkref.reports.bench.pairs import Pair
from minkref.reports.drawing import Layer, picture
from minkref.reports.paper.entry import Picture

# Fig. 2: small polygons of which one is reflex, as in the paper's figure.
FIGURE_2 = (
    '{"polygons":[{"outer":[["0","0"],["4","0"],["4","3"],["0","3"]]}]}',
    '{"polygons":[{"outer":[["0","0"],["6","0"],["6","4"],["3","1"],["0","4"]]}]}',
)


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


def figure_2() -> list[Picture]:
    P, Q = (_core.PolygonSet.from_json(text) for text in FIGURE_2)
    shapes = [
        Layer("first", P.approximate_rings()),
        Layer("second", Q.translated("6", "0").approximate_rings()),
    ]
    found = [Picture("P and Q", picture(shapes, "P and Q", 300))]
    for reduced, what in ((False, "convolution"), (True, "reduced convolution")):
        segments = _core.convolution_segments(P, Q, "1", reduced)
        layers = [
            Layer("sum", _core.minkowski_sum(P, Q, "1").region.approximate_rings()),
            Layer("first-edge", segments=segments),
        ]
        found.append(Picture(f"{what}: {len(segments)} edges", picture(layers, what, 300)))
    return found


def figure_6() -> list[Picture]:
    """Ours, of the sizes of the paper's."""
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
