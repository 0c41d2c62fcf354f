"""The entry on how often the paper's own program has the right sum, from the runs of the
evidence."""

from __future__ import annotations

from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.program_plots import (
    RATIONAL,
    ROUNDING,
    blame_plot,
    microseconds,
    pairs_plot,
    precision_plot,
    time_plot,
)
from minkref.reports.paper.program_runs import CORRECTED, Run, Runs, committed, share

COMMAND = "make evidence ONLY=paper_program FULL=1"
PRINTED = "all as printed"
SOLVE = "solve as printed"
FINEST = ROUNDING[-1]


TITLE = "How often the paper's program has the right sum"


def program_entry(runs: Runs | None) -> Entry:
    """The entry about the paper's program; without `runs` the entry only says so."""
    if runs is None:
        why = f"No runs have been kept: {COMMAND} makes them."
        return Entry("Section 4", TITLE, why, COMMAND)
    last = runs.after[-1]
    counts = ", ".join(str(count) for count in runs.after[:-1])
    why = (
        f"Section 4 formula by formula: all of them in their right form, all but one, and as "
        f"printed, in rational numbers, doubles and MPFR, on {len(runs.names())} pairs of "
        f"polygons. Each walk goes through the re-scalings of Table 1, and after {counts} and "
        f"{last} of them its sum is held against the exact one: right is the same structure, each "
        f"vertex near its own. A pair with many edges is tried in fewer arithmetics; a line and a "
        f"bar are of the pairs that were tried in all of them. Rational numbers tell the "
        f"formula to blame: nothing else is wrong there. These runs are of "
        f"{runs.date}, and are not made again with the page."
        + ("" if runs.paper_models else " Look-alikes stand for the paper's models.")
    )
    pictures = [
        Picture("Right after so many re-scalings, against the precision",
                precision_plot(runs), True),
        Picture("By pair: + right, \N{MINUS SIGN} wrong after "
                f"{counts} and {last} re-scalings; - not tried", pairs_plot(runs), True),
        Picture("Which formula is to blame: it alone is as printed", blame_plot(runs), True),
        Picture("Finding the critical intervals, all formulas corrected, one thread: a point for "
                "each pair of operands", time_plot(runs), True),
    ]  # fmt: skip
    tables = [_shares(runs), _times(runs), _rows(runs)]
    claims = _claims(runs)
    unlike = ["the polygons are ours, but monkey, bird and neuron"] if runs.paper_models else [
        "the polygons are ours"
    ]  # fmt: skip
    return Entry("Section 4", TITLE, why, COMMAND, claims, unlike, pictures, tables)


def kept() -> Runs | None:
    """The runs from the last full evidence, if kept."""
    try:
        return committed()
    except FileNotFoundError:
        return None


EXACT = "two exact, output-sensitive algorithms"
INCONSISTENT = "there is no solution for s if the system is inconsistent"


def _claims(runs: Runs) -> list[Claim]:
    said = (
        (EXACT, "Sec. 1", "all formulas as printed, in rational numbers", PRINTED, RATIONAL),
        (EXACT, "Sec. 1", "all formulas corrected, in rational numbers", CORRECTED, RATIONAL),
        (EXACT, "Sec. 1",
         f"all formulas corrected, in {FINEST} (Section 7 has MPFR, and no number of bits)",
         CORRECTED, FINEST),
        (INCONSISTENT, "Sec. 4.2.1",
         "this formula alone as printed, and inconsistent read as unequal, for the paper has no "
         f"test of it: {FINEST}", SOLVE, FINEST),
    )  # fmt: skip
    claims = []
    for words, place, tested, variant, arithmetic in said:
        found = runs.of(variant, arithmetic)
        right = sum(run.right[-1] for run in found)
        told = f"right on {right} of {len(found)} pairs after {runs.after[-1]} re-scalings"
        claims.append(Claim(words, place, f"{tested}: the sum is right on all pairs", told,
                            bool(found) and right == len(found)))  # fmt: skip
    return claims


def _shares(runs: Runs) -> Table:
    after = [f"right after {count} (%)" for count in runs.after]
    rows = []
    for variant in runs.variants:
        for arithmetic in (RATIONAL, *ROUNDING):
            found = runs.of(variant, arithmetic)
            if found:
                shares = [f"{share(found, k):.0f}" for k in range(len(runs.after))]
                rows.append([variant, arithmetic, len(found), *shares])
    return Table("program_shares", ["program", "arithmetic", "pairs", *after], rows)


def _times(runs: Runs) -> Table:
    """Times for each arithmetic, and for its pair with the most edge pairs."""
    rows = []
    for arithmetic in (RATIONAL, *ROUNDING):
        found = runs.of(CORRECTED, arithmetic)
        if not found:
            continue
        largest = max(found, key=lambda run: run.pairs)
        rows.append([arithmetic, f"{microseconds(found):.2f}", largest.name, f"{largest.pairs:,}",
                     f"{largest.seconds:.1f}"])  # fmt: skip
    columns = ["arithmetic", "µs for a pair of edges", "the largest", "its pairs of edges",
               "processor time (s)"]  # fmt: skip
    return Table("program_times", columns, rows)


def _rows(runs: Runs) -> Table:
    columns = ["pair", "program", "arithmetic", *(f"right after {n}" for n in runs.after),
               "ulps", "pairs of edges", "seconds"]  # fmt: skip

    def row(run: Run) -> list[object]:
        right = ["yes" if one else "no" for one in run.right]
        return [run.name, run.variant, run.arithmetic, *right, run.most_ulps, run.pairs,
                run.seconds]  # fmt: skip

    return Table("program_runs", columns, [row(run) for run in runs.runs])
