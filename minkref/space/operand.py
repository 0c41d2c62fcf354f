"""A polyhedron on the command line: a file, or a model's name, read exactly and validated."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusal_of, refusing
from minkref.file_text import LONGEST, bytes_of_file
from minkref.model_catalogue import shipped_polyhedra
from minkref.output.terminal import escaped
from minkref.plane.operand import LONGEST_NAME, is_regular, is_utf8, read_operand
from minkref.plane.repair_offer import offering_repair
from minkref.repair.solid import repaired_solid
from minkref.space.ball import is_ball

FORMATS = tuple(f".{name}" for name in _core.MESH_FORMATS if name != "json")


#: Refusals of polyhedra that a repair mends, if nothing else stands against it.
MENDED_AT_TIMES = (
    "zero-length-edge", "zero-area", "non-planar-face", "repeated-vertex", "unused-vertex",
    "wrong-orientation", "open-mesh", "non-manifold-edge", "non-manifold-vertex", "shell-nesting",
    "overlapping-faces",
)  # fmt: skip
MOST_TRIED = 5_000  # faces

CONVEX_ONLY = "give a convex polyhedron; `minkref sum` and `minkref view` take any other"


@dataclass(frozen=True)
class SpaceOperand:
    """An operand in space. `body` is None unless the operand is convex and has a volume; the empty
    set, points, segments and plane polygons have none."""

    name: str
    file: Path
    surface: _core.Polyhedron
    body: _core.ConvexPolyhedron | None
    warnings: list[str] = field(default_factory=list)

    @property
    def is_solid(self) -> bool:
        """Whether the operand has a volume."""
        return self.surface.faces > 1

    @property
    def is_thin(self) -> bool:
        """Whether the operand is the empty set, a point or a segment."""
        return self.surface.faces == 0

    def canonical(self) -> _core.Polyhedron:
        """Return the canonical form of a convex operand with a volume; any other operand as
        given."""
        return self.surface if self.body is None else self.body.surface()


def in_space(P: str, Q: str) -> bool:
    """Tell whether two names mean polyhedra. Refuses an operand in the plane beside an operand in
    space."""
    for name in filter(is_ball, (P, Q)):
        mend = "give a polyhedron; `minkref sum` and `minkref erode` also take a ball"
        raise Refusal("this command takes no ball", name, mend, "not-with-ball")
    kinds = [is_polyhedron(name) for name in (P, Q)]
    if kinds[0] != kinds[1]:
        flat, solid = (P, Q) if kinds[1] else (Q, P)
        read_operand(flat)  # a name without any operand lies nowhere: say so first
        raise Refusal(
            f"this operand lies in the plane, but {solid} lies in space",
            flat,
            "give two polygon sets, or two polyhedra",
            "mixed-dimensions",
        )
    return kinds[0]


def read_space_operand(name: str) -> SpaceOperand:
    """Read a convex operand. A file wins over a model with the same name. Refuses missing, invalid
    or non-convex operands."""
    operand = read_summand(name, convex=True)
    if operand.surface.faces == 1:
        source = escaped(str(operand.file))
        refusing(source, lambda: operand.surface.validate(source))
    return operand


def read_summand(name: str, convex: bool = False) -> SpaceOperand:
    """Read a polyhedron of any shape, or a plane polygon. `convex`: refuses a polyhedron that is
    not convex."""
    path, surface, warnings = read_surface(name)
    source = escaped(str(path))
    if surface.faces < 2:
        refusing(source, lambda: surface.validate_summand(source))
        return SpaceOperand(name, path, surface, None, warnings)
    with offering_repair(path, MENDED_AT_TIMES, lambda: _is_mended(surface, source)):
        body = _body(surface, source, convex)
    return SpaceOperand(name, path, surface, body, warnings)


def _is_mended(surface: _core.Polyhedron, source: str) -> bool:
    """Try whether a repair mends a surface; not for large ones."""
    if surface.faces > MOST_TRIED:
        return False
    try:
        repaired_solid(surface, "nonzero", None, source)
    except Refusal:
        return False
    return True


def read_surface(name: str) -> tuple[Path, _core.Polyhedron, list[str]]:
    """Find and read a polyhedron, not validated, with the reader's warnings."""
    path = Path(name)
    if not path.is_file():
        path = _models().get(name, path)
    if not path.exists():
        raise Refusal("there is no such file", name, "check the path", "no-such-file")
    if not path.is_file():
        mend = f"write it to a file first whose ending names the format: {', '.join(FORMATS)}"
        raise Refusal("this is not a regular file", name, mend, "not-a-file")
    surface, warnings = _read(path, escaped(str(path)))
    return path, surface, warnings


def _body(surface: _core.Polyhedron, source: str, convex: bool) -> _core.ConvexPolyhedron | None:
    """Make a convex body. Refuses invalid surfaces; None for a surface that is not convex, unless
    `convex` refuses."""
    try:
        return _core.ConvexPolyhedron(surface, source)
    except _core.BadInput as error:
        refusal = refusal_of(error, source)
        if refusal.code != "not-convex":
            raise refusal from error
        if convex:
            raise Refusal(refusal.what, refusal.where, CONVEX_ONLY, refusal.code) from error
        return None


def refuse_thin(operand: SpaceOperand) -> None:
    """Refuse the empty set, a point and a segment."""
    if operand.is_thin:
        mend = "give a polyhedron by its faces, or a plane polygon"
        raise Refusal("the operand has no volume", operand.name, mend, "not-solid")


def solid(operand: SpaceOperand) -> _core.ConvexPolyhedron:
    """Return the convex body. Refuses an operand without one."""
    if operand.body is None:
        raise Refusal(
            "the operand has no volume",
            operand.name,
            "give a convex polyhedron by its faces",
            "not-solid",
        )
    return operand.body


def _models() -> dict[str, Path]:
    return {model.name: model.path for model in shipped_polyhedra()}


def is_polyhedron(name: str) -> bool:
    """Tell whether a name means a polyhedron: by the ending, the members of JSON, or as a model."""
    path = Path(name)
    if "\0" in name or not name or len(path.name) > LONGEST_NAME:
        return False
    if path.suffix.lower() in FORMATS:
        return True
    if is_regular(path):
        return path.suffix.lower() == ".json" and _holds_vertices(path)
    return name in _models()


def _holds_vertices(path: Path) -> bool:
    """Tell whether the file is a JSON object with a member `vertices`. The reader tells other
    faults."""
    try:
        with path.open("rb") as stream:
            document: Any = json.loads(stream.read(LONGEST), parse_int=str, parse_float=str)
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(document, dict) and "vertices" in document


def _read(path: Path, source: str) -> tuple[_core.Polyhedron, list[str]]:
    if is_utf8(str(path)):
        return refusing(source, lambda: _core.read_mesh_file(str(path)))
    content = bytes_of_file(path, source, "name a file that you may read")
    form = path.suffix.lower().removeprefix(".")
    return refusing(source, lambda: _core.read_mesh_text(content, form, source))
