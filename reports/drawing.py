"""Pictures of polygon sets and segments as SVG, for looking at: coordinates are rounded."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from html import escape

from minkref.output.terminal import escaped
from minkref.plane.exact_frame import Frame
from minkref.reports.axes import drawn_axes, room_of_numbers

Segment = tuple[float, float, float, float]
Polygons = Sequence[Sequence[Sequence[tuple[float, float]]]]  # per polygon: outer ring, holes
Box = tuple[float, float, float, float]
PAD = 8.0
BELOW = 22.0  # room for the numbers of an axis


@dataclass(frozen=True)
class Label:
    """A text at a place, moved by some picture units; `anchor` has SVG's meaning."""

    at: tuple[float, float]
    text: str
    anchor: str = "start"
    move: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Layer:
    """Rings, segments, a marked point and texts, drawn with a page's style class."""

    style: str
    polygons: Polygons = ()
    segments: Sequence[Segment] = ()
    point: tuple[float, float] | None = None
    labels: Sequence[Label] = ()


def bounds(layers: Iterable[Layer]) -> Box:
    """The box around all layers; without content a unit square."""
    xs: list[float] = []
    ys: list[float] = []
    for layer in layers:
        for polygon in layer.polygons:
            for ring in polygon:
                xs += [x for x, _ in ring]
                ys += [y for _, y in ring]
        for x0, y0, x1, y1 in layer.segments:
            xs += [x0, x1]
            ys += [y0, y1]
        if layer.point:
            xs.append(layer.point[0])
            ys.append(layer.point[1])
    return (min(xs), min(ys), max(xs), max(ys)) if xs else (0.0, 0.0, 1.0, 1.0)


def height_of(box: Box, width: int) -> float:
    """The picture's height: proportional to the box, but neither flat nor very high."""
    across, up = _sides(box)
    return min(max(width * up / across, 60.0), 1.4 * width)


def _sides(box: Box) -> tuple[float, float]:
    return max(box[2] - box[0], 1e-9), max(box[3] - box[1], 1e-9)


def picture(
    layers: Sequence[Layer],
    caption: str,
    width: int = 340,
    box: Box | None = None,
    frame: Frame | None = None,
) -> str:
    """One SVG element with all layers in one frame, y upwards. `box` makes several pictures
    comparable. With `frame`, the frame of the coordinates, the picture has axes with numbers
    outside, and a cover hides everything beyond the axes."""
    box = box or bounds(layers)
    xmin, _, _, ymax = box
    across, up = _sides(box)
    height = height_of(box, width)
    left = right = low = PAD
    if frame is not None:
        left, right, low = 2 * PAD + room_of_numbers(box, frame), 2 * PAD, BELOW
        height += low - PAD
    unit = min((width - left - right) / across, (height - PAD - low) / up)
    from_left = left + (width - left - right - unit * across) / 2
    from_top = PAD + (height - PAD - low - unit * up) / 2

    def at(x: float, y: float) -> str:
        return f"{from_left + unit * (x - xmin):.2f} {from_top + unit * (ymax - y):.2f}"

    parts = [_layer(layer, at) for layer in layers if layer.style != "witness"]
    if frame is not None:
        area = (left - PAD, 0.0, width - PAD, height - low + PAD / 2)
        seen = (
            xmin + (area[0] - from_left) / unit, ymax - (area[3] - from_top) / unit,
            xmin + (area[2] - from_left) / unit, ymax - (area[1] - from_top) / unit,
        )  # fmt: skip
        parts.append(_cover(area, width, height))
        parts.append(drawn_axes(area, seen, frame))
    parts += [_layer(layer, at) for layer in layers if layer.style == "witness"]
    return (
        f'<svg viewBox="0 0 {width} {height:.0f}" width="{width}" height="{height:.0f}" role="img" '
        f'aria-label="{escape(escaped(caption), quote=True)}">{"".join(parts)}</svg>'
    )


def _cover(area: Box, width: int, height: float) -> str:
    """A cover over everything outside the area."""
    x0, y0, x1, y1 = area
    inner = f"M{x0:.2f} {y0:.2f}H{x1:.2f}V{y1:.2f}H{x0:.2f}Z"
    return f'<path class="cover" fill-rule="evenodd" d="M0 0H{width}V{height:.0f}H0Z{inner}"/>'


def _layer(layer: Layer, at: Callable[[float, float], str]) -> str:
    style = escape(layer.style, quote=True)
    out = []
    rings = "".join(
        "M" + "L".join(at(x, y) for x, y in ring) + "Z"
        for polygon in layer.polygons
        for ring in polygon
    )
    if rings:
        out.append(f'<path class="{style}" fill-rule="evenodd" d="{rings}"/>')
    lines = "".join(f"M{at(x0, y0)}L{at(x1, y1)}" for x0, y0, x1, y1 in layer.segments)
    if lines:
        out.append(f'<path class="{style}" d="{lines}"/>')
    if layer.point:
        x, y = at(*layer.point).split()
        out.append(f'<circle class="{style}" cx="{x}" cy="{y}" r="4"/>')
    for label in layer.labels:
        across, down = (
            float(n) + m for n, m in zip(at(*label.at).split(), label.move, strict=True)
        )
        out.append(
            f'<text class="{style}" x="{across:.2f}" y="{down:.2f}" text-anchor="{label.anchor}">'
            f"{escape(escaped(label.text))}</text>"
        )
    return "".join(out)
