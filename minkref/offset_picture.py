"""The SVG of a sum with a disc: true arcs, with the operand inside."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from html import escape
from typing import Any

from minkref import _core
from minkref.output.terminal import counted, escaped

WIDTH = 680.0
PAD = 12.0
STYLE = (
    "path{stroke-width:1.2;stroke-linejoin:round;fill-rule:evenodd}"
    ".sum{fill:#b9dcbb;stroke:#2a6e30}.first{fill:#9cc3e6;stroke:#1f5f99}"
    ".tight{fill:none;stroke:#c9362b;stroke-width:2}"
)
Piece = tuple[str, float, float, float, float, float, float, float]


def offset_picture(
    offset: _core.Offset,
    operand: _core.PolygonSet | None,
    caption: str,
    passages: Sequence[Sequence[tuple[float, float]]] = (),
    beneath: bool = False,
) -> str:
    """An SVG document: the region, bounded by segments and arcs, with the `operand` and the tight
    `passages` on top. `beneath`: the region is an inset, with the operand under it. The longer side
    of the box measures WIDTH - 2 PAD; coordinates are rounded to a thousandth of a picture unit.
    The region may have any size, near the origin or far away."""
    origin, factor, radius = offset.drawing_frame()
    components = offset.drawn_rings(origin, factor)
    drawn = [piece for rings in components for ring in rings for piece in ring]
    own = _placed(operand, origin, factor)
    box = _box_of_points(own) if beneath and own else _box(drawn, radius)
    unit = (WIDTH - 2 * PAD) / max(box[2] - box[0], box[3] - box[1], 1e-300)
    width, height = (2 * PAD + unit * (box[k + 2] - box[k]) for k in (0, 1))

    def at(x: float, y: float) -> str:
        return f"{PAD + unit * (x - box[0]):.3f} {PAD + unit * (box[3] - y):.3f}"

    def ring_path(ring: Sequence[Piece]) -> str:
        parts = [f"M{at(ring[0][1], ring[0][2])}"]
        for kind, _, _, x, y, *_ in ring:
            # Arcs run counter-clockwise, and y points upwards.
            arc = f"A{unit * radius:.3f} {unit * radius:.3f} 0 0 0 " if kind == "arc" else "L"
            parts.append(arc + at(x, y))
        return "".join(parts) + "Z"

    paths = "".join(ring_path(ring) for rings in components for ring in rings)
    layers = [f'<path class="sum" d="{paths}"/>']
    if own:
        text = "".join("M" + "L".join(at(x, y) for x, y in ring) + "Z" for ring in own)
        layers.insert(0 if beneath else 1, f'<path class="first" d="{text}"/>')
    for points in passages:
        places = [at(*_in_frame(point, origin, factor)) for point in points]
        x, y = places[0].split()
        layers.append(
            f'<path class="tight" d="M{"L".join(places)}"/>'
            if len(points) > 1
            else f'<circle class="tight" cx="{x}" cy="{y}" r="4"/>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
        f'width="{width:.0f}" height="{height:.0f}" role="img" '
        f'aria-label="{escape(escaped(caption), quote=True)}"><style>{STYLE}</style>'
        f"{''.join(layers)}</svg>\n"
    )


def _placed(
    operand: _core.PolygonSet | None, origin: Sequence[str], factor: str
) -> list[list[tuple[float, float]]]:
    """The rings of the operand in the drawing's frame."""
    if operand is None:
        return []
    x, y = (str(-Fraction(value)) for value in origin)
    near = operand.translated(x, y).scaled(factor)
    return [ring for polygon in near.approximate_rings() for ring in polygon]


def _box_of_points(rings: list[list[tuple[float, float]]]) -> tuple[float, float, float, float]:
    xs, ys = ([point[k] for ring in rings for point in ring] for k in (0, 1))
    return min(xs), min(ys), max(xs), max(ys)


def _in_frame(
    point: tuple[float, float], origin: Sequence[str], factor: str
) -> tuple[float, float]:
    """A point's coordinates in the drawing's frame."""
    x, y = (
        float((Fraction(value) - Fraction(start)) * Fraction(factor))
        for value, start in zip(point, origin, strict=True)
    )
    return x, y


def _box(pieces: Sequence[Piece], radius: float) -> tuple[float, float, float, float]:
    """The box around all pieces; arcs count as far as they reach on their circles."""
    if not pieces:
        return 0.0, 0.0, 1.0, 1.0
    xs = [x for piece in pieces for x in (piece[1], piece[3])]
    ys = [y for piece in pieces for y in (piece[2], piece[4])]
    for kind, x0, y0, x1, y1, cx, cy, _ in pieces:
        if kind != "arc":
            continue
        # An arc below half a turn has an extreme point if its ends lie on different sides.
        if (y0 - cy) * (y1 - cy) < 0:
            xs.append(cx + (radius if x0 + x1 > 2 * cx else -radius))
        if (x0 - cx) * (x1 - cx) < 0:
            ys.append(cy + (radius if y0 + y1 > 2 * cy else -radius))
    return min(xs), min(ys), max(xs), max(ys)


def show_values() -> None:
    """Give offsets their pictures in a notebook."""
    owner: Any = _core.Offset
    owner._repr_svg_ = _picture_of_offset


def _picture_of_offset(value: _core.Offset) -> str:
    passages = [points for _, points, _ in value.tight_passages()]
    counts = f"{counted(value.components, 'component')}, {counted(value.holes, 'hole')}"
    return offset_picture(value, None, f"with a disc: {counts}", passages)
