"""The pages: an index, and one for each family."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
from minkref import _core
from minkref.degeneracies import found, lint
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.flags import explained
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, invalid_member
from minkref.documents import check_writable, write_atomically
from minkref.errors import Refusal, cut, message_of
from minkref.operand import read_operand
from minkref.output_folder import make_folder
from minkref.reports.degeneracies.pictures import Drawn, case_pictures
from minkref.reports.pages import environment
from minkref.terminal import shown

INDEX = "index"
DRAWN = 2  # cases of a family
SIBLINGS = 3  # scales at least: the one, and one below and above
SAMPLE = 300  # characters of an invalid file that are shown


@dataclass(frozen=True)
class Row:
    """A case in the table of its family."""

    id: str
    file: str
    title: str
    vertices: int
    scale: str
    counts: str
    wrong: int  # of so many scales, those at which doubles are
    scales: int
    bits: str
    why: str


@dataclass(frozen=True)
class FamilyPage:
    name: str
    title: str
    why: str
    flags: list[tuple[str, dict[str, Any] | None]]  # None: it is not explained
    rows: list[Row]
    drawings: list[tuple[Row, list[Drawn]]]

    @property
    def is_generated(self) -> bool:
        return self.name in FAMILIES

    @property
    def has_stories(self) -> bool:
        return self.name == found.NAME


@dataclass(frozen=True)
class InvalidPage:
    name: str
    title: str
    why: str
    code: str
    sample: str
    place: tuple[str, ...]


def write_report(
    folder: Path, corpus: Path, reading: Callable[[str], None] = lambda family: None
) -> Path:
    """Writes `index.html`, and `FAMILY.html` for each family of a corpus: each folder with cases.
    Returns the index. `reading` is told the family of each case. Refuses a corpus with a case that
    cannot be shown, and writes nothing."""
    by_family: dict[str, list[Path]] = {}
    for path in lint.case_paths(corpus):
        by_family.setdefault(Path(os.path.abspath(path)).parent.name, []).append(path)
    if INDEX in by_family:
        where = str(by_family[INDEX][0].parent)
        raise Refusal("the front page has this name", where, "give the folder another name")
    pages = [_family(name, paths, reading) for name, paths in sorted(by_family.items())]
    invalid = [_invalid(name) for name in INVALID_FAMILIES]
    templates = environment("degeneracies")
    files = {
        f"{page.name}.html": templates.get_template("family.html.j2").render(page=page)
        for page in pages
    }
    index = templates.get_template("index.html.j2")
    files[f"{INDEX}.html"] = index.render(pages=pages, invalid=invalid, flags=explained())
    make_folder(folder)
    for name in files:
        check_writable(folder / name)
    for name, text in files.items():
        write_atomically(folder / name, text)
    return folder / f"{INDEX}.html"


def _family(name: str, paths: list[Path], reading: Callable[[str], None]) -> FamilyPage:
    title, why, drawn = f"cases of the folder {name}", "", DRAWN
    if name in FAMILIES:
        title, why = FAMILIES[name].title, FAMILIES[name].why
    elif name == found.NAME:
        title = "cases on which libraries were found wrong"
        why = "Found by verification and shrunk, or published; each with its story."
        drawn = len(paths)
    rows: list[Row] = []
    drawings: list[tuple[Row, list[Drawn]]] = []
    used: set[str] = set()
    for path, value in _cases(paths):
        reading(name)
        rows.append(_row(path, value))
        used |= set(value.get("flags", []))
        if len(drawings) < drawn:
            drawings.append((rows[-1], _pictures(path, value)))
    known = explained()
    flags = [(flag, known.get(flag)) for flag in sorted(used)]
    return FamilyPage(name, title, why, flags, rows, drawings)


def _cases(paths: Iterable[Path]) -> Iterator[tuple[Path, dict[str, Any]]]:
    """One at a time. Refuses what is no case, and one that lacks what the pages are made of."""
    validator = _validator()
    for path in paths:
        _read_operands(path)
        value = json.loads(path.read_text(encoding="utf-8"))
        error = next(iter(validator.iter_errors(value)), None)
        if error is not None:
            code = "missing-member" if error.validator == "required" else "wrong-type"
            raise _unfit(path, cut(f"{error.json_path}: {error.message}"), code)
        yield path, {**value, "scales": [str(scale) for scale in value["scales"]]}


def _read_operands(path: Path) -> None:
    try:
        for part in ("#P", "#Q"):
            read_operand(f"{path}{part}")
    except Refusal as refusal:
        if refusal.code != "not-a-case":
            raise
        raise _unfit(path, "this is no case (case-v1)", refusal.code) from refusal


def _validator() -> jsonschema.Draft202012Validator:
    """Of what pages are made of: a case as its schema has it, with its degeneracy and siblings. The
    reader of operands has seen to P and Q; what is not shown may be large."""
    schema = json.loads((lint.ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    schema["required"] += ["scales", "degeneracy"]
    members, parts = schema["properties"], schema["$defs"]["degeneracy"]["properties"]
    members["scales"]["minItems"] = SIBLINGS
    parts["floats"]["minItems"] = 1
    members |= dict.fromkeys(("P", "Q", "expected"), True)
    parts |= dict.fromkeys(("events", "topology"), True)
    return jsonschema.Draft202012Validator(schema)


def _pictures(path: Path, value: dict[str, Any]) -> list[Drawn]:
    try:
        for points in value["degeneracy"]["tight_passages"]:  # their numbers have a sane length
            _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": points}]}))
        return case_pictures(value)
    except (_core.BadInput, ArithmeticError) as error:
        raise _unfit(path, f"it cannot be drawn: {message_of(error)}", "not-drawable") from error


def _unfit(path: Path, what: str, code: str) -> Refusal:
    mend = "make it again with `minkref generate`, or take it out of the folder"
    return Refusal(what, str(path), mend, code)


def _row(path: Path, value: dict[str, Any]) -> Row:
    told = value["degeneracy"]
    vertices = sum(
        len(ring)
        for name in "PQ"
        for p in value[name]["polygons"]
        for ring in (p["outer"], *p.get("holes", []))
    )
    wrong = sum(not row["doubles_are_right"] for row in told["floats"])
    bits = [row["deciding_bits"] for row in told["floats"]]
    most = "over 4096" if None in bits else str(max(bits))
    counts = ", ".join(f"{c}/{h}" for c, h in told["below_at_above"])
    return Row(
        value["id"],
        str(path),
        value.get("title", ""),
        vertices,
        shown(value["scales"][0])[:40],
        counts,
        wrong,
        len(bits),
        most,
        told["why"],
    )


def _invalid(name: str) -> InvalidPage:
    family = INVALID_FAMILIES[name]
    member = invalid_member(family, 1, 0)
    text = member.content[: 2 * SAMPLE].decode("utf-8", "backslashreplace")
    sample = shown(text)[:SAMPLE] + ("..." if len(member.content) > SAMPLE else "")
    page = (lint.ROOM / "pages" / f"{name}.md").read_text(encoding="utf-8")
    why = page.partition("\n")[2].strip()
    return InvalidPage(name, family.title, why, family.code, sample, member.place)
