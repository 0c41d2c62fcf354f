"""The entries on the paper's programs beside CGAL's sums and computer algebra's events, from the
runs of the evidence."""

from __future__ import annotations

from collections.abc import Sequence

from minkref.fuzz.judges.beside import AGREE, COMPARED, GAVE_UP, OURS
from minkref.fuzz.judges.plane.paper_algebra import (
    GENERAL,
    INVENTED,
    MISPLACED,
    MISSED,
    RIGHT,
    UNDECIDED,
)
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.judged_plots import TRUE_EVENTS, events_plot, sums_plot
from minkref.reports.paper.judged_runs import EVENTS, SOLIDS, SUMS, Judged, Row, kept, together

COMMAND = "make evidence ONLY=paper_targets FULL=1"
CORRECTED = "all corrected"
EXACT = "two exact, output-sensitive algorithms"
UNLIKE = ("random cases and cases of the corpus of degenerate ones, not the paper's polygons",)


def judged_entries() -> list[Entry]:
    return [sums_entry(together(kept(SUMS), kept(SOLIDS))), events_entry(kept(EVENTS))]


def sums_entry(judged: Judged | None) -> Entry:
    """Without runs the entry only says so."""
    title = "The paper's programs beside CGAL's sums"
    if judged is None:
        return Entry("Sections 3, 4 and 6", title, _not_kept(), COMMAND)
    why = (
        f"The static program, the update walked from another scale, and the repair of convex "
        f"sums, beside CGAL's static sums (reduced convolution, decompositions, Nef polyhedra in "
        f"space), on {judged.cases:,} random cases and cases of the corpus of degenerate ones. A "
        f"sum agrees within a tolerance of about half its digits. Where two sums differ, a point "
        f"that only one of them has is decided from the definition: that tells whose fault it is. "
        f"These runs are of {judged.date}, and are not made again with the page."
    )
    claims = [
        _claim(row) for row in judged.rows
        if CORRECTED in row.program and row.bits == _finest(judged)
    ]  # fmt: skip
    picture = Picture("Sums that agree with CGAL's, against the precision", sums_plot(judged), True)
    tables = [_sums(judged), _least("judged_sums_least", "cases right", judged)]
    return Entry("Sections 3, 4 and 6", title, why, COMMAND, claims, UNLIKE, [picture], tables)


def events_entry(judged: Judged | None) -> Entry:
    """Without runs the entry only says so."""
    title = "The paper's critical scales beside computer algebra's"
    if judged is None:
        return Entry("Section 4.2", title, _not_kept(), COMMAND)
    why = (
        f"The array of events of the paper's program, formula by formula, beside the births and "
        f"deaths of pairs of edges that computer algebra derives from the definitions, on "
        f"{judged.cases:,} random cases and cases of the corpus. Missed: only computer algebra has "
        f"it. Invented: only the program has it. Misplaced: both have it, at scales that differ "
        f"in more than half the digits. Operands with numbers that the arithmetic does not hold "
        f"are rounded on their way in. These runs are of {judged.date}, and are not made again "
        f"with the page."
    )
    finest = [row for row in judged.rows if row.program == CORRECTED and row.bits]
    claims = []
    for row in finest:
        if row.bits == _finest(judged):
            told = _in_words(row)
            right = not any(row.counts.get(k) for k in (MISSED, INVENTED, MISPLACED, UNDECIDED))
            tested = f"all formulas corrected, {row.arithmetic}: all events are right"
            claims.append(Claim(EXACT, "Sec. 1", tested, told, right))
    picture = Picture("Events missed, invented and misplaced, against the precision, % of the "
                      "true ones", events_plot(judged), True)  # fmt: skip
    tables = [_events(judged), _least("judged_events_least", "cases with all events right", judged)]
    return Entry("Section 4.2", title, why, COMMAND, claims, UNLIKE, [picture], tables)


def _not_kept() -> str:
    return f"No runs have been kept: {COMMAND} makes them."


def _finest(judged: Judged) -> int:
    return max((row.bits or 0 for row in judged.rows), default=0)


def _claim(row: Row) -> Claim:
    total = sum(row.counts.get(kind, 0) for kind in COMPARED)
    agree = row.counts.get(AGREE, 0)
    ours = row.counts.get(OURS, 0) + row.counts.get(GAVE_UP, 0)
    tested = f"{row.program}, {row.arithmetic}: all sums are right"
    found = f"agrees with {row.against} on {agree:,} of {total:,} sums, wrong or given up {ours:,}"
    return Claim(EXACT, "Sec. 1", tested, found, not ours)


def _in_words(row: Row) -> str:
    told = [f"{row.counts.get(kind, 0):,} {kind}" for kind in (MISSED, INVENTED, MISPLACED)]
    return f"{', '.join(told)} of {_true(row):,} events"


def _true(row: Row) -> int:
    return sum(row.counts.get(kind, 0) for kind in TRUE_EVENTS)


def _sums(judged: Judged) -> Table:
    columns = ["program", "beside", "arithmetic", "sums", *COMPARED]
    rows = [
        [row.program, row.against, row.arithmetic,
         sum(row.counts.get(kind, 0) for kind in COMPARED),
         *(row.counts.get(kind, 0) for kind in COMPARED)]
        for row in judged.rows
    ]  # fmt: skip
    return Table("judged_sums", columns, rows)


def _events(judged: Judged) -> Table:
    kinds = (RIGHT, MISSED, INVENTED, MISPLACED, UNDECIDED, GENERAL)
    rows = [
        [row.program, row.arithmetic, _true(row), *(row.counts.get(kind, 0) for kind in kinds)]
        for row in judged.rows
    ]
    return Table("judged_events", ["formulas", "arithmetic", "events", *kinds], rows)


def _least(name: str, what: str, judged: Judged) -> Table:
    """Counts cases by sufficient bits."""
    words: Sequence[str] = sorted(
        {word for counts in judged.least.values() for word in counts},
        key=lambda word: int(word.split()[0]) if word[0].isdigit() else 10**9,
    )
    rows = [
        [program, *(counts.get(word, 0) for word in words)]
        for program, counts in judged.least.items()
    ]
    headings = [f"{what} from {w}" if w[0].isdigit() else f"at {w}" for w in words]
    return Table(name, ["program", *headings], rows)
