"""A path on the command line: a polyline from a file or a text, read exactly."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

from minkref.errors import Refusal
from minkref.exact import read_number
from minkref.file_text import text_of_file
from minkref.output.terminal import escaped
from minkref.plane.operand import is_regular
from minkref.plane.operand_text import is_text, source_of, starts_wkt, text_of

FORMATS = (".wkt", ".geojson", ".json", ".csv")
MOST_VERTICES = 1_000_000
ExactPoint = tuple[str, str]
ExactSpacePoint = tuple[str, str, str]
Vertex = tuple[str, ...]

_LINE = re.compile(r"\s*(LINESTRING|POINT)\s*(Z?)\s*\((.*)\)\s*;?\s*", re.IGNORECASE | re.DOTALL)
_ROW = re.compile(r"[\s\ufeff]*([xX]\s*,\s*[yY]|[+-]?[\d.][^,\n]*,\s*[+-]?[\d.])")  # for CSV
_MEND = {
    2: "give two numbers, for example 1/3 and -0.25",
    3: "give three numbers, for example 1/3, -0.25 and 2",
}
_LINES = {2: "LINESTRING (0 0, 4 0, 4 3)", 3: "LINESTRING Z (0 0 0, 4 0 0, 4 3 1)"}
_POSITIONS = {2: "[[0, 0], [4, 3]]", 3: "[[0, 0, 0], [4, 3, 1]]"}


@dataclass(frozen=True)
class PathText:
    """A polyline as read. `name`: its name in messages; `file`: None for an inline text."""

    name: str
    file: Path | None
    points: list[ExactPoint]


@dataclass(frozen=True)
class SpacePathText:
    """A polyline in space, likewise."""

    name: str
    file: Path | None
    points: list[ExactSpacePoint]


def read_path(name: str) -> PathText:
    """Read a WKT LINESTRING or POINT, a GeoJSON LineString or Point (or a Feature with one), or CSV
    with a vertex `x,y` per line, perhaps below a line of names: from a file, a text, or `-` for
    standard input. Takes numbers exactly as written. Refuses other input, naming file and vertex.
    Linear."""
    source, file, vertices = _read(name, 2)
    return PathText(source, file, [(x, y) for x, y in vertices])


def read_space_path(name: str) -> SpacePathText:
    """Read a path in space likewise: LINESTRING Z, positions with three numbers, or lines
    `x,y,z`."""
    source, file, vertices = _read(name, 3)
    return SpacePathText(source, file, [(x, y, z) for x, y, z in vertices])


def _read(name: str, count: int) -> tuple[str, Path | None, list[Vertex]]:
    """Read a path whose vertices have `count` coordinates."""
    if not name:
        raise Refusal("the name is empty", "PATH", f"name a file ({_endings()})", "no-such-file")
    file = Path(name)
    if is_regular(file):
        return _of_file(name, file, count)
    if is_text(name) or _ROW.match(name):
        text, source = text_of(name), escaped(source_of(name))
        read = _of_csv if _ROW.match(text) else _of_wkt if starts_wkt(text) else _of_geojson
        return source, None, _counted(read(text, source, count), source)
    if file.is_dir():
        raise Refusal("this is a folder", name, f"name a file ({_endings()})", "not-a-file")
    raise Refusal("there is no such file", name, f"name a file ({_endings()})", "no-such-file")


def _endings() -> str:
    return ", ".join(FORMATS)


def _of_file(name: str, file: Path, count: int) -> tuple[str, Path | None, list[Vertex]]:
    source = escaped(name)
    readers = {".wkt": _of_wkt, ".geojson": _of_geojson, ".json": _of_geojson, ".csv": _of_csv}
    reader = readers.get(file.suffix.lower())
    if reader is None:
        raise Refusal(
            f"a path has one of the endings {_endings()}", source, "rename it", "unknown-format"
        )
    text = text_of_file(file, source, "name a file that you may read")
    return source, file, _counted(reader(text, source, count), source)


def _counted(points: list[Vertex], source: str) -> list[Vertex]:
    if not points:
        raise Refusal("the path has no vertex", source, "give it one or more", "bad-path")
    if len(points) > MOST_VERTICES:
        what = f"the path has more than {MOST_VERTICES:,} vertices"
        raise Refusal(what, source, "split it", "limit")
    return points


def _vertex(numbers: Iterable[Any], k: int, source: str, count: int) -> Vertex:
    """Read the path's vertex k, counted from 0."""
    where = f"{source}, vertex {k}"
    words = [str(number).strip() for number in numbers]
    if len(words) != count:
        what = "in the plane has two" if count == 2 else "in space has three"
        raise Refusal(
            f"a vertex {what} coordinates, not {len(words)}", where, _MEND[count], "bad-path"
        )
    return tuple(str(read_number(word, "coordinate", where, _MEND[count])) for word in words)


def _of_wkt(text: str, source: str, count: int) -> list[Vertex]:
    found = _LINE.fullmatch(text.removeprefix("\ufeff"))
    if found is not None and found[1].upper() == "POINT" and "," in found[3]:
        what = "a POINT has one position"
        raise Refusal(what, source, f"write one, or {_LINES[count]}", "bad-path")
    if found is None:
        if re.fullmatch(r"\s*(LINESTRING|POINT)(\s*Z)?\s+EMPTY\s*", text, re.IGNORECASE):
            return []
        what = "this is not a WKT LINESTRING"
        raise Refusal(what, source, f"write {_LINES[count]}", "bad-path")
    read = [_vertex(part.split(), k, source, count) for k, part in enumerate(found[3].split(","))]
    if found[2] and count == 2:
        what = "the path is said to have coordinates beyond x and y (Z)"
        raise Refusal(what, source, f"write {_LINES[count]}", "bad-path")
    return read


def _of_geojson(text: str, source: str, count: int) -> list[Vertex]:
    try:
        value = json.loads(
            text, parse_float=str, parse_int=str, parse_constant=lambda word: str(word)
        )
    except (ValueError, RecursionError) as error:
        raise Refusal(f"this is not JSON: {error}", source, "correct it", "bad-path") from error
    if isinstance(value, dict) and value.get("type") == "Feature":
        value = value.get("geometry")
    if not isinstance(value, dict) or value.get("type") not in ("LineString", "Point"):
        _no_line(source, count)
    places = value.get("coordinates")
    if value["type"] == "Point":
        places = [places]
    if not isinstance(places, list):
        _no_line(source, count)
    points = []
    for k, place in enumerate(places):
        if not isinstance(place, list) or any(isinstance(n, list | dict) for n in place):
            raise Refusal(
                "this is not a position", f"{source}, vertex {k}", _MEND[count], "bad-path"
            )
        points.append(_vertex(place, k, source, count))
    return points


def _no_line(source: str, count: int) -> NoReturn:
    mend = f'write {{"type": "LineString", "coordinates": {_POSITIONS[count]}}}'
    raise Refusal("this is not a GeoJSON LineString", source, mend, "bad-path")


def _of_csv(text: str, source: str, count: int) -> list[Vertex]:
    try:
        lines = [row for row in csv.reader(text.removeprefix("\ufeff").splitlines()) if row]
    except csv.Error as error:
        raise Refusal(f"this is not CSV: {error}", source, "correct it", "bad-path") from error
    if lines and [word.strip().lower() for word in lines[0]] == ["x", "y", "z"][:count]:
        lines = lines[1:]
    return [_vertex(row, k, source, count) for k, row in enumerate(lines)]
