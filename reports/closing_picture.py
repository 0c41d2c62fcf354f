"""The SVG of a closing or an opening by a disc: true arcs, with the operand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from minkref import _core
from minkref.disc.closed import Step
from minkref.offset_picture import PAD, STYLE, WIDTH
from minkref.output.terminal import escaped


def closing_picture(
    rings: Sequence[Sequence[Step]], operand: _core.PolygonSet | None, caption: str
) -> str:
    """An SVG document: the region with the `operand`'s outline on top. The longer side of the box
    measures WIDTH - 2 PAD; coordinates are rounded to a thousandth of a picture unit."""
    own = [] if operand is None else [r for polygon in operand.approximate_rings() for r in polygon]
    points = [(x, y) for ring in own for x, y in ring] or [(0.0, 0.0)]
    points += [(x, y) for ring in rings for _, *ends in ring for x, y in (ends[:2], ends[2:4])]
    xs, ys = ([point[k] for point in points] for k in (0, 1))
    unit = (WIDTH - 2 * PAD) / max(max(xs) - min(xs), max(ys) - min(ys), 1e-300)
    width, height = (2 * PAD + unit * (max(each) - min(each)) for each in (xs, ys))

    def at(x: float, y: float) -> str:
        return f"{PAD + unit * (x - min(xs)):.3f} {PAD + unit * (max(ys) - y):.3f}"

    def path(ring: Sequence[Step]) -> str:
        parts = [f"M{at(ring[0][1], ring[0][2])}"]
        for kind, x0, y0, x1, y1, cx, cy in ring:
            radius = unit * math.hypot(x0 - cx, y0 - cy)
            arc = f"A{radius:.3f} {radius:.3f} 0 0 0 " if kind == "arc" else "L"
            parts.append(arc + at(x1, y1))
        return "".join(parts) + "Z"

    region = "".join(path(ring) for ring in rings if ring)
    layers = [f'<path class="sum" d="{region}"/>'] if region else []
    if own:
        text = "".join("M" + "L".join(at(x, y) for x, y in ring) + "Z" for ring in own)
        layers.append(f'<path class="first" style="fill:none" d="{text}"/>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
        f'width="{width:.0f}" height="{height:.0f}" role="img" '
        f'aria-label="{escape(escaped(caption), quote=True)}"><style>{STYLE}</style>'
        f"{''.join(layers)}</svg>\n"
    )
