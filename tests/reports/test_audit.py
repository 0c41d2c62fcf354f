"""The audit: the check behind every entry, and the pages that are made of them."""

from __future__ import annotations

import re

import audit_runs
import pytest
import sympy
from minkref.reports.audit import docs
from minkref.reports.audit.catalogue import CHAPTERS, ENTRIES
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

LEAST = 40  # entries


@pytest.mark.parametrize("name", ENTRIES)
def test_the_check_of_an_entry_passes(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    shown = audit_runs.once(tmp_path_factory, ENTRIES[name])
    assert shown.facts
    assert all(fact.endswith(".") for fact in shown.facts)
    assert all(drawing.svg.startswith("<svg") for drawing in shown.drawings)


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
    """`python -m minkref.reports.audit.docs` writes them again."""
    monkeypatch.setattr(Entry, "run", lambda entry: audit_runs.once(tmp_path_factory, entry))
    made = docs.pages()
    assert {path.name for path in docs.FOLDER.glob("*.md")} == set(made)
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
