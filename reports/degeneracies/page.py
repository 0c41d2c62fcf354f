"""The pages: an index, and one for each family."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.degeneracies import found, lint
from minkref.degeneracies.catalogue import GROUP_OF, OUTLINES
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, invalid_member
from minkref.degeneracies.outline import CORPUS, Outline
from minkref.degeneracies.plane.flags import explained
from minkref.errors import Refusal, message_of
from minkref.fuzz.space.case_file import is_in_space
from minkref.output.documents import check_writable, write_together
from minkref.output.output_folder import make_folder
from minkref.output.terminal import escaped
from minkref.reports.degeneracies.cases import cases_in, cases_of_schema, space_case, unfit
from minkref.reports.degeneracies.disc.cases import DiscRow, disc_case_pictures, disc_row
from minkref.reports.degeneracies.motion.cases import PathRow, path_case_pictures, path_row
from minkref.reports.degeneracies.pictures import Drawn, case_pictures
from minkref.reports.degeneracies.space.solid_pictures import solid_pictures
from minkref.reports.degeneracies.space.solid_row import SolidRow, solid_row
from minkref.reports.degeneracies.space.space_pictures import space_case_pictures
from minkref.reports.degeneracies.unions.cases import UnionRow, union_case_pictures, union_row
from minkref.reports.pages import environment
from minkref.space.scaling import read_scaling, text_of

INDEX = "index"
DRAWN = 2  # cases of a family
SAMPLE = 300  # shown characters of an invalid file


@dataclass(frozen=True)
class Row:
    """A case's row in the family's table."""

    id: str
    file: str
    title: str
    vertices: int
    scale: str
    counts: str
    wrong: int  # scales, out of `scales`, where doubles go wrong
    scales: int
    bits: str
    why: str


@dataclass(frozen=True)
class SpaceRow:
    """The row of a case in space, in the family's table. `kinds`: counts of the sum's facets, at
    the first scaling, that come from two facets, a facet and an edge, a facet and a vertex, two
    edges."""

    id: str
    file: str
    title: str
    vertices: int
    scale: str
    kinds: str
    parallel_edges: int
    signs: str
    wrong: int  # scalings, out of `scales`, with some wrong sign in doubles
    scales: int
    why: str


AnyRow = Row | SpaceRow | SolidRow | DiscRow | PathRow | UnionRow
# Settings whose cases have a schema of their own: the row and the pictures of a case.
SHOWN: dict[str, tuple[Callable[..., AnyRow], Callable[..., list[Drawn]]]] = {
    "disc-case-v1": (disc_row, disc_case_pictures),
    "path-case-v1": (path_row, path_case_pictures),
    "union-case-v1": (union_row, union_case_pictures),
}


@dataclass(frozen=True)
class FamilyPage:
    name: str
    title: str
    why: str
    flags: list[tuple[str, dict[str, Any] | None]]  # None: no explanation
    rows: list[AnyRow]
    drawings: list[tuple[AnyRow, list[Drawn]]]

    @property
    def in_the_plane(self) -> list[Row]:
        return [row for row in self.rows if isinstance(row, Row)]

    @property
    def in_space(self) -> list[SpaceRow]:
        return [row for row in self.rows if isinstance(row, SpaceRow)]

    @property
    def of_solids(self) -> list[SolidRow]:
        return [row for row in self.rows if isinstance(row, SolidRow)]

    @property
    def with_disc(self) -> list[DiscRow]:
        return [row for row in self.rows if isinstance(row, DiscRow)]

    @property
    def of_paths(self) -> list[PathRow]:
        return [row for row in self.rows if isinstance(row, PathRow)]

    @property
    def of_unions(self) -> list[UnionRow]:
        return [row for row in self.rows if isinstance(row, UnionRow)]

    @property
    def is_generated(self) -> bool:
        return _outline(self.name) is not None

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
    """Writes `index.html`, and `FAMILY.html` for each of the corpus's families: each folder with
    cases. Returns the index. `reading` hears the family of each case. Refuses a corpus with a case
    that the pages cannot show, and then writes nothing."""
    by_family: dict[str, list[Path]] = {}
    paths = case_paths_of_report(corpus)
    for path in paths:
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
    write_together({folder / name: text for name, text in files.items()})
    return folder / f"{INDEX}.html"


def case_paths_of_report(corpus: Path) -> list[Path]:
    """A folder's cases; for the case-v1 corpus also the cases of the settings which have separate
    folders."""
    own = [outline.corpus for outline in OUTLINES] if corpus == CORPUS else []
    return [path for folder in dict.fromkeys([corpus, *own]) for path in lint.case_paths(folder)]


def _outline(name: str) -> Outline | None:
    """The setting of a family."""
    group = GROUP_OF.get(name)
    return group if isinstance(group, Outline) else None


def _family(name: str, paths: list[Path], reading: Callable[[str], None]) -> FamilyPage:
    title, why, drawn = f"cases of the folder {name}", "", DRAWN
    outline = _outline(name)
    schema = "" if outline is None else outline.case.schema
    if outline is not None:
        title, why = outline.families[name].title, outline.families[name].why
    elif name == found.NAME:
        title = "cases on which libraries were found wrong"
        why = "Found by verification and shrunk, or published; each with its story."
        drawn = len(paths)
    cases = cases_of_schema(paths, schema) if schema in SHOWN else cases_in(paths)
    row, pictures = SHOWN.get(schema, (_row_of, _pictures))
    rows: list[AnyRow] = []
    drawings: list[tuple[AnyRow, list[Drawn]]] = []
    used: set[str] = set()
    for path, value in cases:
        reading(name)
        rows.append(row(path, value))
        used |= set(value.get("flags", []))
        if len(drawings) < drawn:
            drawings.append((rows[-1], pictures(path, value)))
    known = explained()
    flags = [(flag, known.get(flag)) for flag in sorted(used)]
    return FamilyPage(name, title, why, flags, rows, drawings)


def _pictures(path: Path, value: dict[str, Any]) -> list[Drawn]:
    try:
        if is_in_space(value):
            case = space_case(path)
            if "ties" in value["degeneracy"]:
                return solid_pictures(case.pair.P, case.pair.Q)
            return space_case_pictures(case.pair.P, case.pair.Q, value)
        for points in value["degeneracy"]["tight_passages"]:  # their numbers have a sane length
            _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": points}]}))
        return case_pictures(value)
    except (_core.BadInput, ArithmeticError, IndexError) as error:
        raise unfit(path, f"it cannot be drawn: {message_of(error)}", "not-drawable") from error


def _row_of(path: Path, value: dict[str, Any]) -> AnyRow:
    if not is_in_space(value):
        return _row(path, value)
    return (solid_row if "ties" in value["degeneracy"] else _space_row)(path, value)


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
        escaped(value["scales"][0])[:40],
        counts,
        wrong,
        len(bits),
        most,
        told["why"],
    )


def _space_row(path: Path, value: dict[str, Any]) -> SpaceRow:
    told = value["degeneracy"]
    at, floats = told["facets"][0], told["floats"]
    kinds = ("facet_and_facet", "facet_and_edge", "facet_and_vertex", "edge_and_edge")
    return SpaceRow(
        value["id"],
        str(path),
        value.get("title", ""),
        sum(len(value[name]["vertices"]) for name in "PQ"),
        escaped(text_of(read_scaling(value["scales"][0]))),
        "/".join(str(at[kind]) for kind in kinds),
        at["parallel_edges"],
        f"{floats[0]['wrong_in_doubles']} of {floats[0]['signs']}",
        sum(row["wrong_in_doubles"] > 0 for row in floats),
        len(floats),
        told["why"],
    )


def _invalid(name: str) -> InvalidPage:
    family = INVALID_FAMILIES[name]
    member = invalid_member(family, 1, 0)
    text = member.content[: 2 * SAMPLE].decode("utf-8", "backslashreplace")
    sample = escaped(text)[:SAMPLE] + ("..." if len(member.content) > SAMPLE else "")
    page = (lint.ROOM / "pages" / f"{name}.md").read_text(encoding="utf-8")
    why = page.partition("\n")[2].strip()
    return InvalidPage(name, family.title, why, family.code, sample, member.place)
