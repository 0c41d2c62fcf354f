"""`minkref repair` in the plane."""

from __future__ import annotations

from pathlib import Path

from minkref import _core
from minkref.drawings.drawing import read_drawing
from minkref.errors import Refusal, refusing
from minkref.output.terminal import escaped
from minkref.plane.operand import Operand, as_faulty, as_written
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.repair.change import Change
from minkref.repair.plane import repaired
from minkref.repair.weld import Vector, squared_distance
from minkref.verbs.repair import RepairRequest
from minkref.verbs.repair_output import Repaired, answer

FORMS = ("wkt", "geojson", "poly", "json")


def run(request: RepairRequest) -> None:
    answer(request, FORMS, "wkt", _repair)


def _is_thin(operand: Operand) -> bool:
    """Tell whether the operand consists of points and segments, not of polygons with as few
    points."""
    given = operand.set
    if not given.is_lines and (given.ring_count != 1 or not (given.is_point or given.is_segment)):
        return False
    try:
        return operand.name == STANDARD_INPUT or as_written(operand.name) is not None
    except Refusal:
        return False


def _repair(request: RepairRequest) -> Repaired:
    moves: dict[Vector, Vector] = {}  # ends of lines in a drawing

    def drawing(path: Path) -> tuple[_core.PolygonSet, list[str]]:
        return read_drawing(path, request.tolerance, request.layer, request.weld, moves)

    operand, is_open = as_faulty(request.file, drawing)
    source = escaped(operand.source)
    found, changes = operand.set, list[Change]()
    if not _is_thin(operand):
        found, changes = repaired(operand.set, is_open, request.rule, request.weld)
        changes[:0] = [
            Change("welded", point=point, to=to, squared_distance=squared_distance(point, to))
            for point, to in moves.items()
        ]
    if operand.set.is_region or not operand.set.is_empty:
        refusing(source, lambda: found.validate(source, found.is_lines))
    return Repaired(
        operand.file if operand.file.is_file() else None,
        2,
        changes,
        operand.warnings,
        {"area": found.area(), "volume": None, "vertices": found.vertices, "faces": None},
        lambda form: _core.write(found, form),
        lambda form: _core.writes_exactly(found, form),
        lambda text, form: _core.read_text(text, form).validate("", found.is_lines),
    )
