"""The entry about the paper's own program: its data, claims and plots."""

from __future__ import annotations

from dataclasses import replace

from minkref import _core
from minkref.reports.paper.entry import Verdict
from minkref.reports.paper.program_entry import program_entry
from minkref.reports.paper.program_plots import RATIONAL, ROUNDING, tried_in_all
from minkref.reports.paper.program_runs import CORRECTED, Run, Runs, as_text, committed, read, share

AFTER = (1, 10, 100)
VARIANTS = (CORRECTED, "solve as printed", "all as printed")


def made(name: str, arithmetic: str, variant: str) -> Run:
    """Rational numbers are right except with all as printed; other arithmetics err from the second
    run on."""
    if arithmetic == RATIONAL:
        right = (variant != "all as printed",) * 3
    else:
        right = (True, variant == CORRECTED, False)
    return Run(name, arithmetic, variant, right, 1.5, 1000, 0.002)


def runs() -> Runs:
    every = [made(name, arithmetic, variant) for name in ("a + b", "c + d")
             for variant in VARIANTS for arithmetic in (RATIONAL, *ROUNDING)]  # fmt: skip
    large = [made("e + f", "double", CORRECTED)]
    return Runs("2026-01-02", True, AFTER, VARIANTS, (*every, *large))


def test_runs_are_read_as_they_were_written() -> None:
    assert read(as_text(runs())) == runs()


def test_a_line_is_of_the_pairs_that_all_its_points_have() -> None:
    assert tried_in_all(runs(), CORRECTED, ROUNDING) == {"a + b", "c + d"}
    assert share(runs().of(CORRECTED, "double"), 1) == 100
    assert share(runs().of("solve as printed", "double"), 1) == 0


def test_claims_hold_if_every_pair_is_right_at_the_end() -> None:
    entry = program_entry(runs())
    assert [claim.holds for claim in entry.claims] == [False, True, False, False]
    assert entry.claims[1].found == "right on 2 of 2 pairs after 100 re-scalings"
    assert entry.verdict == Verdict.NOT_REPRODUCED
    better = [replace(run, right=(True,) * 3) for run in runs().runs]
    assert program_entry(replace(runs(), runs=tuple(better))).verdict == Verdict.IN_KIND


def test_plots_and_tables_show_all_that_was_run() -> None:
    entry = program_entry(runs())
    precision, pairs, blame, times = (picture.svg for picture in entry.pictures)
    for variant in VARIANTS:
        assert f"{variant} (2 pairs)" in precision
        assert f">{variant}<" in blame
    assert all(f">{name}<" in pairs for name in ("a + b", "c + d", "e + f"))
    assert "mpfr:1000" in times
    shares, spent, rows = entry.tables
    assert ["solve as printed", "mpfr:53", 2, "100", "0", "0"] in shares.rows
    assert ["double", "2.00", "a + b", "1,000", "0.0"] in spent.rows
    assert len(rows.rows) == len(runs().runs)


def test_without_runs_the_entry_says_how_to_make_them() -> None:
    entry = program_entry(None)
    assert entry.verdict == Verdict.NOT_ATTEMPTED
    assert "make evidence ONLY=paper_program" in entry.why


def test_the_committed_runs_are_those_of_the_programs_that_there_are() -> None:
    """With all formulas corrected and rational numbers every sum is the exact one."""
    found = committed()
    assert found.after == AFTER
    exact = found.of(CORRECTED, RATIONAL)
    assert len(exact) == 24 and all(all(run.right) for run in exact)
    assert {run.variant for run in found.runs} == set(found.variants)
    printed = {name for name, values, corrected, _ in _core.paper_readings()
               if values[0] != corrected}  # fmt: skip
    assert {f"{name} as printed" for name in printed} <= set(found.variants)
    assert all(run.pairs > 0 and run.seconds >= 0 for run in found.runs)
