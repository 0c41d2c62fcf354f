"""A polyhedral set seen along (1, 1, 1), z upwards, with hidden parts removed: each grid point
shows its front face. Runs of points become rectangles with one shade, so that the SVG needs few
paths."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from minkref.fuzz.judges.space.space_planes import PlaneFaces
from minkref.output.terminal import escaped
from minkref.reports.conformance.solid_drawing import Place, projected

SHADES = 6
LIGHT: Place = (0.5, 0.15, 0.85)
PAD = 3
RIM = SHADES  # the shade for points where another face begins

Flat = tuple[float, float]


@dataclass(frozen=True)
class Seen:
    """A face that looks towards the viewer: its projected rings, and the depth `a u + b v + c`,
    larger towards the front."""

    rings: list[list[Flat]]
    depth: tuple[float, float, float]
    shade: int


def solid_view(solid: Sequence[PlaneFaces], style: str, caption: str, width: int = 240) -> str:
    """One SVG element, square. Coordinates are rounded."""
    faces = _faces(solid)
    points = [point for face in faces for ring in face.rings for point in ring]
    us, vs = [u for u, _ in points] or [0.0], [v for _, v in points] or [0.0]
    side = max(max(us) - min(us), max(vs) - min(vs)) or 1.0
    unit = (width - 2 * PAD) / side
    left = (max(us) + min(us) - width / unit) / 2
    top = (max(vs) + min(vs) + width / unit) / 2
    shades = _shades(_front(faces, left, top, unit, width), faces)
    paths = "".join(
        f'<path class="{escape(style, quote=True)} lit{shade}" d="{runs}"/>'
        for shade, runs in sorted(_runs(shades).items())
    )
    return (
        f'<svg viewBox="0 0 {width} {width}" width="{width}" height="{width}" role="img" '
        f'aria-label="{escape(escaped(caption), quote=True)}">{paths}</svg>'
    )


def _faces(solid: Sequence[PlaneFaces]) -> list[Seen]:
    found = []
    for plane in solid:
        normal = plane.normal
        facing = sum(normal)
        if facing <= 0:
            continue
        length = math.hypot(*(float(n) for n in normal))
        lit = sum(float(n) * light for n, light in zip(normal, LIGHT, strict=True))
        share = max(0.0, lit / length / math.hypot(*LIGHT))
        rings = [
            [projected((float(x), float(y), float(z))) for x, y, z in ring] for ring in plane.rings
        ]
        # A point of the picture comes from u e + v f + depth (1, 1, 1) / 3.
        e = (-1 / math.sqrt(3), 1 / math.sqrt(3), 0.0)
        f = (-1 / 3, -1 / 3, 2 / 3)
        slopes = [
            -3 * sum(float(n) * d for n, d in zip(normal, way, strict=True)) / facing
            for way in (e, f)
        ]
        depth = (slopes[0], slopes[1], 3 * float(plane.offset) / facing)
        found.append(Seen(rings, depth, min(SHADES - 1, int(share * SHADES))))
    return found


def _front(
    faces: Sequence[Seen], left: float, top: float, unit: float, width: int
) -> list[list[int]]:
    """The front face's number at each grid point, row by row from the top; -1 for none."""
    numbers = [[-1] * width for _ in range(width)]
    depths = [[-math.inf] * width for _ in range(width)]
    for number, face in enumerate(faces):
        a, b, c = face.depth
        heights = [v for ring in face.rings for _, v in ring]
        first = max(0, math.floor((top - max(heights)) * unit))
        last = min(width - 1, math.ceil((top - min(heights)) * unit))
        for row in range(first, last + 1):
            v = top - (row + 0.5) / unit
            crossings = sorted(_crossings(face.rings, v))
            for start, end in zip(crossings[::2], crossings[1::2], strict=True):
                for column in range(
                    max(0, math.ceil((start - left) * unit - 0.5)),
                    min(width, math.ceil((end - left) * unit - 0.5)),
                ):
                    depth = a * (left + (column + 0.5) / unit) + b * v + c
                    if depth > depths[row][column]:
                        depths[row][column], numbers[row][column] = depth, number
    return numbers


def _crossings(rings: Sequence[Sequence[Flat]], v: float) -> list[float]:
    found = []
    for ring in rings:
        for k, (u1, v1) in enumerate(ring):
            u0, v0 = ring[k - 1]
            if (v0 > v) != (v1 > v):
                found.append(u0 + (u1 - u0) * (v - v0) / (v1 - v0))
    return found


def _shades(numbers: list[list[int]], faces: Sequence[Seen]) -> list[list[int]]:
    """-1 where nothing is seen."""
    width = len(numbers)
    found = []
    for row, here in enumerate(numbers):
        below = numbers[row + 1] if row + 1 < width else here
        shades = []
        for column, number in enumerate(here):
            beside = here[min(column + 1, width - 1)]
            if number != beside or number != below[column]:
                shades.append(RIM)
            else:
                shades.append(faces[number].shade if number >= 0 else -1)
        found.append(shades)
    return found


def _runs(shades: list[list[int]]) -> dict[int, str]:
    """Rectangles for each shade, as path data."""
    found: dict[int, list[str]] = {}
    for row, line in enumerate(shades):
        start = 0
        for column in range(1, len(line) + 1):
            if column < len(line) and line[column] == line[start]:
                continue
            if line[start] >= 0:
                run = f"M{start} {row}h{column - start}v1h{start - column}z"
                found.setdefault(line[start], []).append(run)
            start = column
    return {shade: "".join(runs) for shade, runs in found.items()}
