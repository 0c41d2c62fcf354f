"""Judges pictures of sums with a disc: one map takes the sum to the picture, up to the decimals."""

from __future__ import annotations

import math

import gmpy2
from minkref.reports.evidence.as_written.curves import Arc, Grown, Place
from minkref.reports.evidence.as_written.distance import Ring
from minkref.reports.evidence.as_written.read_svg import Step, paths
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import Real

MARGIN = 12
LONGER = 656  # picture units along the sum's longer side
HALF = 0.000_51  # of the third decimal


class Frame:
    """The sum's box, 656 units along its longer side, with a margin of 12; y points up."""

    def __init__(self, of: Grown) -> None:
        xs, ys = zip(*_extremes(of), strict=True)
        self.left, self.top = min(xs), max(ys)
        self.scale = LONGER / max(max(xs) - self.left, self.top - min(ys))

    def __call__(self, p: Place) -> tuple[float, float]:
        return (
            float(MARGIN + (p[0] - self.left) * self.scale),
            float(MARGIN + (self.top - p[1]) * self.scale),
        )


def _extremes(of: Grown) -> list[Place]:
    """Corners, and the arcs' farthest points along each axis."""
    found: list[Place] = []
    radius = of.radius
    zero = gmpy2.mpq(0)
    for piece in (piece for ring in of.rings for piece in ring):
        if piece.start is not None:
            found.append(piece.start)
        if not isinstance(piece.curve, Arc):
            continue
        x, y = piece.curve.x, piece.curve.y
        for ux, uy in ((radius, zero), (zero, radius), (-radius, zero), (zero, -radius)):
            if piece.start is None or _between(piece.start, (x + ux, y + uy), piece.end, (x, y)):
                found.append((x + ux, y + uy))
    return found


def _between(start: Place, p: Place, end: Place | None, centre: Place) -> bool:
    """Whether `p` is on the arc from `start` counter-clockwise to `end`."""
    assert end is not None

    def turned(q: Place) -> Real:
        ax, ay, bx, by = (
            start[0] - centre[0],
            start[1] - centre[1],
            q[0] - centre[0],
            q[1] - centre[1],
        )
        at = gmpy2.atan2(gmpy2.mpfr(ax * by - ay * bx), gmpy2.mpfr(ax * bx + ay * by))
        return at if at >= 0 else at + 2 * gmpy2.const_pi()

    return bool(turned(p) <= turned(end))


def judge(tally: Tally, writer: str, text: str, of: Grown, operand: list[Ring]) -> None:
    """Judges the corners of sum and operand, and the radii of arcs."""
    drawn, frame = paths(text), Frame(of)
    steps = [step for ring in drawn["sum"] for step in ring]
    places = [_place(step) for step in steps]
    tally.numbers[writer] += 2 * len(places)
    for place in places:
        if not all(map(math.isfinite, place)):
            tally.fault(writer, "NaN or infinity", str(place))
    pieces = [piece for ring in of.rings for piece in ring]
    corners = [frame(piece.start) for piece in pieces if piece.start is not None]
    for corner in corners:
        if not any(_same(corner, place) for place in places):
            tally.fault(writer, "a corner is not in the picture", f"it is at {corner}")
    for place in places:
        if not any(_same(corner, place) for corner in corners) and not _on_circle(place, of, frame):
            tally.fault(writer, "a place of the picture that is no corner", str(place))
    for step in steps:
        if (
            step.radius is not None
            and abs(float(step.radius) - float(of.radius * frame.scale)) > HALF
        ):
            tally.fault(writer, "a radius in the picture", f"{step.radius}")
    wanted = [frame(p) for ring in operand for p in ring]
    shown = [_place(step) for ring in drawn.get("first", []) for step in ring]
    tally.numbers[writer] += 2 * len(shown)
    if len(operand[0]) > 2 and not all(any(_same(p, place) for place in shown) for p in wanted):
        tally.fault(writer, "a vertex of the operand is not in the picture", "")


def _place(step: Step) -> tuple[float, float]:
    return float(step.x), float(step.y)


def _same(a: tuple[float, float], b: tuple[float, float]) -> bool:
    return abs(a[0] - b[0]) <= HALF and abs(a[1] - b[1]) <= HALF


def _on_circle(place: tuple[float, float], of: Grown, frame: Frame) -> bool:
    """Whether an arc may be cut at a place of the picture."""
    radius = float(of.radius * frame.scale)
    for piece in (piece for ring in of.rings for piece in ring):
        if isinstance(piece.curve, Arc):
            x, y = frame((piece.curve.x, piece.curve.y))
            if abs(math.hypot(place[0] - x, place[1] - y) - radius) <= 2 * HALF:
                return True
    return False
