"""The diagram of a path as a picture: places across, scales upwards, bad polygons filled."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BELOW = 58, 14, 12, 34
MOST_CORNERS = 300  # of the path that have a line
STYLE = (
    "text{font:11px system-ui,'DejaVu Sans',sans-serif;fill:#5d6978}"
    ".bad{fill:#e7b3ab;stroke:#a8433a;stroke-width:.4}.frame{fill:none;stroke:#8d99a8}"
    ".corner{stroke:#d6dce3;stroke-dasharray:2 3}.band{fill:#2c8a3d;fill-opacity:.1}"
    ".range{fill:#2c8a3d}.alone{stroke:#2c8a3d;stroke-width:1.6}"
    ".held.band{fill:#c98a1b;fill-opacity:.16}.held.range{fill:#c98a1b}"
    ".held.alone{stroke:#c98a1b}"
    ".bound{fill:#fff;stroke:#c9362b;stroke-width:1.8}"
)


def diagram_svg(data: dict[str, Any]) -> str:
    """`data` is what `picture` or `held_picture` gives. Coordinates are rounded."""
    return _Diagram(data).svg()


class _Diagram:
    def __init__(self, data: dict[str, Any]) -> None:
        self._data = data
        self._first, self._last = (float(about) for _, about in data["window"])
        numbers = data["path"]
        corners = list(zip(numbers[::2], numbers[1::2], strict=True))
        self._reached = [0.0]
        farthest = max(map(abs, numbers)) or 1.0  # no length overflows
        for a, b in pairwise(corners):
            step = math.dist([x / farthest for x in a], [x / farthest for x in b])
            self._reached.append(self._reached[-1] + step)

    def svg(self) -> str:
        left, right, low = LEFT, WIDTH - RIGHT, self._y(self._first)
        drawn = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'width="{WIDTH}" height="{HEIGHT}" role="img" aria-label="Places and scales at which '
            f'the part collides"><style>{STYLE}</style>'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
            *self._ranges(left, right),
            *self._polygons(left, right),
            *self._axes(left, low),
            f'<rect class="frame" x="{left}" y="{TOP}" width="{right - left}" '
            f'height="{low - TOP:.2f}"/>',
            *self._bounds(),
        ]
        return "\n".join(drawn) + "\n</svg>\n"

    @property
    def _is_one_place(self) -> bool:
        return not self._reached[-1] > 0

    def _x(self, segment: int, t: float) -> float:
        width = WIDTH - LEFT - RIGHT
        if self._is_one_place:
            return LEFT + width / 2
        start, end = self._reached[segment : segment + 2]
        return LEFT + width * (start + t * (end - start)) / self._reached[-1]

    def _y(self, scale: float) -> float:
        share = (scale - self._first) / (self._last - self._first)
        return HEIGHT - BELOW - share * (HEIGHT - TOP - BELOW)

    def _polygons(self, left: float, right: float) -> list[str]:
        drawn = []
        for segment, _, _, *numbers in self._data["polygons"]:
            corners = list(zip(numbers[::2], numbers[1::2], strict=True))
            if self._is_one_place:
                scales = [s for _, s in corners]
                y, end = self._y(max(scales)), self._y(min(scales))
                places = [(left, y), (right, y), (right, end), (left, end)]
            elif self._reached[segment + 1] > self._reached[segment]:
                places = [(self._x(segment, t), self._y(s)) for t, s in corners]
            else:
                continue
            drawn.append(f'<path class="bad" d="{_outline(places)}"/>')
        return drawn

    def _ranges(self, left: float, right: float) -> list[str]:
        drawn = self._bars(self._data["valid"], "", left, right)
        return [*self._bars(self._data.get("held", ()), "held ", left, right), *drawn]

    def _bars(self, ranges: Any, kind: str, left: float, right: float) -> list[str]:
        """A bar beside the axis and a band across for each range, a line for a single scale."""
        drawn = []
        for one in ranges:
            low, high = one["about"]
            high = self._last if high is None else min(high, self._last)
            if low > self._last or high < self._first:
                continue
            y, end = self._y(high), self._y(max(low, self._first))
            if one["from"] == one["to"]:
                drawn.append(
                    f'<line class="{kind}alone" x1="{left - 8}" x2="{right}" y1="{y:.2f}" '
                    f'y2="{y:.2f}"/>'
                )
                continue
            for name, x, width in (("band", left, right - left), ("range", left - 6, 4)):
                drawn.append(
                    f'<rect class="{kind}{name}" x="{x}" y="{y:.2f}" width="{width}" '
                    f'height="{end - y:.2f}"/>'
                )
        return drawn

    def _axes(self, left: float, low: float) -> list[str]:
        drawn = [_text(left - 10, self._y(s) + 4, f"{s:g}", "end") for s in self._round_scales()]
        if self._is_one_place:
            return [*drawn, _text(self._x(0, 0), low + 16, "one place", "middle")]
        taken = -math.inf
        for k in range(len(self._reached)):
            x = self._x(min(k, len(self._reached) - 2), float(k == len(self._reached) - 1))
            if len(self._reached) <= MOST_CORNERS:
                drawn.append(
                    f'<line class="corner" x1="{x:.2f}" x2="{x:.2f}" y1="{TOP}" y2="{low:.2f}"/>'
                )
            if x >= taken:
                drawn.append(_text(x, low + 16, str(k), "middle"))
                taken = x + 7 * len(str(k)) + 10
        return drawn

    def _round_scales(self) -> list[float]:
        length = self._last - self._first
        unit = 10 ** math.floor(math.log10(length / 4))
        step = next(n * unit for n in (1, 2, 5, 10) if length / (n * unit) <= 8)
        start = math.ceil(self._first / step)
        return [k * step for k in range(start, math.floor(self._last / step * (1 + 1e-12)) + 1)]

    def _bounds(self) -> list[str]:
        drawn = []
        for bound in self._data["bounds"]:
            scale = bound["about"]["scale"]
            if self._first <= scale <= self._last:
                x = self._x(bound["at"]["segment"], bound["about"]["t"])
                drawn.append(
                    f'<circle class="bound" cx="{x:.2f}" cy="{self._y(scale):.2f}" r="4">'
                    f"<title>{bound['scale']} {bound['event']}</title></circle>"
                )
        return drawn


def _outline(places: Sequence[tuple[float, float]]) -> str:
    return "M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in places) + "Z"


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}">{text}</text>'
