"""Fig. 3: a T-edge moves, an S-edge moves and grows, and both cross another edge at a point that
moves along a line. Numbers are exact; only the drawing is rounded."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.plane import cross, minus
from minkref.reports.audit.edges import Edge, s_edge, t_edge
from minkref.reports.audit.symbolic_edges import ends
from minkref.reports.drawing import Label, Layer, Segment, picture
from minkref.reports.paper.entry import Claim, Picture

Point = tuple[Fraction, Fraction]
ACROSS = t_edge((-1, 3), (9, 5), (0, 0))  # stands still
EDGES = {"T-edge": t_edge((0, 0), (3, 6), (1, 0)), "S-edge": s_edge((1, 0), (3, 6), (1, 0))}
SCALES = (Fraction(1), Fraction(3, 2), Fraction(2))


def figure_3() -> tuple[list[Picture], list[Claim]]:
    pictures, claims = [], []
    for name, edge in EDGES.items():
        spans = [minus(*reversed(ends(edge, scale))) for scale in SCALES]
        factor = [spans[-1][i] / spans[0][i] for i in (0, 1)]
        claims.append(
            Claim(
                "the segment only translates as s changes"
                if name == "T-edge"
                else "the segment also scales as it translates",
                "Fig. 3",
                f"{name}: its length at two scales",
                f"at s = 2 it is {factor[0]} times as long as at s = 1",
                factor == [1, 1] if name == "T-edge" else factor == [2, 2],
            )
        )
        first, middle, last = (crossing(edge, ACROSS, scale) for scale in SCALES)
        even = minus(middle, first) == minus(last, middle)
        claims.append(
            Claim("x(s) is a parameterized line as well", "Sec. 4.2",
                  f"{name}: its crossing with an edge at three scales, exact",
                  "equal steps from s = 1 to 3/2 and to 2" if even else "unequal steps", even)
        )  # fmt: skip
        pictures.append(Picture(f"{name} at s = 1 and 2, and its intersection", _drawn(edge)))
    return pictures, claims


def crossing(a: Edge, b: Edge, scale: Fraction) -> Point:
    """The crossing of two non-parallel edges' lines."""
    (a0, a1), (b0, b1) = ends(a, scale), ends(b, scale)
    v, w = minus(a1, a0), minus(b1, b0)
    r = Fraction(cross(minus(b0, a0), w)) / cross(v, w)
    return a0[0] + r * v[0], a0[1] + r * v[1]


def _drawn(edge: Edge) -> str:
    layers = [Layer("second-edge", segments=[_segment(ACROSS, SCALES[0])])]
    for style, number in (("first-faint", 0), ("first-edge", -1)):
        layers.append(Layer(style, segments=[_segment(edge, SCALES[number])]))
    for name, number in (("x(1)", 0), ("x(2)", -1)):
        x, y = map(float, crossing(edge, ACROSS, SCALES[number]))
        layers.append(Layer("witness", point=(x, y), labels=[Label((x, y), name, move=(6, 14))]))
    return picture(layers, "an edge of the convolution at two scales", 300)


def _segment(edge: Edge, scale: Fraction) -> Segment:
    (x0, y0), (x1, y1) = ends(edge, scale)
    return float(x0), float(y0), float(x1), float(y1)
