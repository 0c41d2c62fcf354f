"""Cases of paths and traps in the table of their family, and drawn: the part among the obstacles,
and the places that collide, below, at and above their scale."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.geometry.plane import Point, fraction_rings
from minkref.motion.path_values import ScaleRange
from minkref.reports.degeneracies.cases import unfit
from minkref.reports.degeneracies.pictures import Drawn

SIZE = 300  # pixels along the longer side
AROUND = Fraction(1, 8)  # just below and above: an eighth of the scale
Place = tuple[float, float]


@dataclass(frozen=True)
class PathRow:
    """A case's row in the family's table. `asked`: valid or trapped; `allowed` and `forbidden`: the
    scales that are valid or trapped, with contact allowed or forbidden."""

    id: str
    file: str
    title: str
    vertices: int
    scale: str
    asked: str
    allowed: str
    forbidden: str
    why: str


def path_row(path: Path, value: dict[str, Any]) -> PathRow:
    ((asked, expected),) = value["expected"].items()
    told = value["degeneracy"]
    return PathRow(
        value["id"],
        str(path),
        value["title"],
        sum(len(ring) for name in "RO" for ring in _rings(value[name])),
        told["at"],
        asked,
        _told(expected["allowed"]),
        _told(expected["forbidden"]),
        told["why"],
    )


def path_case_pictures(path: Path, value: dict[str, Any]) -> list[Drawn]:
    """Pictures in one frame: an eighth below the scale, at the scale, and an eighth above."""
    at = Fraction(value["degeneracy"]["at"])
    wanted = ((at * (1 - AROUND), "below"), (at, "at"), (at * (1 + AROUND), "above"))
    try:
        part, obstacles = (_core.PolygonSet.from_json(json.dumps(value[name])) for name in "RO")
        for name, one in (("R", part), ("O", obstacles)):
            one.validate(name)
        way = [(float(Fraction(x)), float(Fraction(y))) for x, y in value["path"]]
        walls = [_near(ring) for ring in _rings(value["O"])]
        scenes = []
        for s, where in wanted:
            region = _core.minkowski_sum(part.scaled("-1"), obstacles, str(s)).region
            collide = [_near(ring) for ring in fraction_rings(region.to_json())]
            placed = [[_placed(p, float(s), way[0]) for p in _near(r)] for r in _rings(value["R"])]
            scenes.append((f"{where} the scale {value['degeneracy']['at']}", collide, placed))
        everything = [
            p for _, *shapes in scenes for rings in shapes for ring in rings for p in ring
        ]
        frame = _frame([*everything, *way, *(p for ring in walls for p in ring)])
        return [
            Drawn(caption, _picture(frame, caption, collide, walls, placed, way))
            for caption, collide, placed in scenes
        ]
    except (_core.BadInput, ArithmeticError) as error:
        raise unfit(path, f"it cannot be drawn: {message_of(error)}", "not-drawable") from error


def _told(ranges: list[dict[str, Any]]) -> str:
    spans = [
        ScaleRange(
            Fraction(one["from"]),
            None if one["to"] is None else Fraction(one["to"]),
            one["from_in"],
            one["to_in"],
        )
        for one in ranges
    ]
    return ", ".join(map(str, spans)) or "none"


def _rings(value: dict[str, Any]) -> list[list[Point]]:
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in value["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]


def _near(ring: Iterable[Point]) -> list[Place]:
    return [(float(x), float(y)) for x, y in ring]


def _placed(p: Place, scale: float, at: Place) -> Place:
    return at[0] + scale * p[0], at[1] + scale * p[1]


def _frame(points: list[Place]) -> tuple[float, float, float, float]:
    """Left, top, and pixels for a unit; the height in units."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    size = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    return min(xs), max(ys), SIZE / size, max(ys) - min(ys)


def _picture(
    frame: tuple[float, float, float, float],
    label: str,
    collide: list[list[Place]],
    walls: list[list[Place]],
    part: list[list[Place]],
    way: list[Place],
) -> str:
    left, top, unit, height = frame

    def at(p: Place) -> str:
        return f"{(p[0] - left) * unit:.2f} {(top - p[1]) * unit:.2f}"

    def shape(rings: list[list[Place]], style: str) -> str:
        d = "".join(f"M{' L'.join(map(at, ring))} Z" for ring in rings)
        return f'<path d="{d}" fill-rule="evenodd" {style}/>'

    x, y = at(way[0]).split()
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -5 {SIZE + 10} '
        f'{height * unit + 10:.2f}" width="{SIZE + 10}" role="img" aria-label="{label}">'
        + shape(collide, 'fill="#e8d7d3" stroke="#b03a2e" stroke-width=".8"')
        + shape(walls, 'fill="#7aa6c2" stroke="#2f5d7c" stroke-width=".8"')
        + shape(part, 'fill="#d9a441" fill-opacity=".7" stroke="#7a5a17" stroke-width=".8"')
        + f'<path d="M{" L".join(map(at, way))}" fill="none" stroke="#111" stroke-width="1.2"/>'
        + f'<circle cx="{x}" cy="{y}" r="2.5" fill="#111"/></svg>'
    )
