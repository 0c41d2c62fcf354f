"""The entry about times in space of the paper's own program: its data, claims and plot."""

from __future__ import annotations

from dataclasses import replace

import pytest
from minkref.reports.bench.space_pairs import UPDATE_PAIRS
from minkref.reports.evidence.paper_program import space_times as evidence
from minkref.reports.paper.entry import Verdict
from minkref.reports.paper.space_times import Step, Timed, Times, as_text, kept, read
from minkref.reports.paper.space_times_entry import space_times_entry


def made(name: str, arithmetic: str) -> Timed:
    """The more events, the longer the update; only the first sums were timed."""
    steps = tuple(
        Step(
            "1",
            f"{k + 2}/7",
            10 * (k + 1),
            100,
            1e-6 * (k + 1),
            1e-6,
            1e-3,
            0.002 * (k < 9) or None,
        )
        for k in range(12)
    )
    return Timed(name, arithmetic, 101, 500, 900, 2.0, 0.5, steps)


def times() -> Times:
    runs = [made(name, arithmetic) for name in ("a + b", "c + d")
            for arithmetic in ("double", "mpfr:53")]  # fmt: skip
    return Times("2026-01-02", "[1/5, 2]", 3, 2, tuple(runs))


def test_times_are_read_as_they_were_written() -> None:
    text = as_text(times())
    assert as_text(read(text)) == text
    assert read(text).runs[0].steps[0] == times().runs[0].steps[0]


def test_both_parts_hold_what_the_paper_says_of_them() -> None:
    entry = space_times_entry(times())
    assert len(entry.claims) == 6 and all(claim.holds for claim in entry.claims)
    assert entry.verdict == Verdict.CONSISTENT  # from all pairs (c) is much faster
    less = [replace(run, search=0.001) for run in times().runs]
    assert space_times_entry(replace(times(), runs=tuple(less))).verdict == Verdict.IN_KIND
    run = times().runs[0]
    assert run.intersections()[-1] == pytest.approx(500)
    assert run.intersections(True)[-1] == pytest.approx(250_000)
    assert len(run.total()) == 9 and run.total()[-1] == pytest.approx(0.003 / 0.002002)
    assert "12,207 facets" in entry.unlike[-1]


def test_a_claim_fails_where_the_whole_is_much_faster() -> None:
    runs = [replace(run, steps=tuple(replace(step, near=0.1) for step in run.steps))
            for run in times().runs]  # fmt: skip
    entry = space_times_entry(replace(times(), runs=tuple(runs)))
    assert [claim.holds for claim in entry.claims] == [True, True, False] * 2


def test_the_plot_and_the_tables_show_each_run() -> None:
    entry = space_times_entry(times())
    assert all(f">{name}<" in entry.pictures[0].svg for name in ("a + b", "c + d"))
    rows, steps = entry.tables
    assert [row[:3] for row in rows.rows] == [
        [run.name, run.arithmetic, 53] for run in times().runs
    ]
    assert len(steps.rows) == 4 * 12


def test_without_times_the_entry_says_how_to_make_them() -> None:
    entry = space_times_entry(None)
    assert entry.verdict == Verdict.NOT_ATTEMPTED and "make evidence" in entry.why


def test_steps_have_events_and_place_all_crossings(monkeypatch: pytest.MonkeyPatch) -> None:
    """And both arithmetics go through the same scales."""
    monkeypatch.setattr(evidence, "STEPS", 3)
    monkeypatch.setattr(evidence, "PATIENCE", 0)
    found = [evidence.time_pair(UPDATE_PAIRS[0], name) for name in ("double", "mpfr:53")]
    assert all(step.events > 0 and step.crossings > 0 for run in found for step in run.steps)
    double, mpfr = ([(step.start, step.scale) for step in run.steps] for run in found)
    assert double == mpfr and len(double) == 3


def test_the_committed_times_are_of_both_arithmetics() -> None:
    found = kept()
    assert found is not None
    assert {run.arithmetic for run in found.runs} == {"double", "mpfr:53"}
    assert [run.name for run in found.of("mpfr:53")] == [pair.name for pair in UPDATE_PAIRS]
    assert all(run.steps and all(step.events > 0 for step in run.steps) for run in found.runs)
