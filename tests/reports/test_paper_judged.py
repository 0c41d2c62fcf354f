"""The entries about the paper's programs beside CGAL and computer algebra: data, claims, plots."""

from __future__ import annotations

import pytest
from minkref.fuzz.judges.beside import AGREE, GAVE_UP, OURS, THEIRS
from minkref.fuzz.judges.plane.paper_algebra import INVENTED, MISPLACED, MISSED, RIGHT
from minkref.reports.paper.docs import PAGE
from minkref.reports.paper.entry import Verdict
from minkref.reports.paper.judged_docs import written
from minkref.reports.paper.judged_entry import events_entry, sums_entry
from minkref.reports.paper.judged_runs import (
    EVENTS,
    SOLIDS,
    SUMS,
    Judged,
    Row,
    as_text,
    kept,
    read,
    share,
    together,
)

CORRECTED = "update, all corrected"
LEAST = {CORRECTED: {"53 bits": 5, "200 bits": 2, "no tried precision": 3}}


def sums(wrong: int) -> Judged:
    rows = (
        Row(CORRECTED, "rational", "cgal-reduced", {AGREE: 9, THEIRS: 1}),
        Row(CORRECTED, "mpfr:200", "cgal-reduced", {AGREE: 9, OURS: wrong}),
        Row(CORRECTED, "mpfr:53", "cgal-reduced", {AGREE: 6, OURS: 2, GAVE_UP: 2}),
    )
    return Judged("2026-01-02", 10, rows, LEAST)


def events() -> Judged:
    counts = {RIGHT: 6, MISSED: 3, MISPLACED: 1, INVENTED: 5}
    rows = (
        Row("all corrected", "rational", "computer algebra", {RIGHT: 10}),
        Row("all corrected", "mpfr:53", "computer algebra", counts),
    )
    return Judged("2026-01-02", 10, rows, LEAST)


def test_runs_are_read_as_they_were_written() -> None:
    assert read(as_text(sums(1))) == sums(1)


def test_rows_in_mpfr_ascend_by_precision() -> None:
    assert [row.bits for row in sums(0).of(CORRECTED, "cgal-reduced")] == [53, 200]
    assert share(sums(0).rows[2], (AGREE,), (AGREE, OURS, GAVE_UP)) == 60


@pytest.mark.parametrize(("wrong", "verdict"), [(0, Verdict.IN_KIND), (1, Verdict.NOT_REPRODUCED)])
def test_exactness_is_claimed_of_the_finest_precision(wrong: int, verdict: Verdict) -> None:
    entry = sums_entry(sums(wrong))
    assert entry.verdict is verdict
    (claim,) = entry.claims
    assert "mpfr:200" in claim.tested and f"wrong or given up {wrong}" in claim.found


def test_a_fault_of_cgal_is_not_held_against_the_program() -> None:
    (table, _) = sums_entry(sums(0)).tables
    assert [CORRECTED, "cgal-reduced", "rational", 10, 9, 0, 1, 0, 0] in table.rows


def test_events_are_told_by_precision_and_formula() -> None:
    entry = events_entry(events())
    assert entry.claims[0].found == "3 missed, 5 invented, 1 misplaced of 10 events"
    assert entry.verdict is Verdict.NOT_REPRODUCED
    table, least = entry.tables
    assert ["all corrected", "mpfr:53", 10, 6, 3, 5, 1, 0, 0] in table.rows
    assert least.columns[1:] == [
        "cases with all events right from 53 bits",
        "cases with all events right from 200 bits",
        "at no tried precision",
    ]
    assert all(kind in entry.pictures[0].svg for kind in (MISSED, INVENTED, MISPLACED))


def test_without_runs_the_entries_say_how_to_make_them() -> None:
    for entry in (sums_entry(None), events_entry(None)):
        assert entry.verdict is Verdict.NOT_ATTEMPTED
        assert "make evidence ONLY=paper_targets" in entry.why


def test_the_page_has_the_tables_of_the_kept_runs() -> None:
    """`python -m minkref.reports.paper.judged_docs` renews them."""
    text = PAGE.read_text(encoding="utf-8")
    assert written(text) == text
    listed = kept(EVENTS)
    assert listed is not None
    exact = next(row for row in listed.rows if row.arithmetic == "rational")
    assert f"of {exact.counts[RIGHT]:,}." in text


def test_the_kept_runs_have_no_fault_of_the_corrected_programs_in_rational_numbers() -> None:
    judged, listed = together(kept(SUMS), kept(SOLIDS)), kept(EVENTS)
    assert judged is not None and listed is not None
    right = ("static program", CORRECTED, "repair, all corrected")
    exact = [r for r in judged.rows if r.arithmetic == "rational" and r.program in right]
    assert len(exact) > 2 and not any(row.counts.get(OURS) for row in exact)
    exact = [r for r in listed.rows if (r.program, r.arithmetic) == ("all corrected", "rational")]
    assert len(exact) == 1 and exact[0].counts[RIGHT] > 10_000
    assert not any(exact[0].counts.get(kind) for kind in (MISSED, INVENTED, MISPLACED))
