"""Foreign texts, such as names, versions, messages and logs of targets, case names and case file
titles, stay text in every report: no markup, no link, nothing that a terminal obeys."""

from __future__ import annotations

import json
import os
import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from markdown_it import MarkdownIt
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.runner import Cell, Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.groups import groups_of
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from minkref.reports.conformance.bug_report import bug_report
from minkref.reports.conformance.case_view import case_views
from minkref.reports.conformance.junit import junit
from minkref.reports.conformance.markdown import markdown
from minkref.reports.conformance.markdown_text import plain
from minkref.reports.conformance.page import write_report as write_pages
from minkref.reports.conformance.sarif import place, sarif
from minkref.verbs.verify_output import print_tables

NASTY = (
    "<script>alert(1)</script> [a](javascript:b) ![c](d) *e* _f_ __g__ ~~h~~ `i` | # j --> ]]> "
    "https://k.example www.l.example @m <img src=x onerror=n> \x1b[31m\x9b31m\x07\x00\u202eo"
    "\u2066\n# p"
)
OBEYED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
READ = {"text", "softbreak", "code_inline"}


def markup(text: str) -> set[str]:
    """The kinds of inline marks used by a text."""
    parser = MarkdownIt("commonmark").enable(["table", "strikethrough"])
    found = {token.type for token in parser.parse(text) if token.type.startswith("html")}
    for token in parser.parse(text):
        for child in token.children or []:
            if child.type == "html_inline" and child.content == "<br>":
                continue  # ours
            found.add(child.type)
    return found - READ


@pytest.fixture
def hostile(made: Any, finding: Any) -> Any:
    """A target, a family, a skip, a message, a log, and the name of a case, all of them nasty."""
    text = json.dumps({"P": {"polygons": [{"outer": [[0, 0], [1, 0], [0, 1]]}]},
                       "Q": {"polygons": [{"outer": [[0, 0], [1, 0], [0, 1]]}]}})  # fmt: skip
    case = finding(text, NASTY).case
    named = CaseResult(0, CaseName(NASTY, NASTY), "1", [], NASTY, NASTY, case.size)
    named.P, named.Q, named.family = case.P, case.Q, NASTY
    outcome = Outcome(NASTY, Verdict.ERRORED, message=NASTY, log=NASTY)
    made.run.findings.append(Finding(outcome, named))
    made.run.targets.append(NASTY)
    made.run.groups.append(NASTY)
    made.run.cases[NASTY] = 2
    cell = Cell(Counter({"errored": 1, "skipped": 1}), Counter({NASTY: 1}))
    made.run.matrix[(NASTY, NASTY)] = cell
    made.groups[:] = groups_of(made.run)
    made.value["notes"].append(NASTY)
    made.value["absent"].append({"name": NASTY, "reason": NASTY})
    for row in made.value["targets"]:
        row["version"] = NASTY
    return made


def test_markdown(hostile: Any) -> None:
    text = markdown(hostile.run, hostile.groups, hostile.value)
    assert markup(text) == set()
    assert not OBEYED.search(text)
    blocks = [line for line in text.splitlines() if line.startswith("#")]
    assert len(blocks) == 1 + len(hostile.groups)
    for line in text.splitlines():
        if not line.startswith("    "):  # a block of code
            assert not re.search(r"(?<!\w)@\w|https?://|www\.", line), line


def test_one_line_of_markdown() -> None:
    parser = MarkdownIt("commonmark").enable("strikethrough")
    shown = NASTY.encode("unicode_escape").decode()
    tokens = parser.parseInline(plain(NASTY))[0].children or []
    assert {token.type for token in tokens} == {"text"}
    said = "".join(token.content for token in tokens)
    assert said.replace("\\\\", "\\") == shown.replace("\\\\", "\\")


def test_bug_reports(hostile: Any) -> None:
    group = next(g for g in hostile.groups if g.example.outcome.target == NASTY)
    for view in case_views(group, "it", boundary=False):
        text = bug_report(view, NASTY, [NASTY])
        assert markup(text) == set()
        assert not OBEYED.search(text)


def test_junit(hostile: Any) -> None:
    text = junit(hostile.run, hostile.groups)
    assert not OBEYED.search(text)
    assert {element.tag for element in ElementTree.fromstring(text).iter()} <= {
        *("testsuites", "testsuite", "testcase", "failure", "error", "skipped", "system-out"),
        *("properties", "property"),
    }


def test_sarif(hostile: Any) -> None:
    results = json.loads(sarif(hostile.groups, hostile.value))["runs"][0]["results"]
    for result in results:
        assert not OBEYED.search(result["message"]["text"])
        assert "](" not in result["message"]["text"], "a link"
        for location in result["locations"]:
            assert re.fullmatch(
                r"[\w%./~-]+", location["physicalLocation"]["artifactLocation"]["uri"]
            )


def test_pages(hostile: Any, tmp_path: Path) -> None:
    write_pages(tmp_path, hostile.run, hostile.groups, hostile.value)
    pages = sorted(tmp_path.glob("*.html"))
    assert len(pages) > 5
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert "<script>alert" not in text and "<img" not in text, page.name
        found = OBEYED.search(text)
        assert found is None, (page.name, text[found.start() - 90 : found.end() + 9])


def test_terminal(hostile: Any, capsys: pytest.CaptureFixture[str]) -> None:
    hostile.value.update(report=NASTY, peak_bytes=1)
    print_tables(hostile.run, hostile.groups, hostile.value)
    assert not OBEYED.search(capsys.readouterr().out)


@pytest.mark.parametrize("name", ["a" * 5000, "a\0b", "b\udcff.py", "\ud800"])
def test_sarif_names_a_place_for_every_target(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / os.fsdecode(b"b\xff.py")).touch()
    for target in (name, f"cmd:./{name}", f"py:{name}:f", f"so:{name}:f"):
        assert re.fullmatch(r"[\w%./~-]+", place(target))
    assert place("b\udcff.py") == "b%FF.py"


def test_titles_of_case_files(minkref_report: Any, tmp_path: Path) -> None:
    corpus = Path(__file__).parents[2] / "degeneracies" / "corpus" / "found"
    path = next(path for path in sorted(corpus.glob("*.json")) if "cert" not in path.name)
    value = json.loads(path.read_text(encoding="utf-8"))
    value["title"] = NASTY
    (tmp_path / "cases" / "found").mkdir(parents=True)
    (tmp_path / "cases" / "found" / path.name).write_text(json.dumps(value), encoding="utf-8")
    front = minkref_report(tmp_path / "pages", tmp_path / "cases")
    for page in front.parent.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert "<script" not in text and "<img" not in text and not OBEYED.search(text)
    assert "&lt;script&gt;alert(1)" in (front.parent / "found.html").read_text(encoding="utf-8")


@pytest.fixture
def minkref_report() -> Any:
    from minkref.reports.degeneracies.page import write_report

    return write_report
