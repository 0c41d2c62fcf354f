"""`minkref report`: pages that work from a file, with drawings of finite coordinates."""

from __future__ import annotations

import json
import re
import shutil
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

import audit_runs
import jsonschema
import pytest
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import DISC_FAMILIES, FAMILIES, PATH_FAMILIES, SPACE_FAMILIES
from minkref.degeneracies.disc.outline import DISC
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES
from minkref.degeneracies.motion.outline import MOTION
from minkref.fuzz.space.generators.convex import box
from minkref.plane.operand import read_operand
from minkref.reports.audit.catalogue import ENTRIES
from minkref.reports.audit.entry import Drawing, Entry, Shown
from minkref.reports.bench import pairs, table1, table2
from minkref.reports.bench.cgal_space_service import NoSumError
from minkref.reports.bench.space_pairs import TimedPair
from minkref.reports.degeneracies import page as pages
from minkref.reports.paper import crossing_facets, plots, program_plots, space_times_entry
from minkref.schemas import schema
from minkref.space.operand import read_space_operand
from thoroughness import THOROUGH, draws, some

INVALID = cache(pages._invalid)


@pytest.fixture(autouse=True)
def invalid_input_made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Makes invalid input once: some files are large, and each front page shows them."""
    monkeypatch.setattr(pages, "_invalid", INVALID)


def test_a_page_for_each_family(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Takes some cases of each family; `found` has a drawing for every case."""
    most, drawn = draws(1, DISC.count + MOTION.count), draws(1, 2)
    counts: Counter[Path] = Counter()
    cases = []
    for path in pages.case_paths_of_report(lint.CORPUS):
        counts[path.parent] += 1
        if THOROUGH or path.parent.name == "found" or counts[path.parent] <= most:
            cases.append(path)
    monkeypatch.setattr(pages, "case_paths_of_report", lambda corpus: cases)
    ran = minkref("report", "degeneracies", "-o", str(tmp_path / "pages"), "--json")
    assert ran.code == 0
    front = Path(ran.json["pages"][0]).read_text(encoding="utf-8")
    assert f"{len(cases)} cases" in front
    for name in (*FAMILIES, *SPACE_FAMILIES, "found"):
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        assert f'href="{name}.html"' in front and page.count("<svg") >= 5 * drawn
        numbers = re.findall(
            r"(?<=[ML ])[^ MLZ\"]+(?=[ LZ])", "".join(re.findall(r' d="[^"]*"', page))
        )
        assert numbers and all(-1e4 < float(number) < 1e4 for number in numbers)
    for name in DISC_FAMILIES:
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        assert f'href="{name}.html"' in front and page.count("<svg") >= 3 * drawn
        assert page.count("<tr>") == min(DISC.count, most) + 1
        assert len(re.findall("A[0-9]", page)) > 3 * drawn
    for name in PATH_FAMILIES:
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        assert f'href="{name}.html"' in front and page.count("<svg") >= 3 * drawn
        assert page.count("<tr>") == min(MOTION.count, most) + 1
        numbers = re.findall(r"[ML ](-?[0-9.]+)", "".join(re.findall(r' d="[^"]*"', page)))
        assert numbers and all(-400 < float(number) < 400 for number in numbers)
    for name in INVALID_FAMILIES:
        assert f'id="{name}"' in front


def test_what_meets_is_drawn_where_the_bodies_are_degenerate_only(
    minkref: Any, tmp_path: Path
) -> None:
    """Marks facets of the sum that come from two facets, or from a facet and an edge: some at the
    scaling that makes them parallel, and none of this kind just beside. The page shows flags, and a
    row for each case."""
    names = ("facet-along-edge-at-a-scaling", "needle-and-plate")
    for name in names:
        shutil.copytree(lint.CORPUS / name, tmp_path / "cases" / name)
    words = ("--corpus", tmp_path / "cases", "-o", tmp_path / "pages")
    assert minkref("report", "degeneracies", *words).code == 0
    marked = []
    for name in names:
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        cases = lint.case_paths(lint.CORPUS / name)
        assert page.count("<tr>") == len(cases) + 1 and "index.html#facet-along-edge" in page
        figures = re.findall(r"<figure>(.*?)<figcaption>(.*?)</figcaption>", page, re.DOTALL)
        for svg, caption in figures:
            if "just" in caption:
                assert 'class="tied' not in svg
            elif caption.startswith("the sum at"):
                marked.append('class="tied' in svg)
    assert len(marked) == 4 and any(marked)


def test_what_cannot_be_reported_is_refused(minkref: Any, tmp_path: Path) -> None:
    out = str(tmp_path / "pages")
    assert minkref("report", "weather", "-o", out).code == 2
    ran = minkref("report", "degeneracies", "--corpus", str(tmp_path), "-o", out)
    assert (ran.code, "no case" in ran.err) == (2, True)
    assert not (tmp_path / "pages").exists()


Value = dict[str, Any]


def corpus_of(
    folder: Path, change: Callable[[Value], str | None], family: str = "fits-slot"
) -> Path:
    """A corpus with two cases: an original and its changed copy. Returns the copy's file."""
    whole = lint.case_paths(lint.CORPUS / family)[0].read_text(encoding="utf-8")
    value = json.loads(whole)
    text = change(value)
    where = folder / "cases" / "mine"
    where.mkdir(parents=True, exist_ok=True)
    (where / "a.json").write_text(whole, encoding="utf-8")
    (where / "b.json").write_text(text or json.dumps(value), encoding="utf-8")
    return where / "b.json"


def without(*names: str) -> Callable[[Value], None]:
    def change(value: Value) -> None:
        for name in names:
            del value[name]

    return change


def put(name: str, member: Any) -> Callable[[Value], None]:
    return lambda value: value.__setitem__(name, member)


def told(name: str, member: Any) -> Callable[[Value], None]:
    return lambda value: value["degeneracy"].__setitem__(name, member)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (lambda value: "{", "truncated"),
        (lambda value: "[]", "not-a-case"),
        (lambda value: json.dumps({"file": "x.wkt", "place": []}), "not-a-case"),
        (without("P"), "missing-member"),
        (without("degeneracy"), "missing-member"),
        (lambda value: value.__setitem__("interval", {"from": value.pop("scales")[0]}),
         "missing-member"),
        (put("scales", ["1"]), "wrong-type"),
        (told("floats", []), "wrong-type"),
        (told("why", 7), "wrong-type"),
        (told("tight_passages", [[["1e999999999", "0"]]]), "not-drawable"),
    ],
)  # fmt: skip
def test_a_case_of_which_no_page_can_be_made_is_refused(
    minkref: Any, tmp_path: Path, change: Callable[[Value], str | None], code: str
) -> None:
    """The refusal names the file, and no page is written."""
    refused(minkref, tmp_path, corpus_of(tmp_path, change), code)


def refused(minkref: Any, folder: Path, path: Path, code: str) -> None:
    words = ("--corpus", folder / "cases", "-o", folder / "pages", "--json")
    ran = minkref("report", "degeneracies", *words)
    assert (ran.code, ran.json["error"]["code"]) == (2, code)
    assert ran.json["error"]["where"].startswith(str(path)) and ran.json["error"]["mend"]
    assert not (folder / "pages").exists()


def first_coincidence(name: str, member: Any) -> Callable[[Value], None]:
    return lambda value: value["degeneracy"]["coincidences"][0].__setitem__(name, member)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (without("P"), "missing-member"),
        (without("degeneracy"), "missing-member"),
        (without("scales"), "missing-member"),
        (put("P", {"polygons": []}), "unknown-member"),
        (put("scales", ["1", "2", "3"]), "wrong-type"),
        (put("scales", [["1", "2", "3"]] * 2), "wrong-type"),
        (put("scales", [["1", "0", "3"]] * 3), "wrong-type"),
        (put("scales", [["1", "1e99999", "3"]] * 3), "limit"),
        (told("facets", []), "wrong-type"),
        (told("floats", []), "wrong-type"),
        (told("coincidences", []), "wrong-type"),
        (first_coincidence("P", [0, 1, 99]), "not-drawable"),
        (lambda value: value["Q"]["faces"].__delitem__(0), "not-closed"),
        (lambda value: value["P"]["vertices"][0].__setitem__(2, "-1/7"), "not-closed"),
    ],
)  # fmt: skip
def test_a_case_in_space_of_which_no_page_can_be_made_is_refused(
    minkref: Any, tmp_path: Path, change: Callable[[Value], str | None], code: str
) -> None:
    refused(minkref, tmp_path, corpus_of(tmp_path, change, "facets-parallel-always"), code)


def test_a_folder_may_hold_cases_in_the_plane_and_in_space(minkref: Any, tmp_path: Path) -> None:
    """Each case has a row in its kind's table, and optional parts may be missing."""
    corpus_of(tmp_path, put("scales", [[1, 1, 1], ["1/2", 1, 1], ["3/2", 1, 1]]), "with-itself")
    plane = lint.case_paths(lint.CORPUS / "fits-slot")[0]
    (tmp_path / "cases" / "mine" / "c.json").write_bytes(plane.read_bytes())
    words = ("--corpus", tmp_path / "cases", "-o", tmp_path / "pages")
    assert minkref("report", "degeneracies", *words).code == 0
    page = (tmp_path / "pages" / "mine.html").read_text(encoding="utf-8")
    assert page.count("<table>") == 2 and page.count("<tr>") == 5
    assert "the sum just above 1<" in page


def test_what_a_page_can_do_without_may_be_left_out(minkref: Any, tmp_path: Path) -> None:
    changes = (
        without("title", "tags", "flags", "expected", "source", "licence", "certificate"),
        put("flags", ["of-my-own"]),
        put("scales", [2, 1, 3]),
    )
    for number, change in enumerate(changes):
        path = corpus_of(tmp_path, change)
        path.rename(path.with_name(f"{number}.json"))
    words = ("--corpus", tmp_path / "cases", "-o", tmp_path / "new" / "pages")
    assert minkref("report", "degeneracies", *words).code == 0
    page = (tmp_path / "new" / "pages" / "mine.html").read_text(encoding="utf-8")
    assert page.count("<tr>") == 5 and "minkref generate mine" not in page


def a_file(folder: Path) -> str:
    (folder / "pages").touch()
    return str(folder / "pages")


def a_folder_for_a_page(folder: Path) -> str:
    (folder / "pages" / "index.html").mkdir(parents=True)
    return str(folder / "pages")


@pytest.mark.parametrize(
    "made", [a_file, a_folder_for_a_page, lambda folder: a_file(folder) + "/x", lambda _: "/proc/x"]
)
def test_pages_that_cannot_be_written_are_refused(minkref: Any, tmp_path: Path, made: Any) -> None:
    """The refusal precedes the first page."""
    name = made(tmp_path)
    corpus_of(tmp_path, lambda value: None)
    ran = minkref("report", "degeneracies", "--corpus", tmp_path / "cases", "-o", name, "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "cannot-write")
    assert not list(tmp_path.glob("pages/*.html/*")) and not (tmp_path / "pages/mine.html").exists()


@pytest.mark.parametrize("option", ["-o", "--corpus"])
def test_an_empty_name_is_not_the_folder_where_you_are(
    minkref: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, option: str
) -> None:
    """An empty option comes from an unset shell variable."""
    corpus_of(tmp_path, lambda value: None)
    monkeypatch.chdir(tmp_path / "cases")
    ran = minkref("report", "degeneracies", option, "")
    assert (ran.code, f"{option} ''" in ran.err) == (2, True)
    assert [path.name for path in Path.cwd().iterdir()] == ["mine"]


def test_no_family_takes_the_place_of_the_front_page(minkref: Any, tmp_path: Path) -> None:
    path = corpus_of(tmp_path, lambda value: None)
    path.parent.rename(tmp_path / "cases" / "index")
    words = ("--corpus", tmp_path / "cases", "-o", tmp_path / "pages")
    ran = minkref("report", "degeneracies", *words)
    assert (ran.code, "the front page has this name" in ran.err) == (2, True)


def without_cgal() -> NoReturn:
    raise NoSumError("it is left out")


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> None:
    """The smallest operands under the names of all, few repetitions, and of the checks of the audit
    some; a thorough run takes all as they are. tests/reports holds the checks to their words."""
    checked = some(ENTRIES, 3)

    def run(entry: Entry) -> Shown:
        if entry.name in checked:
            return audit_runs.once(tmp_path_factory, entry)
        return Shown(["It is so."], [Drawing("what is so", "<svg></svg>")])

    monkeypatch.setattr(Entry, "run", run)
    if THOROUGH:
        return
    polygon, solid = read_operand("g3"), read_space_operand("rod")
    monkeypatch.setattr(pairs, "read_operand", lambda name: replace(polygon, name=name))
    monkeypatch.setattr(table2, "read_space_operand", lambda name: replace(solid, name=name))
    monkeypatch.setattr(table2, "CgalSpaceService", without_cgal)  # tests of `bench` have it
    boxes = TimedPair("boxes", lambda: (box((0, 0, 0), (3, 2, 1)), box((-1, -1, -1), (1, 1, 2))))
    monkeypatch.setattr(crossing_facets, "QUICK_PAIR", boxes)
    for module in (plots, program_plots, space_times_entry):  # which tests/reports draws
        monkeypatch.setattr(module, "svg_element", lambda figure: "<svg></svg>")
    for module in (table1, table2):
        monkeypatch.setattr(module, "QUICK_COUNT", 2)
        monkeypatch.setattr(module, "PASSES", 1)


def test_both_reports_by_one_command(minkref: Any, tmp_path: Path, small: None) -> None:
    ran = minkref("report", "audit", "paper", "--quick", "-o", str(tmp_path), "--json")
    assert ran.code == 0
    jsonschema.validate(ran.json, schema("report"))
    audit, paper = (Path(page).read_text(encoding="utf-8") for page in ran.json["pages"])
    assert all(f'id="{name}"' in audit for name in ENTRIES)
    for page in (audit, paper):
        assert "http://" not in re.sub(r"http://www\.w3\.org/[^\"]*", "", page)
        assert "https://" not in page and "<script" not in page
        assert page.count("<svg") >= 7
    for name in re.findall(r'href="([a-z0-9]+\.(?:csv|json))"', paper):
        assert (tmp_path / name).stat().st_size > 50
    rows = json.loads((tmp_path / "audit.json").read_text(encoding="utf-8"))
    assert {row["outcome"] for row in rows} <= {"passed", "left out"}
    assert len(json.loads((tmp_path / "table1.json").read_text(encoding="utf-8"))["rows"]) == 25


def test_unknown_reports_are_refused(minkref: Any, tmp_path: Path) -> None:
    ran = minkref("report", "audit", "weather", "-o", str(tmp_path / "pages"))
    assert (ran.code, (tmp_path / "pages").exists()) == (2, False)
