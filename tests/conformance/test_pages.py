"""The pages of a report: complete, escaped, linked, without anything from outside."""

from __future__ import annotations

import re
from copy import deepcopy
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.verdicts.verdict import Reason, Verdict
from minkref.reports import conformance
from minkref.reports.conformance.counts import total
from minkref.reports.conformance.finding_page import file_names
from minkref.reports.conformance.page import write_report

AGAIN = "minkref verify 'py:<x>' --pairs 10"
VOID = {"meta", "br", "link", "img", "input"}


class Page(HTMLParser):
    """Tags, links, anchors and text; fails on a tag that is not closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.links: list[str] = []
        self.anchors: list[str] = []
        self.sources: list[str] = []
        self.open: list[str] = []
        self.text = ""
        self.scripts: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        if tag not in VOID:
            self.open.append(tag)
        for name, value in attributes:
            assert not name.startswith("on"), name
            if name == "href":
                self.links.append(value or "")
            if name in ("src", "srcset", "data", "xlink:href", "action"):
                self.sources.append(value or "")
            if name == "id":
                self.anchors.append(value or "")

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] == "script":
            self.scripts.append(data)
        else:
            self.text += data


@pytest.fixture(scope="module")
def folder(made_once: Any, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report, which tests read only."""
    folder, made = tmp_path_factory.mktemp("report"), deepcopy(made_once)
    front = write_report(folder, made.run, made.groups, made.value, again=AGAIN)
    assert front == folder / "index.html"
    return folder


@pytest.fixture(scope="module")
def pages(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.html")}


def test_there_is_a_page_for_each_target_and_each_kind(pages: dict[str, str], made: Any) -> None:
    assert {"index.html", "report.html"} <= set(pages)
    assert sum(name.startswith("target-") for name in pages) == len(made.run.targets)
    assert sum(name.startswith("finding-") for name in pages) == len(made.groups) == 5


def test_nothing_comes_from_outside_and_nothing_runs_but_the_copying_of_commands(
    pages: dict[str, str],
) -> None:
    copying = (Path(conformance.__file__).parent / "templates" / "copy.js").read_text("utf-8")
    for text in pages.values():
        page = Page(text)
        assert [script.strip() for script in page.scripts] == [copying.strip()]
        assert not page.tags & {"iframe", "object", "link", "img", "form", "base"}
        assert page.sources == []
        assert not any("//" in link or link.startswith("javascript") for link in page.links)
        assert "@import" not in text
        assert not re.search(r"url\((?!#)", text)
        control = re.search("[\x00-\x08\x0b-\x1f\x7f]", text)
        assert control is None, text[control.start() - 80 : control.end()]


def test_every_link_leads_somewhere(pages: dict[str, str], folder: Path) -> None:
    for name, text in pages.items():
        page = Page(text)
        assert len(page.anchors) == len(set(page.anchors)), name
        for link in page.links:
            file, _, anchor = link.partition("#")
            assert not file or (folder / file).is_file(), (name, link)
            if anchor:
                assert anchor in (Page(pages[file]) if file else page).anchors, (name, link)


def test_the_one_file_needs_no_other(pages: dict[str, str], made: Any) -> None:
    page = Page(pages["report.html"])
    assert all(link.startswith("#") for link in page.links)
    for name in pages:
        if name.startswith(("target-", "finding-")):
            assert name.removesuffix(".html") in page.anchors
    for group in made.groups:
        for text in (group.example.outcome.kinds[0], "witness", "To reproduce"):
            assert text in page.text


def test_texts_of_others_are_shown_as_texts(pages: dict[str, str]) -> None:
    text = Page(pages["index.html"]).text
    assert "py:<script>alert('x')</script>:f\\x1b[31m\\x00" in text
    for part in (AGAIN, "not <installed>", "a note & <more>", "1.0 <v>"):
        assert part in text
    (crash,) = (Page(page).text for name, page in pages.items() if "crashed" in name)
    for part in ("<script>boo</script>\\x07 & more", "SIGSEGV", "</pre><script>log</script>"):
        assert part in crash


def test_head_tells_what_was_run(pages: dict[str, str]) -> None:
    text = Page(pages["index.html"]).text
    for part in (
        "minkref 0.1.0, seed 7, 12.2 s, 10 cases, 6 targets",
        "Something is proven wrong.",
        "of the boundaries",
        "1/1000",
        "2 derived cases do not exist",
    ):
        assert part in text
    assert text.index("pysfcgal: hole-lost") < text.index("cgal-reduced: hole-lost")


def test_skipped_cases_are_in_no_denominator(pages: dict[str, str], made: Any) -> None:
    run = made.run
    counts = total([(run.matrix[("minkref:paper", "holes")], 9)])
    assert (counts.fraction, counts.within, counts.skipped, counts.not_asked) == ("7/7", 2, 2, 0)
    assert counts.why_skipped == [("does not declare <space>", 2)]
    wrong = total([(run.matrix[("pysfcgal", "holes")], 9)])
    assert (wrong.fraction, wrong.skipped, wrong.not_asked) == ("3/7", 1, 1)
    assert (wrong.worst, wrong.amiss[0][:2]) == ("wrong", ("wrong", 4))
    assert total([(None, 9)]).fraction == "–"
    known = total([(run.matrix[("cgal-reduced", "named")], 1)])
    assert (known.fraction, known.worst) == ("0/1", "known")
    text = Page(pages["target-pysfcgal.html"]).text
    assert "3/8" in text  # of both families
    assert "does not declare <space>" in Page(pages["target-minkref-paper.html"]).text


def test_a_finding_in_the_plane_is_drawn_and_argued(pages: dict[str, str], folder: Path) -> None:
    html = pages["finding-pysfcgal-hole-lost.html"]
    text = Page(html).text
    for part in ('class="first"', 'class="extra"', 'class="witness"', 'class="got"'):
        assert part in html
    for part in (
        "Shrunk to 9 vertices in 7 calls; it does not show every time",
        "sP lies strictly inside the hole",
        "hole (4, 2) (1, 1) (1, 3)",
        "digest expected: " + "2" * 64,
        "minkref verify pysfcgal --case",
        "## Why the expected is right",
    ):
        assert part in text
    program = (folder / "pysfcgal-hole-lost.py").read_text(encoding="utf-8")
    assert "minkref" not in program.split('"""')[2]
    assert program in text


def test_a_finding_in_space_has_tables_and_faces(pages: dict[str, str]) -> None:
    html = pages["finding-manifold3d-extra.html"]
    text = Page(html).text
    assert html.count("shade") > 4
    for part in ("P: vertices and faces", "They do not meet: sP has 0 <= x <= 2", "scale: 2,3/2,1"):
        assert part in text


def test_tolerance_and_sum_of_boundaries_are_told(pages: dict[str, str]) -> None:
    html = pages["finding-clipper2-missing.html"]
    text = Page(html).text
    assert 'class="square"' in html
    for part in (
        "the sum of the boundaries",
        "differs from x by at most 1/1000",
        "So x lies in the sum of the boundaries, by its definition.",
    ):
        assert part in text


def test_what_is_known_names_the_reason(pages: dict[str, str]) -> None:
    text = Page(pages["finding-cgal-reduced-hole-lost.html"]).text
    assert "The baseline: CGAL issue 5830 <b>" in text
    assert "minkowski_sum_by_reduced_convolution_2" in text


def test_an_adapter_is_its_own_program(pages: dict[str, str]) -> None:
    (crash,) = (Page(page).text for name, page in pages.items() if "crashed" in name)
    assert "the adapter or function is itself the program" in crash


def test_names_of_files_differ() -> None:
    names = file_names(["a/b", "a:b", "A b", "...", "x" * 500, "x" * 501, "../../etc"])
    assert len({name.lower() for name in names}) == 7
    assert all(re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9.-]*", name) for name in names)
    assert max(len(name) for name in names) < 70


def test_a_run_without_findings_says_so(made: Any, tmp_path: Path) -> None:
    made.run.findings.clear()
    made.value["exit_code"] = 0
    write_report(tmp_path, made.run, [], made.value)
    assert "there are no findings" in (tmp_path / "index.html").read_text(encoding="utf-8")


def test_operands_that_are_none_do_not_stop_the_report(made: Any, tmp_path: Path) -> None:
    group = next(g for g in made.groups if g.example.outcome.target == "cgal-reduced")
    group.example.case.P = '{"polygons":[{"outer":[["0","0"]],"holes":[[["x","0"]]]}]}'
    group.example.case.expected = None
    write_report(tmp_path, made.run, made.groups, made.value)
    html = (tmp_path / "finding-cgal-reduced-hole-lost.html").read_text(encoding="utf-8")
    assert "Not all of it is drawn" in html


def test_of_invalid_operands_no_sum_is_claimed(made: Any, tmp_path: Path) -> None:
    group = next(g for g in made.groups if g.example.outcome.target == "cgal-reduced")
    old = group.example
    outcome = replace(
        old.outcome, reasons=(Reason.ACCEPTED_INVALID,), verdict=Verdict.WRONG, message="Q: crossed"
    )
    group.example = Finding(outcome, old.case)
    write_report(tmp_path, made.run, made.groups, made.value)
    html = (tmp_path / "finding-cgal-reduced-accepted-invalid.html").read_text(encoding="utf-8")
    text = Page(html).text
    assert "An operand is invalid (Q: crossed), at (11/5, 5/2)" in text
    assert "sum does not have the point" not in text
    assert "in truth" not in text
