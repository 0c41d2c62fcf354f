"""An independent reader of the page's data, written from docs/command-line.md alone."""

from __future__ import annotations

import json
import math
import os
import random
import re
from pathlib import Path
from typing import Any

from minkref.cli.cli import run
from minkref.reports.evidence.pages.view import Polygons

Point = tuple[float, float]
MADE: dict[tuple[str, ...], str] = {}  # pages of models and texts, which tests share


def data_of(page: str) -> dict[str, Any]:
    """The data inside a page's text."""
    found = re.search(r'<script id="data" type="application/json">(.*?)</script>', page, re.S)
    assert found
    value: dict[str, Any] = json.loads(found[1])
    return value


class Decoder:
    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data

    def rings(self, state: int) -> dict[int, tuple[bool, int, int, list[int]]]:
        """Rings by slot: whether the ring bounds a hole, component, hole, vertices as tracks."""
        rings: dict[int, tuple[bool, int, int, list[int]]] = {}
        for change in self.data["states"][: state + 1]:
            if not change:
                continue
            for slot in change[0]:
                del rings[slot]
            for slot, is_hole, component, hole, *splices in change[1:]:
                vertices = list(rings[slot][3]) if slot in rings else []
                for at, removed, *added in splices:
                    assert at + removed <= len(vertices)
                    vertices = vertices[:at] + added + vertices[at + removed :]
                rings[slot] = (bool(is_hole), component, hole, vertices)
        return rings

    def state_at(self, scale: float) -> int:
        return sum(about <= scale for about in self.data["about"])

    def point(self, track: int, scale: float) -> Point:
        def coordinate(axis: int) -> float:
            r, m = self.data["tracks"][4 * track + 2 * axis : 4 * track + 2 * axis + 2]
            centre: float = self.data["centres"].get(str(2 * track + axis), 0.0)
            value: float = r + m * (scale - centre)
            return value

        return coordinate(0), coordinate(1)

    def polygons(self, scale: float) -> Polygons:
        """The sum, canonically ordered."""
        outer: dict[int, list[Point]] = {}
        holes: dict[int, list[list[Point]]] = {}
        for is_hole, component, _, vertices in self.rings(self.state_at(scale)).values():
            points = [self.point(track, scale) for track in vertices]
            least = points.index(min(points))
            ring = points[least:] + points[:least]
            if is_hole:
                holes.setdefault(component, []).append(ring)
            else:
                assert component not in outer
                outer[component] = ring
        return sorted([ring, *sorted(holes.get(c, []))] for c, ring in outer.items())


def scales(count: int, seed: int, first: float = 0.1, last: float = 10.0) -> list[float]:
    """Spread evenly over the logarithm of the scale."""
    dice = random.Random(seed)
    low, high = math.log(first), math.log(last)
    return [min(max(math.exp(dice.uniform(low, high)), first), last) for _ in range(count)]


def page_of(folder: Path, *words: str) -> Path:
    """The page that the command writes for operands and options."""
    path = folder / "view.html"
    if words in MADE:
        path.write_text(MADE[words], encoding="utf-8")
        return path
    assert run(["view", *words, "-o", str(path)]) == 0
    if not any(map(os.path.exists, words)):  # files may change
        MADE[words] = path.read_text(encoding="utf-8")
    return path
