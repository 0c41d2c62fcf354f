"""Axes of a picture in space: three edges of the box around the solids, with numbers."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.reports.axes import axis
from minkref.reports.conformance.solid_drawing import place_of, projected
from minkref.reports.drawing import Box, Label, Layer, bounds

NUMBERS = 4  # on an axis, at the most
TICK = 0.02  # of the longest side
ROOM = 0.17  # the same, for the numbers

Spot = tuple[Fraction, Fraction, Fraction]


def axes_around(solids: Iterable[Polyhedron], points: Iterable[Spot] = ()) -> list[Layer]:
    """Axes x and y along the picture's foot, z along its left; none if a number exceeds the
    doubles."""
    corners = [corner for solid in solids if solid.vertices for corner in solid.box]
    corners += points
    if not corners:
        return []
    low, high = ([end(c[k] for c in corners) for k in range(3)] for end in (min, max))
    if place_of(tuple(map(str, low))) is None or place_of(tuple(map(str, high))) is None:
        return []
    outward = float(max(b - a for a, b in zip(low, high, strict=True))) * TICK
    # Axis k starts at a corner with low coordinate k, and has numbers on the same side of its edge.
    layers = [
        _one("x", 0, (low[0], high[1], low[2]), high[0], (outward, -outward / 2), "start"),
        _one("y", 1, (high[0], low[1], low[2]), high[1], (-outward, -outward / 2), "end"),
        _one("z", 2, (high[0], low[1], low[2]), high[2], (-outward, 0.0), "end"),
    ]
    return layers


def with_room(box: Box) -> Box:
    """The box and room for the numbers around it."""
    room = ROOM * max(box[2] - box[0], box[3] - box[1])
    return (box[0] - room, box[1] - room / 2, box[2] + room, box[3] + room / 4)


def box_around(layers: Iterable[Layer]) -> Box:
    return with_room(bounds(layers))


def _one(
    name: str, k: int, start: Spot, end: Fraction, outward: tuple[float, float], anchor: str
) -> Layer:
    def place(value: Fraction) -> tuple[float, float]:
        x, y, z = (float(value if j == k else start[j]) for j in range(3))
        return projected((x, y, z))

    if start[k] == end:
        return Layer("axis")
    found = axis(start[k], end, NUMBERS)
    segments = [(*place(start[k]), *place(end))]
    labels = []
    for value, text in found.ticks:
        x, y = place(value)
        tip = (x + outward[0], y + outward[1])
        segments.append((x, y, *tip))
        if value == found.ticks[-1][0]:
            text = f"{name} {found.base} + {text}" if found.base else f"{name} {text}"
        corner = 4.0 if value == start[k] else 0.0  # where two axes meet
        down = 4.0 - 2 * corner if k == 2 else 9.0 + corner
        labels.append(Label(tip, text, anchor, (-3.0 if anchor == "end" else 3.0, down)))
    return Layer("axis", segments=segments, labels=labels)
