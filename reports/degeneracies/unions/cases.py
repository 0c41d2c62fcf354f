"""Union cases: table rows; pictures show sets, degenerate points, and the union."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.geometry.plane import fraction_rings
from minkref.reports.degeneracies.cases import unfit
from minkref.reports.degeneracies.pictures import Drawn

SIZE = 300  # pixels along the longer side
COLOURS = ("#7aa6c2", "#d9a441", "#8fb98b", "#c38fb0")
Place = tuple[float, float]
Rings = list[list[Place]]


@dataclass(frozen=True)
class UnionRow:
    """A row. `points`: degenerate ones shown; `counts`: components/holes."""

    id: str
    file: str
    title: str
    sets: int
    vertices: int
    points: int
    counts: str
    area: str
    why: str


def union_row(path: Path, value: dict[str, Any]) -> UnionRow:
    expected, told = value["expected"], value["degeneracy"]
    rings = [
        ring for one in value["sets"] for p in one["polygons"] for ring in (p["outer"], *p["holes"])
    ]
    return UnionRow(
        value["id"],
        str(path),
        value["title"],
        len(value["sets"]),
        sum(map(len, rings)),
        len(told["points"]),
        f"{expected['components']}/{expected['holes']}",
        expected["area"],
        told["why"],
    )


def union_case_pictures(path: Path, value: dict[str, Any]) -> list[Drawn]:
    """Two pictures in one frame: the sets, and their union."""
    try:
        sets = [_core.PolygonSet.from_json(json.dumps(one)) for one in value["sets"]]
        for k, one in enumerate(sets):
            one.validate(f"set {k}")
        shapes = [_near(one) for one in sets]
        whole = _near(_core.combined("union", sets)[0])
        points = [
            (float(Fraction(x)), float(Fraction(y))) for x, y in value["degeneracy"]["points"]
        ]
        frame = _Frame.of([p for shape in shapes for ring in shape for p in ring])
        return [
            Drawn("the sets", frame.drawn("the sets", shapes, points)),
            Drawn("the union", frame.drawn("the union", [whole], points)),
        ]
    except (_core.BadInput, ArithmeticError) as error:
        raise unfit(path, f"it cannot be drawn: {message_of(error)}", "not-drawable") from error


def _near(region: _core.PolygonSet) -> Rings:
    return [[(float(x), float(y)) for x, y in ring] for ring in fraction_rings(region.to_json())]


@dataclass(frozen=True)
class _Frame:
    """Left and top ends, pixels per unit along each axis. Slivers are stretched."""

    left: float
    top: float
    across: float
    down: float

    @classmethod
    def of(cls, points: Sequence[Place]) -> _Frame:
        xs, ys = [x for x, _ in points] or [0.0], [y for _, y in points] or [0.0]
        width, height = max(xs) - min(xs) or 1.0, max(ys) - min(ys) or 1.0
        unit = SIZE / max(width, height)
        return cls(min(xs), max(ys), max(unit, SIZE / 3 / width), max(unit, SIZE / 3 / height))

    def at(self, p: Place) -> str:
        return f"{(p[0] - self.left) * self.across:.2f} {(self.top - p[1]) * self.down:.2f}"

    def outline(self, shape: Rings) -> str:
        return "".join(f"M{' L'.join(map(self.at, ring))} Z" for ring in shape)

    def drawn(self, label: str, shapes: Sequence[Rings], points: Sequence[Place]) -> str:
        paths = "".join(
            f'<path d="{self.outline(shape)}" '
            f'fill-rule="evenodd" fill="{COLOURS[k % len(COLOURS)]}" fill-opacity=".6" '
            'stroke="#333" stroke-width=".8"/>'
            for k, shape in enumerate(shapes)
        )
        for p in points:
            x, y = self.at(p).split()
            paths += f'<circle cx="{x}" cy="{y}" r="2.5" fill="#b03a2e"/>'
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -5 {SIZE + 10} {SIZE + 10}" '
            f'width="{SIZE + 10}" role="img" aria-label="{label}">{paths}</svg>'
        )
