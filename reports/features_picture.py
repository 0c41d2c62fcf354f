"""The SVG of features: a set with its leaves and bridges, and the barcode beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from minkref import _core
from minkref.disc.features import FeatureBar, Features, LiveFeature
from minkref.output.terminal import escaped
from minkref.reports.region_layers import REGION_STYLE, DrawnRegions

WIDTH = 680.0  # of the set's longer side
PAD = 12.0
BARS = 340.0  # width of the barcode
MOST = 400  # bars that are drawn, the longest ones
STYLE = (
    "path{stroke-width:1.2;stroke-linejoin:round;fill-rule:evenodd}"
    ".set{fill:#9cc3e6;stroke:#1f5f99}.bridge{stroke:#c9362b;stroke-width:1.6}"
    ".leaf{fill:#2a6e30}.deepest{fill:#c9362b}.bar{stroke:#1f5f99}.live{stroke:#c9362b}"
    ".essential{stroke:#2a6e30}.alpha{stroke:#888;stroke-dasharray:4 3}"
)


def features_picture(
    P: _core.PolygonSet,
    found: Features,
    alive: Sequence[LiveFeature] | None,
    caption: str,
    drawn: DrawnRegions | None = None,
) -> str:
    """An SVG document. Without features `alive` at one alpha: all leaves, and no bridge. `drawn`:
    regions and rest material, where they are asked for."""
    rings = [ring for polygon in P.approximate_rings() for ring in polygon]
    points = [point for ring in rings for point in ring] or [(0.0, 0.0)]
    xs, ys = zip(*points, strict=True)
    unit = (WIDTH - 2 * PAD) / (max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0)
    low_x, high_y = min(xs), max(ys)
    width, height = unit * (max(xs) - low_x) + 2 * PAD, unit * (high_y - min(ys)) + 2 * PAD

    def at(x: float, y: float) -> tuple[str, str]:
        return f"{PAD + unit * (x - low_x):.3f}", f"{PAD + unit * (high_y - y):.3f}"

    path = "".join("M" + "L".join(" ".join(at(x, y)) for x, y in ring) + "Z" for ring in rings)
    layers = [f'<path class="set" d="{path}"/>']
    if drawn is not None:
        layers += drawn.layers(at, unit)
    deepest = {feature.deepest for feature in alive or []}
    for node in found.tree:
        if node.vertex is not None:
            x, y = at(*map(float, node.vertex))
            kind, r = ("deepest", 3.5) if node.number in deepest else ("leaf", 2)
            layers.append(f'<circle class="{kind}" cx="{x}" cy="{y}" r="{r}"/>')
    for feature in alive or []:
        for bridge in feature.bridges:
            (x, y), (z, w) = (at(*end) for end in bridge.near)
            layers.append(f'<line class="bridge" x1="{x}" y1="{y}" x2="{z}" y2="{w}"/>')
    bars = _barcode(found.bars, {feature.bar for feature in alive or []}, width + PAD, height)
    full = width + BARS + 2 * PAD
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {full:.0f} {height:.0f}" '
        f'width="{full:.0f}" height="{height:.0f}" role="img" '
        f'aria-label="features of {escape(escaped(caption), quote=True)}">'
        f"<style>{STYLE}{REGION_STYLE}</style>{''.join(layers)}{bars}</svg>\n"
    )


def _barcode(bars: Sequence[FeatureBar], live: set[int], left: float, height: float) -> str:
    """The longest bars, by birth, then by death. A bar without an end reaches the margin."""
    order = sorted(range(len(bars)), key=lambda k: -bars[k].persistence[0])[:MOST]
    order.sort(key=lambda k: (bars[k].birth[0], bars[k].death[0]))
    ends = [x for k in order for x in (bars[k].birth[0], bars[k].death[0]) if math.isfinite(x)]
    unit = BARS / (1.1 * max(ends, default=1.0) or 1.0)
    step = (height - 2 * PAD) / max(len(order), 1)
    lines = []
    for number, k in enumerate(order):
        bar = bars[k]
        y = PAD + step * (number + 0.5)
        first, last = unit * bar.birth[0], min(unit * bar.death[0], BARS)
        kind = "live" if k in live else "essential" if bar.essential else "bar"
        lines.append(
            f'<line class="{kind}" x1="{left + first:.3f}" y1="{y:.3f}" x2="{left + last:.3f}" '
            f'y2="{y:.3f}" stroke-width="{min(step * 0.6, 4):.2f}"/>'
        )
    return "".join(lines)
