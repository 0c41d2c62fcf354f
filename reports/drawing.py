"""Pictures of polygon sets and segments as SVG, for looking at: coordinates are rounded."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from html import escape

from minkref.terminal import shown

Segment = tuple[float, float, float, float]
Polygons = Sequence[Sequence[Sequence[tuple[float, float]]]]  # per polygon: outer ring, holes
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Layer:
    """Rings, segments or a marked point, drawn in the style of a class of the page."""

    style: str
    polygons: Polygons = ()
    segments: Sequence[Segment] = ()
    point: tuple[float, float] | None = None


def bounds(layers: Iterable[Layer]) -> Box:
    """The box around all layers; a unit square where there is nothing."""
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
    """The height of a picture of the box: as its sides are, but neither flat nor very high."""
    across, up = _sides(box)
    return min(max(width * up / across, 60.0), 1.4 * width)


def _sides(box: Box) -> tuple[float, float]:
    return max(box[2] - box[0], 1e-9), max(box[3] - box[1], 1e-9)


def picture(layers: Sequence[Layer], caption: str, width: int = 340, box: Box | None = None) -> str:
    """One SVG element, y upwards, all layers in one frame. `box` makes several pictures
    comparable."""
    box = box or bounds(layers)
    xmin, _, _, ymax = box
    across, up = _sides(box)
    height = height_of(box, width)
    pad = 8.0
    unit = min((width - 2 * pad) / across, (height - 2 * pad) / up)
    left, top = (width - unit * across) / 2, (height - unit * up) / 2

    def at(x: float, y: float) -> str:
        return f"{left + unit * (x - xmin):.2f} {top + unit * (ymax - y):.2f}"

    parts = [_layer(layer, at) for layer in layers]
    return (
        f'<svg viewBox="0 0 {width} {height:.0f}" width="{width}" height="{height:.0f}" role="img" '
        f'aria-label="{escape(shown(caption), quote=True)}">{"".join(parts)}</svg>'
    )


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
    return "".join(out)
