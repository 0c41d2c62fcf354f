"""The copies of a scene as written: objects of a scene's file, or rows of a CSV file."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from minkref.errors import Refusal, choice, nearest
from minkref.exact import LONGEST_SCALE, exact_scale, read_number
from minkref.file_text import text_of_file
from minkref.output.terminal import escaped
from minkref.scene.exact_json import Numeral, check_members, shown

COLUMNS = ("shape", "scale", "x", "y")
PLACE = 'give two numbers, for example ["1/3", "-0.25"]'


class CopyRow(NamedTuple):
    """A copy: the number of its shape, and exact numbers in lowest terms."""

    shape: int
    scale: str
    x: str
    y: str


def copies_of_json(value: Any, shapes: Sequence[str], source: str) -> list[CopyRow]:
    """Read the member `copies`. Refusals name copy and field. Linear."""
    if not isinstance(value, list):
        mend = "give a list of copies, or the name of a CSV file"
        raise Refusal(
            f"these are no copies: {shown(value)}", f"{source}, copies", mend, "wrong-type"
        )
    numbers = _numbers(shapes)
    rows = []
    for k, each in enumerate(value):
        where = f"{source}, copy {k}"
        copy = check_members(each, where, ("shape", "scale", "place"))
        place = copy["place"]
        if not isinstance(place, list) or len(place) != 2:
            raise Refusal("a place has two coordinates", f"{where}, place", PLACE, "wrong-type")
        shape = copy["shape"]
        if not isinstance(shape, str) or isinstance(shape, Numeral):
            what = f"a shape is named by a string, not by {shown(shape)}"
            raise Refusal(what, f"{where}, shape", choice("", shapes), "wrong-type")
        words = [_word(copy["scale"], f"{where}, scale")]
        words += [_word(x, f"{where}, place, {axis}") for x, axis in zip(place, "xy", strict=True)]
        rows.append(_row(numbers, shapes, shape, words, where, ("scale", "place, x", "place, y")))
    return rows


def copies_of_csv(path: Path, shapes: Sequence[str]) -> list[CopyRow]:
    """Read a CSV file whose first line names the columns shape, scale, x and y, in any order.
    Refusals name copy, line and field. Linear."""
    source = escaped(str(path))
    mend = "name a CSV file with the columns shape, scale, x and y"
    if path.is_dir():
        raise Refusal("this is a folder", source, mend, "not-a-file")
    text = text_of_file(path, source, mend).removeprefix("\ufeff")
    numbers = _numbers(shapes)
    rows: list[CopyRow] = []
    columns: list[int] | None = None
    reader = csv.reader(text.splitlines())
    try:
        for cells in reader:
            if not any(cell.strip() for cell in cells):
                continue
            if columns is None:
                columns = _columns(cells, f"{source}, line {reader.line_num}")
                continue
            where = f"{source}, copy {len(rows)} (line {reader.line_num})"
            if len(cells) != len(columns):
                what = f"this line has {len(cells)} cells, not {len(columns)}"
                raise Refusal(what, where, "give one cell for each column", "bad-scene")
            shape, *words = (cells[column].strip() for column in columns)
            rows.append(_row(numbers, shapes, shape, words, where, COLUMNS[1:]))
    except csv.Error as error:
        where = f"{source}, line {reader.line_num}"
        raise Refusal(f"this is not CSV: {error}", where, "correct it", "bad-scene") from error
    if columns is None:
        what = "the file is empty; its first line names the columns"
        raise Refusal(what, source, "begin it with shape,scale,x,y", "bad-scene")
    return rows


def _columns(cells: list[str], where: str) -> list[int]:
    """The places of the columns COLUMNS."""
    names = [cell.strip().lower() for cell in cells]
    for name in names:
        if name not in COLUMNS or names.count(name) > 1:
            what = (
                f"there is no column {shown(name)}"
                if name not in COLUMNS
                else (f"the column {name} is there twice")
            )
            mend = f"{nearest(name, COLUMNS)}begin the file with shape,scale,x,y"
            raise Refusal(what, where, mend, "bad-scene")
    missing = [name for name in COLUMNS if name not in names]
    if missing:
        what = f"the first line lacks {', '.join(missing)}"
        raise Refusal(what, where, "begin the file with shape,scale,x,y", "bad-scene")
    return [names.index(name) for name in COLUMNS]


def _numbers(shapes: Sequence[str]) -> dict[str, int]:
    return {name: number for number, name in enumerate(shapes)}


def _word(value: Any, where: str) -> str:
    if not isinstance(value, str):
        mend = 'give a number, for example "7/5" or 0.25'
        raise Refusal(f"this is not a number: {shown(value)}", where, mend, "not-a-number")
    return value.strip()


def _row(
    numbers: dict[str, int],
    shapes: Sequence[str],
    shape: str,
    words: Sequence[str],
    where: str,
    fields: Sequence[str],
) -> CopyRow:
    """Make a copy from its shape's name and the texts of scale, x and y. `fields`: their names."""
    if shape not in numbers:
        what = f"the scene has no shape {shown(shape)}"
        raise Refusal(what, f"{where}, shape", choice(shape, shapes), "no-such-shape")
    scale = exact_scale(words[0], f"{where}, {fields[0]}")
    x, y = (
        _coordinate(word, f"{where}, {field}")
        for word, field in zip(words[1:], fields[1:], strict=True)
    )
    return CopyRow(numbers[shape], str(scale), x, y)


def _coordinate(text: str, where: str) -> str:
    mend = "give a number, for example 1/3 or -0.25"
    if len(text) > LONGEST_SCALE:
        what = f"the number has more than {LONGEST_SCALE} characters"
        raise Refusal(what, where, mend, "limit")
    return str(read_number(text, "coordinate", where, mend))
