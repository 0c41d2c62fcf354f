"""`minkref repair` in space."""

from __future__ import annotations

from minkref import _core
from minkref.output.terminal import escaped
from minkref.repair.solid import repaired_solid
from minkref.space.operand import read_surface
from minkref.verbs.repair import RepairRequest
from minkref.verbs.repair_output import Repaired, answer

FORMS = ("json", "off", "obj", "stl", "ply")


def run(request: RepairRequest) -> None:
    answer(request, FORMS, "json", _repair)


def _repair(request: RepairRequest) -> Repaired:
    path, surface, warnings = read_surface(request.file)
    source = escaped(str(path))
    found, changes = repaired_solid(surface, request.rule, request.weld, source)
    volume = found.sextuple_volume() / 6
    return Repaired(
        path,
        3,
        changes,
        warnings,
        {"area": None, "volume": str(volume), "vertices": found.vertices, "faces": found.faces},
        lambda form: _core.write_mesh(found, form),
        lambda form: _core.writes_mesh_exactly(found, form),
        lambda text, form: _core.read_mesh_text(text.encode(), form)[0].validate_summand(),
    )
