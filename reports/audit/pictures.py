"""Counterexamples drawn."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.reports.audit.edges import Edge, Interval
from minkref.reports.audit.symbolic_edges import ends
from minkref.reports.drawing import Layer, Segment, picture

FROM, TO, STEPS = Fraction(1, 5), Fraction(4), 12


def moving_edges(a: Edge, b: Edge, interval: Interval) -> str:
    """Both edges at scales from 1/5 to 4, drawn stronger at the interval's ends."""
    scales = [FROM + (TO - FROM) * i / STEPS for i in range(STEPS + 1)]
    layers = [
        Layer(style, segments=[_segment(edge, scale) for scale in scales])
        for edge, style in ((a, "first-faint"), (b, "second-faint"))
    ]
    marked = [scale for scale in interval or () if scale is not None]
    layers += [
        Layer(style, segments=[_segment(edge, scale) for scale in marked])
        for edge, style in ((a, "first-edge"), (b, "second-edge"))
    ]
    return picture(layers, "two edges at several scales", 320)


def _segment(edge: Edge, scale: Fraction) -> Segment:
    (x0, y0), (x1, y1) = ends(edge, scale)
    return float(x0), float(y0), float(x1), float(y1)


def sum_and_convolution(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    scale: str,
    point: tuple[Fraction, Fraction] | None = None,
) -> str:
    """The sum, the edges of the reduced convolution, and perhaps a marked point."""
    layers = [
        Layer("sum", _core.minkowski_sum(P, Q, scale).region.approximate_rings()),
        Layer("convolution", segments=_core.convolution_segments(P, Q, scale, True)),
    ]
    if point is not None:
        layers.append(Layer("witness", point=(float(point[0]), float(point[1]))))
    return picture(layers, "the sum and its convolution", 320)
