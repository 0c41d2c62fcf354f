"""A small picture of sets as SVG, for values in a notebook."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from html import escape
from typing import Any

from minkref import _core
from minkref.output.terminal import counted, escaped
from minkref.plane.exact_frame import Exact, Frame, box_of, exact_polygons, fitted

SIZE, PAD = 400, 6
FILLS = ("#b9dcbb", "#9cc3e6", "#f2c18d")  # in turn
STYLE = (
    "path{stroke-width:1;stroke-linejoin:round;fill-rule:evenodd;stroke:#2a6e30}"
    ".tight{fill:none;stroke:#c9362b;stroke-width:2}"
)


def small_picture(
    sets: Sequence[_core.PolygonSet], caption: str, passages: Sequence[Sequence[Exact]] = ()
) -> str:
    """An SVG document: the sets in one frame, with lines, and rings around points, on top. Numbers
    stay exact until the frame places them. Linear."""
    exact = [exact_polygons(each) for each in sets]
    lines = [list(each) for each in passages]
    box = box_of([polygon for polygons in exact for polygon in polygons] + [[it] for it in lines])
    frame = fitted(box or (Fraction(0), Fraction(0), Fraction(1), Fraction(1)), SIZE, SIZE)
    height = SIZE if box is None else float((box[3] - box[1]) * frame.factor)
    drawn = [
        f'<path fill="{FILLS[k % len(FILLS)]}" d="'
        + "".join(_path(frame, ring, height) + "Z" for polygon in polygons for ring in polygon)
        + '"/>'
        for k, polygons in enumerate(exact)
    ]
    drawn += [_passage(frame, line, height) for line in lines]
    width = SIZE + 2 * PAD
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-PAD} {-PAD} {width} '
        f'{height + 2 * PAD:.0f}" width="{width}" role="img" '
        f'aria-label="{escape(escaped(caption), quote=True)}"><title>{escape(escaped(caption))}'
        f"</title><style>{STYLE}</style>{''.join(drawn)}</svg>"
    )


def places_picture(found: Any, word: str, passages: Sequence[dict[str, Any]]) -> str:
    """A picture of a region with components and holes, which the caption counts, and its
    passages."""
    counts = f"{counted(found.components, 'component')}, {counted(found.holes, 'hole')}"
    points = [passage["points"] for passage in passages]
    return small_picture([found.region], f"{word}: {counts}", points)


def _path(frame: Frame, ring: Sequence[Exact], height: float) -> str:
    return "M" + "L".join(f"{x:.2f} {height - y:.2f}" for x, y in frame.ring(ring))


def _passage(frame: Frame, line: Sequence[Exact], height: float) -> str:
    if len(line) > 1:
        return f'<path class="tight" d="{_path(frame, line, height)}"/>'
    ((x, y),) = frame.ring(line)
    return f'<circle class="tight" cx="{x:.2f}" cy="{height - y:.2f}" r="4"/>'
