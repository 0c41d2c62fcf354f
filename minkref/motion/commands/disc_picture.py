"""The SVG of a disc's path: obstacles, the largest disc's track, and its first contact."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from minkref.motion.disc_radii import DiscRadii
from minkref.output.terminal import counted
from minkref.plane.exact_frame import Exact, Frame, Ring, box_of, box_text, exact_polygons, fitted
from minkref.plane.operand import Operand
from minkref.reports.drawing import Layer, bounds, height_of, picture
from minkref.reports.side_by_side import side_by_side
from minkref.reports.sum_picture import short_name

WIDTH = 900
CORNERS = 48  # drawn, of half a disc
STYLE = (
    ".track{fill:#d4ead5;stroke:none}.obstacle{fill:#d9d9d9;stroke:#333}"
    ".way{fill:none;stroke:#2c6fbb;stroke-width:1.5}.disc{fill:none;stroke:#2e7d32;stroke-width:1.5}"
    ".touch{fill:#c9362b;stroke:none}path{stroke-width:1;stroke-linejoin:round}"
    "text{font:13px sans-serif;fill:#333}"
)


def disc_path_picture(
    operand: Operand, path: Sequence[tuple[str, str]], found: DiscRadii, told: str
) -> str:
    """An SVG document; `told`: the radii in words. Numbers stay exact until the frame places
    them."""
    shape = exact_polygons(operand.set)
    way: list[Exact] = [(Fraction(x), Fraction(y)) for x, y in path]
    radius = _drawn_radius(found)
    reach = [
        (x + dx, y + dy) for x, y in way for dx in (-radius, radius) for dy in (-radius, radius)
    ]
    box = box_of([*shape, [[*way, *reach]]])
    assert box is not None
    frame = Frame(box[0], box[1], fitted(box, WIDTH, WIDTH).factor)
    drawn, far = frame.ring(way), float(radius * frame.factor)
    legs = list(zip(drawn, drawn[1:] or drawn, strict=False))
    layers = [Layer("track", [[_stadium(a, b, far)]]) for a, b in legs] if radius else []
    layers += [
        Layer("obstacle", frame.polygons(shape)),
        Layer("way", segments=[(*a, *b) for a, b in legs]),
    ]
    if found.contact is not None:
        (centre, touching) = frame.ring([found.contact.at, found.contact.touching])
        if radius:
            layers.append(Layer("disc", [[_stadium(centre, centre, far)]]))
        layers.append(Layer("touch", point=touching))
    title = f"{short_name(operand.name)}: a disc on {counted(len(legs), 'segment')}, radii {told}"
    caption = [title, box_text(box)]
    height = round(height_of(bounds(layers), WIDTH))
    return side_by_side([(caption, picture(layers, title, WIDTH))], STYLE, WIDTH, height)


def _drawn_radius(found: DiscRadii) -> Fraction:
    """The largest radius, rounded; 0 without one."""
    if found.high is None or not math.isfinite(found.high.bounds[0]):
        return Fraction(0)
    return Fraction(max(found.high.bounds[0], 0.0))


def _stadium(a: tuple[float, float], b: tuple[float, float], radius: float) -> Ring:
    """Points with one distance from a segment, counter-clockwise."""
    start = math.atan2(b[1] - a[1], b[0] - a[0])

    def half(centre: tuple[float, float], first: float) -> Iterator[tuple[float, float]]:
        for k in range(CORNERS + 1):
            angle = first + math.pi * k / CORNERS
            yield centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)

    return [*half(b, start - math.pi / 2), *half(a, start + math.pi / 2)]
