"""Counterexamples about robots and discs drawn; coordinates are rounded."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.plane import cross, dot
from minkref.fuzz.judges.disc.paper_disc import Corner, Vertex
from minkref.reports.audit.disc import along, corner, sides
from minkref.reports.audit.plane import Place, rings_of
from minkref.reports.drawing import Box, Layer, Segment, picture

STEP = 0.06  # radians along an arc
Disc = tuple[float, float, float]  # centre, radius


def robot_on_path(
    robot: _core.PolygonSet, obstacle: _core.PolygonSet, path: Sequence[Place], s: Fraction
) -> str:
    """The obstacle, the robot at both ends of its path, and the reference point's way."""
    polygons = [
        [[(float(s * x + u), float(s * y + v)) for x, y in ring] for ring in rings_of(robot)]
        for u, v in dict.fromkeys((path[0], path[-1]))
    ]
    steps = [(float(a[0]), float(a[1]), float(b[0]), float(b[1])) for a, b in pairwise(path)]
    layers = [
        Layer("second", obstacle.approximate_rings()),
        Layer("first clear", polygons),
        Layer("first-edge", segments=steps),
        Layer("witness", point=(float(path[0][0]), float(path[0][1]))),
    ]
    return picture(layers, f"a robot of scale {s} and an obstacle", 260)


def swept(
    ring: Sequence[Vertex],
    radii: Iterable[float],
    discs: Sequence[Disc] = (),
    box: Box | None = None,
) -> str:
    """A polygon, its offset edges and arcs at some radii, and discs with their centres."""
    curves = [curve for radius in radii for curve in offset_curves(ring, radius)]
    around = [segment for x, y, r in discs for segment in arc((x, y), r, 0, 2 * math.pi)]
    layers = [
        Layer("second", [[[(float(x), float(y)) for x, y in ring]]]),
        Layer("first-edge", segments=curves),
        Layer("second-edge", segments=around),
        *(Layer("witness", point=(x, y)) for x, y, _ in discs),
    ]
    return picture(layers, "a disc swept along a polygon", 320, box)


def arcs_at(corners: Sequence[Corner], radii: Iterable[float], marks: Sequence[Place]) -> str:
    """The arcs about vertices at some radii, and marked places."""
    styles = ("first-edge", "second-edge")
    drawn = [[x for r in radii for x in _corner_arc(c, r)] for c in corners]
    layers = [Layer(styles[i % 2], segments=x) for i, x in enumerate(drawn)]
    layers += [Layer("witness", point=(float(x), float(y))) for x, y in marks]
    return picture(layers, "two arcs at several radii", 320)


def offset_curves(ring: Sequence[Vertex], radius: float) -> list[Segment]:
    """Offset edges, and arcs about the vertices at which the polygon turns left."""
    found = []
    for (x0, y0), (x1, y1) in sides(ring):
        length = math.hypot(x1 - x0, y1 - y0)
        u, v = radius * (y1 - y0) / length, -radius * (x1 - x0) / length
        found.append((x0 + u, y0 + v, x1 + u, y1 + v))
    for k in range(len(ring)):
        found += _corner_arc(corner(ring, k), radius)
    return found


def _corner_arc(about: Corner, radius: float) -> list[Segment]:
    before, after = along(about[:2]), along(about[1:])
    turn = math.atan2(cross(before, after), dot(before, after))
    start = math.atan2(-before[0], before[1])
    return arc(about[1], radius, start, start + turn) if turn > 0 else []


def arc(centre: tuple[float, float], radius: float, start: float, end: float) -> list[Segment]:
    steps = max(2, math.ceil((end - start) / STEP))
    angles = [start + (end - start) * i / steps for i in range(steps + 1)]
    places = [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]
    return [(*a, *b) for a, b in pairwise(places)]
