"""Features' regions and rest material as paths of an SVG."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from minkref.disc.feature_regions import RegionsAt, Step

COLOURS = ("#f2b134", "#7bb662", "#c77dba", "#5fb7b5", "#e07a5f", "#8d99ae")
"""Regions take turns; neighbours in the list seldom touch."""
REGION_STYLE = (
    ".region{stroke:none;fill-opacity:.45}.rest{fill:#7a3b2e;fill-opacity:.6;stroke:none}"
)

At = Callable[[float, float], tuple[str, str]]


class DrawnRegions(NamedTuple):
    """All regions at one alpha, and what a picture shows."""

    found: RegionsAt
    regions: bool
    rest: bool

    def layers(self, at: At, unit: float) -> list[str]:
        """Paths; `at` places a point in the picture, y downwards, and `unit` is the length of 1."""
        regions = region_layers(self.found, at) if self.regions else []
        return regions + (rest_layers(self.found, at, unit) if self.rest else [])


def region_layers(found: RegionsAt, at: At) -> list[str]:
    """A path for each region with an area."""
    layers = []
    for number, feature in enumerate(found.features):
        if feature.area[1] > 0:
            path = path_of(found.outlines(number), at, 0)
            colour = COLOURS[number % len(COLOURS)]
            layers.append(f'<path class="region" fill="{colour}" d="{path}"/>')
    return layers


def rest_layers(found: RegionsAt, at: At, unit: float) -> list[str]:
    """A path for the rest material of each feature."""
    return [
        f'<path class="rest" d="{path_of(found.rest_outlines(number), at, unit)}"/>'
        for number, rest in enumerate(found.rest)
        if rest.components > 0
    ]


def path_of(rings: Iterable[list[Step]], at: At, unit: float) -> str:
    """Rings of lines and arcs. An arc is less than half a turn, and runs counter-clockwise."""
    parts = []
    for ring in rings:
        for number, (kind, x0, y0, x1, y1, cx, cy) in enumerate(ring):
            if number == 0:
                parts.append("M" + " ".join(at(x0, y0)))
            if kind == "line":
                parts.append("L" + " ".join(at(x1, y1)))
                continue
            radius = unit * ((x0 - cx) ** 2 + (y0 - cy) ** 2) ** 0.5
            parts.append(f"A{radius:.3f} {radius:.3f} 0 0 0 " + " ".join(at(x1, y1)))
        parts.append("Z")
    return "".join(parts)
