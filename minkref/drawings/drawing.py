"""A drawing as an operand: where to start."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.drawings.dxf import read_dxf
from minkref.drawings.reading import Reading
from minkref.drawings.svg import read_svg
from minkref.errors import Refusal
from minkref.exact import set_json
from minkref.file_text import LONGEST, bytes_of_file
from minkref.output.terminal import escaped
from minkref.repair.weld import Vector

DRAWINGS = (".dxf", ".svg")


def is_drawing(path: Path) -> bool:
    return path.suffix.lower() in DRAWINGS


def read_drawing(
    path: Path,
    tolerance: Fraction | None = None,
    layer: str | None = None,
    weld: Fraction | None = None,
    moves: dict[Vector, Vector] | None = None,
) -> tuple[_core.PolygonSet, list[str]]:
    """Read the set of a DXF or SVG file, not validated, with warnings. Coordinates keep the file's
    decimals. Curves become polylines within `tolerance`; refuses curves without. `layer`: read this
    layer alone; `weld`: join line ends nearer than this, and add each to `moves`. Refuses unknown
    geometry. Rings from DXF nest: an odd number of surrounding rings makes a hole."""
    source = escaped(str(path))
    data = bytes_of_file(path, source, "name a file that you may read")
    if len(data) > LONGEST:
        what = f"the file is longer than {LONGEST:,} bytes"
        raise Refusal(what, source, "split the drawing", "file-too-large")
    reading = Reading(source, tolerance, layer, weld, moves={} if moves is None else moves)
    if path.suffix.lower() == ".svg":
        found = read_svg(data, reading)
    else:
        polygons = read_dxf(data, reading)
        text = set_json((rings[0], rings[1:]) for rings in polygons)
        found = _turned(_core.PolygonSet.from_json(text))
    return found, reading.warnings()


def _turned(found: _core.PolygonSet) -> _core.PolygonSet:
    """Turn rings as their roles demand, which a drawing does not know."""
    polygons = []
    for rings in found.rings():
        outer, *holes = rings
        polygons.append((_run(outer, 1), [_run(hole, -1) for hole in holes]))
    return _core.PolygonSet.from_json(set_json(polygons))


def _run(ring: list[tuple[Fraction, Fraction]], way: int) -> list[tuple[Fraction, Fraction]]:
    following = zip(ring, [*ring[1:], *ring[:1]], strict=True)
    area = sum((ax * by - ay * bx for (ax, ay), (bx, by) in following), Fraction(0))
    return ring if area * way >= 0 else ring[::-1]
