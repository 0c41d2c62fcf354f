"""The file of a scene (scene-v1): a robot, shapes by name, and placed, scaled copies of shapes."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.file_text import text_of_file
from minkref.output.terminal import escaped
from minkref.plane.operand import Operand, as_written, is_file, is_regular, validated
from minkref.plane.operand_text import is_inline, is_text, source_of, text_and_form, text_of
from minkref.scene.copies_text import CopyRow, copies_of_csv, copies_of_json
from minkref.scene.exact_json import Numeral, check_members, exact_json, shown

SCHEMA = "scene-v1"
SET = 'give WKT, the name of a file or a model, or {"polygons": [...]}'


@dataclass(frozen=True)
class SceneFile:
    """A scene as read. `name`: in messages; `files`: all files that were read."""

    name: str
    robot: Operand
    shapes: dict[str, Operand]
    copies: list[CopyRow]
    files: list[Path]

    @property
    def warnings(self) -> list[str]:
        return [word for each in (self.robot, *self.shapes.values()) for word in each.warnings]


def read_scene_file(name: str, copies: Path | None = None) -> SceneFile:
    """Read a scene from a file, a text, or `-` for standard input; names of files in it are
    relative to its folder (of a text, to the current folder). `copies`: a CSV file in place of the
    scene's copies. Numbers count exactly as written; sets are validated. Refusals name the file,
    the copy by its number, the field, and the remedy."""
    source, folder, files, text = _text(name)
    needed = ("schema", "robot", "shapes") if copies else ("schema", "robot", "shapes", "copies")
    value = check_members(exact_json(text, source), source, needed, ("title", "comment", "copies"))
    if value["schema"] != SCHEMA:
        what = f"the schema is {shown(value['schema'])}"
        raise Refusal(
            what, f"{source}, schema", f'write "schema": "{SCHEMA}"', "unsupported-version"
        )
    robot = _operand(value["robot"], f"{source}, robot", folder, files)
    named = value["shapes"]
    if not isinstance(named, dict):
        mend = 'give an object, for example {"box": "POLYGON ((0 0, 1 0, 0 1, 0 0))"}'
        raise Refusal(
            f"these are no shapes: {shown(named)}", f"{source}, shapes", mend, "wrong-type"
        )
    shapes = {
        key: _operand(each, f"{source}, shape {shown(key)}", folder, files)
        for key, each in named.items()
    }
    _refuse_two_without_area(source, robot, shapes)
    listed: Any = copies if copies is not None else value["copies"]
    if isinstance(listed, str) and not isinstance(listed, Numeral):
        listed = Path(os.path.join(folder, listed))
    if isinstance(listed, Path):
        rows = copies_of_csv(listed, list(shapes))
        files.append(listed)
    else:
        rows = copies_of_json(listed, list(shapes), source)
    return SceneFile(source, robot, shapes, rows, files)


def _text(name: str) -> tuple[str, str, list[Path], str]:
    """The scene's name in messages, its folder, its files and its text."""
    if not name:
        raise Refusal(
            "the name is empty", "SCENE", "name a file that ends in .json", "no-such-file"
        )
    path = Path(name)
    mend = "name a scene's file (docs/scenes.md)"
    if is_text(name) and not is_regular(path):
        return escaped(source_of(name)), os.curdir, [], text_of(name)
    if path.is_dir():
        raise Refusal("this is a folder", escaped(name), mend, "not-a-file")
    text = text_of_file(path, escaped(name), mend)
    return escaped(name), os.path.dirname(name) or os.curdir, [path], text


def _operand(value: Any, where: str, folder: str, files: list[Path]) -> Operand:
    """Read and validate the robot or a shape; adds its file to `files`."""
    if isinstance(value, dict):
        text, form = json.dumps(check_members(value, where, ("polygons",))), "json"
    elif not isinstance(value, str) or isinstance(value, Numeral) or not value:
        raise Refusal(f"this is no set: {shown(value)}", where, SET, "wrong-type")
    elif not is_inline(value):
        found = _named(value, where, folder)
        files.append(found.file)
        return found
    else:
        text, form = text_and_form(value, inline=True)
    read = refusing(where, lambda: _core.read_text(text, form, where))
    refusing(where, lambda: read.validate(where))
    return Operand(where, where, read, read.warnings)


def _named(name: str, where: str, folder: str) -> Operand:
    """Read and validate the set of a file in the folder, or else of a model."""
    path = os.path.join(folder, name)
    is_model = not is_file(path) and not Path(name).suffix and os.sep not in name and name != "-"
    try:
        found = validated(as_written(name if is_model else path))
    except Refusal as refusal:
        what, place = refusal.what, f"{where}, {escaped(refusal.where)}"
        raise Refusal(what, place, refusal.mend, refusal.code) from refusal
    return Operand(name, found.source, found.set, found.warnings)


def _refuse_two_without_area(source: str, robot: Operand, shapes: dict[str, Operand]) -> None:
    """Refuse a shape without area beside a robot without area."""
    if robot.set.is_region:
        return
    for name, operand in shapes.items():
        if not operand.set.is_region:
            what = "neither the robot nor this shape has an area"
            mend = "give one of them an area, or leave the shape out"
            raise Refusal(what, f"{source}, shape {shown(name)}", mend, "no-area")
