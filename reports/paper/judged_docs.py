"""Writes two tables of `docs/paper.md` from the kept runs beside CGAL and computer algebra: `python
-m minkref.reports.paper.judged_docs`. A test holds the page to them."""

from __future__ import annotations

from collections.abc import Callable

from minkref.fuzz.judges.beside import AGREE, COMPARED, GAVE_UP, THEIRS
from minkref.fuzz.judges.plane.paper_algebra import INVENTED, MISPLACED, MISSED
from minkref.output.documents import write_atomically
from minkref.reports.paper.docs import PAGE
from minkref.reports.paper.judged_runs import EVENTS, SOLIDS, SUMS, Judged, kept, together

BEGIN = "<!-- these tables: python -m minkref.reports.paper.judged_docs -->\n"
END = "<!-- the end of these tables -->\n"
ARITHMETICS = ("rational", "double", "mpfr:53", "mpfr:200", "mpfr:1000")
Told = Callable[[dict[str, int]], str]
BESIDE = ("cgal-reduced", "cgal-nef")  # the other methods of CGAL agree with the first


def sums_table(judged: Judged) -> str:
    """Sums beside a CGAL method for the plane, and another for space: agreeing ones out of all."""
    rows = [_head("program", "beside")]
    for program in judged.programs():
        for other in judged.others(program):
            if other in BESIDE:
                rows.append(_row((program, other), judged, program, other, _sums))
    return "\n".join([*rows, ""])


def events_table(judged: Judged) -> str:
    """Events missed, invented, misplaced."""
    rows = [_head("formulas")]
    for program in judged.programs():
        (other,) = judged.others(program)
        rows.append(_row((program,), judged, program, other, _events))
    return "\n".join([*rows, ""])


def _head(*words: str) -> str:
    columns = (*words, *ARITHMETICS)
    return f"| {' | '.join(columns)} |\n|{'---|' * len(columns)}"


def _row(words: tuple[str, ...], judged: Judged, program: str, other: str, told: Told) -> str:
    found = {
        r.arithmetic: r.counts for r in judged.rows if (r.program, r.against) == (program, other)
    }
    cells = [told(found[name]) if name in found else "-" for name in ARITHMETICS]
    return f"| {' | '.join([*words, *cells])} |"


def _sums(counts: dict[str, int]) -> str:
    total = sum(counts.get(kind, 0) for kind in COMPARED)
    more = [
        f"{counts[kind]} {word}"
        for kind, word in ((GAVE_UP, "given up"), (THEIRS, "CGAL's fault"))
        if counts.get(kind)
    ]
    text = f"{counts.get(AGREE, 0):,} of {total:,}"
    return f"{text} ({', '.join(more)})" if more else text


def _events(counts: dict[str, int]) -> str:
    return ", ".join(f"{counts.get(kind, 0):,}" for kind in (MISSED, INVENTED, MISPLACED))


def written(text: str) -> str:
    """The page with its tables renewed. Raises ValueError without the marks or the runs."""
    sums, events = together(kept(SUMS), kept(SOLIDS)), kept(EVENTS)
    if sums is None or events is None:
        raise ValueError("no runs have been kept")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    tables = f"\n{sums_table(sums)}\n{events_table(events)}\n"
    return f"{before}{BEGIN}{tables}{END}{after}"


if __name__ == "__main__":
    write_atomically(PAGE, written(PAGE.read_text(encoding="utf-8")))
