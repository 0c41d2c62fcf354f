"""The pages: an index, and one for each family."""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, invalid_member
from minkref.documents import write_atomically
from minkref.reports.degeneracies.pictures import Drawn, case_pictures
from minkref.terminal import shown

DRAWN = 2  # cases of a family
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
    wrong: str
    bits: str
    why: str


@dataclass(frozen=True)
class FamilyPage:
    name: str
    title: str
    why: str
    flags: list[tuple[str, dict[str, Any]]]
    rows: list[Row]
    drawings: list[tuple[Row, list[Drawn]]]


@dataclass(frozen=True)
class InvalidPage:
    name: str
    title: str
    why: str
    code: str
    sample: str
    place: tuple[str, ...]


def write_report(folder: Path, corpus: Path) -> Path:
    """Writes `index.html`, and `FAMILY.html` for each family of a corpus. Returns the index."""
    by_family: dict[str, list[Path]] = {}
    for path in lint.case_paths(corpus):
        by_family.setdefault(path.parent.name, []).append(path)
    pages = [_family(name, paths) for name, paths in sorted(by_family.items())]
    invalid = [_invalid(name) for name in INVALID_FAMILIES]
    environment = _environment()
    files = {
        f"{page.name}.html": environment.get_template("family.html.j2").render(page=page)
        for page in pages
    }
    index = environment.get_template("index.html.j2")
    files["index.html"] = index.render(pages=pages, invalid=invalid, flags=lint.flags())
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        write_atomically(folder / name, text)
    return folder / "index.html"


def _family(name: str, paths: list[Path]) -> FamilyPage:
    values = [json.loads(path.read_text(encoding="utf-8")) for path in paths]
    rows = [_row(path, value) for path, value in zip(paths, values, strict=True)]
    known = lint.flags()
    used = sorted({flag for value in values for flag in value["flags"]})
    drawn = len(rows) if name not in FAMILIES else DRAWN
    if name in FAMILIES:
        title, why = FAMILIES[name].title, FAMILIES[name].why
    else:
        title = "cases on which libraries were found wrong"
        why = "Found by verification and shrunk, or published; each with its story."
    return FamilyPage(
        name,
        title,
        why,
        [(flag, known[flag]) for flag in used],
        rows,
        [
            (row, case_pictures(value))
            for row, value in list(zip(rows, values, strict=True))[:drawn]
        ],
    )


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
    return Row(value["id"], str(path), value["title"], vertices, shown(value["scales"][0])[:40],
               counts, f"{wrong} of {len(bits)}", most, told["why"])  # fmt: skip


def _invalid(name: str) -> InvalidPage:
    family = INVALID_FAMILIES[name]
    member = invalid_member(family, 1, 0)
    text = member.content[: 2 * SAMPLE].decode("utf-8", "backslashreplace")
    sample = shown(text)[:SAMPLE] + ("..." if len(member.content) > SAMPLE else "")
    page = (lint.ROOM / "pages" / f"{name}.md").read_text(encoding="utf-8")
    why = page.partition("\n")[2].strip()
    return InvalidPage(name, family.title, why, family.code, sample, member.place)


def _environment() -> Environment:
    folders = [
        resources.files("minkref.reports.degeneracies") / "templates",
        resources.files("minkref.reports.conformance") / "templates",
    ]

    def load(name: str) -> str | None:
        files = [folder / name for folder in folders]
        return next((f.read_text(encoding="utf-8") for f in files if f.is_file()), None)

    environment = Environment(
        loader=FunctionLoader(load), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip
    environment.filters["drawn"] = lambda picture: Markup(picture)
    return environment
