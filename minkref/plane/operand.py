"""An operand on the command line: a file, or a model's name, read exactly and validated."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from minkref import _core
from minkref.disc.disc import is_disc
from minkref.drawings.drawing import DRAWINGS, is_drawing, read_drawing
from minkref.errors import Refusal, nearest, refusing
from minkref.file_text import text_of_file
from minkref.model_catalogue import PAPER_MODELS, VARIABLE, all_models, shipped_polyhedra
from minkref.output.terminal import escaped
from minkref.plane.operand_text import is_text, source_of, text_and_form
from minkref.plane.repair_offer import MENDED, offering_repair

FORMATS = tuple(f".{name}" for name, is_read in _core.SET_FORMATS.items() if is_read)
INPUTS = (*FORMATS, *DRAWINGS)
MESHES = tuple(f".{name}" for name in _core.MESH_FORMATS if name != "json")
LONGEST_NAME = 255  # characters; no system allows longer names


@dataclass(frozen=True)
class Operand:
    name: str
    source: str
    set: _core.PolygonSet
    warnings: list[str] = field(default_factory=list)

    @property
    def file(self) -> Path:
        """The operand's file, also for an operand in a case (`case.json#Q`)."""
        path = Path(self.source)
        return path if path.exists() else Path(self.source.removesuffix("#P").removesuffix("#Q"))


def read_operand(name: str, lines: bool = False) -> Operand:
    """Read an operand, as `as_written` does, and validate it. `lines`: it may consist of several
    points and segments."""
    return validated(as_written(name), lines)


def validated(operand: Operand, lines: bool = False) -> Operand:
    source = escaped(operand.source)
    with offering_repair(operand.file, MENDED):
        refusing(source, lambda: operand.set.validate(source, lines))
    return operand


def as_written(name: str) -> Operand:
    """Read an operand, not validated: see `found`."""
    return found(name, Reader())


def as_faulty(
    name: str, drawing: Callable[[Path], tuple[_core.PolygonSet, list[str]]] = read_drawing
) -> tuple[Operand, list[int]]:
    """Read an operand for a repair: rings as written, none refused for a fault that can be mended;
    and of each ring 1 if it is open, else 0. `drawing` reads drawings."""
    reader = FaultyReader(drawing)
    return found(name, reader), reader.is_open


class Reader:
    """Reads files and texts, not validated."""

    def file(self, source: str) -> _core.PolygonSet:
        return _core.read_file(source)

    def text(self, text: str, form: str, source: str) -> _core.PolygonSet:
        return _core.read_text(text, form, source)

    def drawing(self, path: Path) -> tuple[_core.PolygonSet, list[str]]:
        return read_drawing(path)


class FaultyReader(Reader):
    """Reads rings with faults, and keeps which are open; and drawings as asked for."""

    def __init__(self, drawing: Callable[[Path], tuple[_core.PolygonSet, list[str]]]) -> None:
        self.is_open: list[int] = []
        self._drawing = drawing

    def drawing(self, path: Path) -> tuple[_core.PolygonSet, list[str]]:
        return self._drawing(path)

    def file(self, source: str) -> _core.PolygonSet:
        read, self.is_open = _core.read_faulty_file(source)
        return read

    def text(self, text: str, form: str, source: str) -> _core.PolygonSet:
        read, self.is_open = _core.read_faulty_text(text, form, source)
        return read


def found(name: str, reader: Reader) -> Operand:
    """Find and read an operand. A file wins over a model with the same name, and both over a
    text: `-` means standard input; WKT and JSON texts are operands themselves. Refuses missing
    operands, and what is no text of a set."""
    if not name:
        raise Refusal("the name is empty", "operand", "name a file or a model", "no-such-file")
    path = Path(name)
    if path.suffix.lower() in MESHES:
        raise _refuse_mesh("the name is that of a polyhedron", name)
    if is_file(name):
        return _read(name, path, reader)
    models = all_models()
    if name in models:
        return _read(name, models[name].path, reader)
    if is_text(name):
        return _of_text(name, reader)
    _refuse_special(name, path)
    if path.suffix in INPUTS or len(path.parts) > 1:
        raise Refusal("there is no such file", name, "check the path", "no-such-file")
    if name in {paper for paper, *_ in PAPER_MODELS}:
        alike = next(look for paper, _, look, _ in PAPER_MODELS if paper == name)
        raise Refusal(
            "this model of the paper is not included in minkref",
            name,
            f"set {VARIABLE} to the folder that holds it, or use our look-alike {alike}",
            "no-such-model",
        )
    if name in {polyhedron.name for polyhedron in shipped_polyhedra()}:
        raise _refuse_mesh("this model is a polyhedron", name)
    if is_disc(name):
        raise Refusal(
            "a disc is no operand here",
            name,
            "sum takes disc:R, and sweep, events, index and view take `disc`; elsewhere take a "
            "polygon for it: minkref sum 'POINT (0 0)' disc:R --tolerance T -o disc.wkt, with "
            "--outside one around it",
            "no-disc",
        )
    hint = nearest(name, models)
    raise Refusal(
        "there is neither a file nor a model of this name",
        name,
        f"{hint}`minkref models` lists the models",
        "no-such-model",
    )


def _refuse_mesh(what: str, name: str) -> Refusal:
    mend = f"give a set of polygons: {', '.join(INPUTS)}, or one of `minkref models`"
    return Refusal(f"{what}, and this operand lies in the plane", name, mend, "three-dimensional")


def _of_text(name: str, reader: Reader) -> Operand:
    text, form = text_and_form(name)
    source = escaped(source_of(name))
    operand = refusing(source, lambda: reader.text(text, form, source))
    return Operand(source, source, operand, operand.warnings)


def is_file(name: str) -> bool:
    """Tell whether a name means a file that can hold an operand: a regular file, a pipe whose
    ending names the format, or an operand in a case (`case.json#Q`)."""
    path = Path(name)
    if name.endswith(("#P", "#Q")) and is_regular(Path(name[:-2])):
        return True
    return is_regular(path) or (path.suffix.lower() in FORMATS and path.is_fifo())


def is_regular(path: Path) -> bool:
    """Tell whether a regular file exists; a text too long for a name means none."""
    try:
        return len(path.name) <= LONGEST_NAME and path.is_file()
    except (OSError, ValueError):
        return False


def read_set(path: Path, reader: Reader | None = None) -> _core.PolygonSet:
    """Read the set in a file, not validated; the reader's warnings are its `warnings`."""
    source = str(path)
    reader = reader or Reader()
    if is_utf8(source):
        return refusing(source, lambda: reader.file(source))
    text = text_of_file(path, escaped(source), "name a file that you may read")
    form = path.suffix.lower().removeprefix(".")
    return refusing(escaped(source), lambda: reader.text(text, form, escaped(source)))


def _read(name: str, path: Path, reader: Reader) -> Operand:
    if is_drawing(path):
        return Operand(name, str(path), *reader.drawing(path))
    with offering_repair(path, MENDED):
        operand = read_set(path, reader)
    return Operand(name, str(path), operand, operand.warnings)


def _refuse_special(name: str, path: Path) -> None:
    if "\0" in name or not path.exists():
        return
    if path.is_dir():
        raise Refusal("this is a folder", name, "name a file or a model", "not-a-file")
    raise Refusal(
        "this is not a regular file",
        name,
        f"write it to a file first whose ending names the format: {', '.join(INPUTS)}",
        "not-a-file",
    )


def is_utf8(name: str) -> bool:
    try:
        os.fsencode(name).decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True
