"""The audit: the check behind every entry, and the pages made from the entries."""

from __future__ import annotations

import re
from pathlib import Path

import audit_runs
import pytest
import sympy
from minkref.reports.audit import docs
from minkref.reports.audit.catalogue import CHAPTERS, ENTRIES
from minkref.reports.audit.chapters import section_4
from minkref.reports.audit.entry import (
    GRAVEST,
    Chapter,
    CheckFailed,
    Entry,
    Shown,
    Status,
    counted,
    formulas,
    status_of,
)
from minkref.reports.audit.page import ROOT, outcome
from minkref.reports.typeset import typeset_line
from thoroughness import THOROUGH

LEAST = 40  # entries
PAGES = sorted(docs.FOLDER.glob("*.md"))


SHARE = "share-of-right-intervals"  # tried on smaller models below
#: Checks that take long, and for each one about the same that is taken always.
LONG = {
    SHARE: "interval-of-a-pair",
    "contacts-of-facets": "four-facets",
    "overdetermined-in-space": "overdetermined",
    "singular-systems": "edge-events",
    "theorem-1-edge-errors": "theorem-1-one-kind",
    "largest-valid-scale": "trapping-scale",
    "path-events": "trapping-scale",
    "faster-than-winding": "fewer-primitives",
    "events-outstrip-intersections": "figure-8-axis",
    "collision-detection-in-space": "no-collision-detection",
}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.thorough if n in LONG else ()) for n in ENTRIES]
)
def test_the_check_of_an_entry_passes(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    shown = audit_runs.once(tmp_path_factory, ENTRIES[name])
    assert shown.facts
    assert all(fact.endswith(".") for fact in shown.facts)
    assert all(drawing.svg.startswith("<svg") for drawing in shown.drawings)


def test_the_long_check_passes_on_smaller_models(monkeypatch: pytest.MonkeyPatch) -> None:
    smaller = {"disc1": "disc1", "neuron": "g1", "monkey": "g2", "bird": "g4"}
    monkeypatch.setattr(section_4, "or_look_alike", lambda name, models: smaller[name])
    facts = ENTRIES[SHARE].run().facts
    assert {*LONG, *LONG.values()} <= {*ENTRIES}
    assert [fact.partition(":")[0] for fact in facts] == ["Disc1 and g1", "G2 and g4"]


def test_entries_say_where_what_and_how() -> None:
    assert len(ENTRIES) == sum(len(chapter.entries) for chapter in CHAPTERS) >= LEAST
    for entry in ENTRIES.values():
        assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", entry.name)
        assert entry.title and entry.place and entry.printed and entry.right and len(entry.how) > 20
        assert all((ROOT / path).is_file() for path in entry.code), entry.name
    assert {entry.status for entry in ENTRIES.values()} == set(Status)


def test_what_is_false_as_read_literally_has_a_reading_and_what_is_false_has_none() -> None:
    for entry in ENTRIES.values():
        assert bool(entry.reading) == (entry.status == Status.LITERAL), entry.name


def test_formulas_are_counted_once() -> None:
    groups = formulas(ENTRIES.values())
    assert sum(counted(ENTRIES.values()).values()) == len(groups) < len(ENTRIES)
    assert sum(map(len, groups.values())) == len(ENTRIES)
    shared = [group for group in groups.values() if len(group) > 1]
    assert max(map(len, shared)) == 5
    assert sorted(GRAVEST) == sorted(Status)
    for group in shared:
        assert status_of(group) in {entry.status for entry in group}


def test_of_entries_about_one_formula_the_gravest_counts() -> None:
    chapter = Chapter("none", "none")
    for name, status, formula in (
        ("one", Status.HOLDS, "f"), ("two", Status.FALSE, "f"), ("three", Status.HOLDS, ""),
    ):  # fmt: skip
        chapter.entry(name, name, place="p", status=status, printed="a", right="b",
                      formula=formula)(lambda shown: None)  # fmt: skip
    assert counted(chapter.entries) == {Status.HOLDS: 1, Status.FALSE: 1}
    assert list(formulas(chapter.entries)) == ["f", "three"]


def test_all_formulas_are_typeset() -> None:
    for entry in ENTRIES.values():
        for text in (entry.printed, entry.right, entry.reading, entry.how):
            html = typeset_line(text)
            assert "$" not in html and html.count("<math") == text.count("$") / 2, entry.name
            assert "\\" not in re.sub(r"<[^>]*>", "", html), entry.name


def test_the_pages_of_docs_are_what_the_entries_say(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`python -m minkref.reports.audit.docs` writes the pages again. A run that is not thorough
    copies results of long checks from the pages."""

    def run(entry: Entry) -> Shown:
        if THOROUGH or entry.name not in LONG:
            return audit_runs.once(tmp_path_factory, entry)
        text = next(t for t in map(Path.read_text, PAGES) if f'<a id="{entry.name}">' in t)
        part = text.partition(f'<a id="{entry.name}">')[2].partition("\n## ")[0]
        return Shown(re.findall(r"^- (.*)$", part, re.MULTILINE))

    monkeypatch.setattr(Entry, "run", run)
    made = docs.pages()
    assert {path.name for path in PAGES} == set(made)
    for name, text in made.items():
        assert (docs.FOLDER / name).read_text(encoding="utf-8") == text, name


def test_a_check_that_finds_something_else_fails_and_says_what() -> None:
    chapter = Chapter("none", "none")

    @chapter.entry("wrong", "t", place="p", status=Status.FALSE, printed="a", right="b")
    def _(shown: Shown) -> None:
        """It cannot hold."""
        shown.equal("one and one", 1 + 1, 3)

    found = outcome(chapter.entries[0], quick=False)
    assert (found.word, found.failure) == ("failed", "one and one: 2, not 3")
    for attempt in (
        lambda shown: shown.identity("x", sympy.Symbol("x")),
        lambda shown: shown.different("x", 1, 1),
        lambda shown: shown.true("x", False),
    ):
        with pytest.raises(CheckFailed):
            attempt(Shown())
