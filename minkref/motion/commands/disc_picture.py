"""The SVG of a disc on its path, in a container or among obstacles: the largest disc, and what
holds it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref.motion.disc_radii import DiscRadii, DiscRadius
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


@dataclass(frozen=True)
class DrawnDisc:
    """The centres where a disc is drawn, and its radius, rounded."""

    centres: Sequence[Exact]
    radius: Fraction

    def reach(self) -> list[Exact]:
        """The corners of squares about all discs."""
        r = self.radius
        return [(x + a, y + b) for x, y in self.centres for a in (-r, r) for b in (-r, r)]


def disc_path_picture(
    operand: Operand, path: Sequence[tuple[str, str]], found: DiscRadii, told: str
) -> str:
    """An SVG document; `told`: the radii in words. Numbers stay exact until the frame places
    them."""
    way: list[Exact] = [(Fraction(x), Fraction(y)) for x, y in path]
    radius = drawn_radius(found.high)
    contact = found.contact
    discs = [DrawnDisc([contact.at] if contact else [], radius)]
    title = f"a disc on {counted(max(1, len(way) - 1), 'segment')}, radii {told}"
    touching = [contact.touching] if contact else []
    return _picture(operand, title, discs, touching, DrawnDisc(way, radius))


def disc_room_picture(
    operand: Operand, places: Sequence[tuple[str, str]], found: DiscRadii, told: str, verb: str
) -> str:
    """An SVG document of the discs of a fit or a trap: the largest one about each place (without a
    largest the least), and one in each room or neck. `told`: the radii in words; `verb`: what the
    disc does at these radii."""
    at: list[Exact] = [(Fraction(x), Fraction(y)) for x, y in places]
    found_at = [(Fraction(x), Fraction(y)) for x, y in (each.place for each in found.events)]
    high, low = drawn_radius(found.high), drawn_radius(found.low)
    discs = [DrawnDisc(at, high or low), DrawnDisc(found_at, low or high)]
    contact = found.contact
    touching = [contact.touching] if contact else []
    return _picture(operand, f"a disc {verb} at the radii {told}", discs, [*touching, *at])


def _picture(
    operand: Operand,
    title: str,
    discs: Sequence[DrawnDisc],
    marks: Sequence[Exact],
    track: DrawnDisc | None = None,
) -> str:
    shape = exact_polygons(operand.set)
    swept = [track] if track else []
    reach = [each.reach() for each in (*discs, *swept) if each.centres]
    box = box_of([*shape, *([ring] for ring in reach)])
    title = f"{short_name(operand.name)}: {title}"
    if box is None:
        return side_by_side([([title, "the empty set"], "")], STYLE, WIDTH, 0)
    frame = Frame(box[0], box[1], fitted(box, WIDTH, WIDTH).factor)
    layers, way = [], []
    for each in swept:
        drawn, far = frame.ring(each.centres), float(each.radius * frame.factor)
        legs = list(zip(drawn, drawn[1:] or drawn, strict=False))
        layers += [Layer("track", [[_stadium(a, b, far)]]) for a, b in legs] if far else []
        way.append(Layer("way", segments=[(*a, *b) for a, b in legs]))
    layers += [Layer("obstacle", frame.polygons(shape)), *way]
    for each in discs:
        far = float(each.radius * frame.factor)
        if far:
            layers += [
                Layer("disc", [[_stadium(centre, centre, far)]])
                for centre in frame.ring(each.centres)
            ]
    layers += [Layer("touch", point=point) for point in frame.ring(marks)]
    height = round(height_of(bounds(layers), WIDTH))
    caption = [title, box_text(box)]
    return side_by_side([(caption, picture(layers, title, WIDTH))], STYLE, WIDTH, height)


def drawn_radius(radius: DiscRadius | None) -> Fraction:
    """A radius, rounded; 0 for none."""
    if radius is None or not math.isfinite(radius.bounds[0]):
        return Fraction(0)
    return Fraction(max(radius.bounds[0], 0.0))


def _stadium(a: tuple[float, float], b: tuple[float, float], radius: float) -> Ring:
    """Points with one distance from a segment, counter-clockwise."""
    start = math.atan2(b[1] - a[1], b[0] - a[0])

    def half(centre: tuple[float, float], first: float) -> Iterator[tuple[float, float]]:
        for k in range(CORNERS + 1):
            angle = first + math.pi * k / CORNERS
            yield centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)

    return [*half(b, start - math.pi / 2), *half(a, start + math.pi / 2)]
