"""Radii at which sums with a disc change, before CGAL, Boost.Polygon and computer algebra."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, absence
from minkref.fuzz.judges.disc import disc_diagram, equidistant_comparison
from minkref.fuzz.judges.disc.disc_diagram import DiagramComparison, Table
from minkref.reports.evidence.disc_sums.sums import LARGE
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.7, 1)

SEED = 1909
SETS, BATCH = Counts(10, 400, 1000), 10
CASES = Counts(6, 120, 300)  # of each kind
FINE_SETS = Counts(6, 100, 300)  # with details far smaller than the set
FINE = ("thin", "offset", "magnitude")


def batch(first: int) -> Table:
    table = Table()
    disc_diagram.compare(SEED, range(first, first + BATCH), table)
    return table


def run(findings: Findings, size: Size) -> None:
    missing = [told for told in (absence(CGAL), absence(BOOST)) if told]
    if missing:
        findings.law("the judges are there", False, "they are", "; ".join(missing))
        return
    tell_absent(findings, *LARGE)
    rows = [_model(name, findings) for name in (LARGE[:1] if size is Size.QUICK else LARGE)]
    table = Table()
    count = size.of(SETS)
    for one in in_processes(batch, range(0, count, BATCH)):
        table.add(one)
    _tell(findings, "random sets", table)
    enough = min(table.counts[f"sets before {judge}"] for judge in (CGAL, BOOST))
    findings.law("random sets before both", enough >= count * 9 // 10, count * 9 // 10, enough)
    algebra = _algebra(findings, size.of(CASES))
    fine = _fine(findings, size.of(FINE_SETS))
    findings.figures = {
        "models": rows, "random sets": dict(table.counts), "computer algebra": algebra,
        "sets with fine details": fine,
    }  # fmt: skip


def _tell(findings: Findings, what: str, table: Table) -> None:
    counts = table.counts
    findings.none(f"{what}: events that are not the judges', or the other way", table.differences)
    findings.note(
        f"{what}: {counts['events']:,} events of three features or more, "
        f"{counts['of more than three features']:,} of them of more, and {counts['saddles']:,} "
        f"saddles; vertices of CGAL {counts[f'vertices of {CGAL}']:,} (one of k features comes "
        f"k - 2 times), of Boost {counts[f'vertices of {BOOST}']:,}; of straight vertices of the "
        f"input {counts[f'straight, of {CGAL}']:,} and {counts[f'straight, of {BOOST}']:,}; "
        f"without an answer: {len(table.unanswered)}; answers that an exact witness refutes: "
        f"{len(table.refuted)}"
    )


def _model(name: str, findings: Findings) -> dict[str, Any]:
    P, name = operand(name).set, operand(name).name
    table = Table()
    rows = _core.diagram_events(P, 2).rows(0, 10**9)
    with DiagramComparison() as comparison:
        comparison.compare(name, P, rows, table)
    _tell(findings, name, table)
    both = [table.counts[f"sets before {judge}"] for judge in (CGAL, BOOST)]
    findings.equal(f"{name}: judges with an answer", 2, sum(both))
    return {"model": name, "vertices": P.vertices, **table.counts}


def _algebra(findings: Findings, count: int) -> dict[str, Any]:
    table = equidistant_comparison.Table()
    equidistant_comparison.compare(SEED, count, table)
    kinds = equidistant_comparison.KINDS
    findings.none("squared radii that computer algebra does not find", table.differences)
    least = min(table.counts[kind] for kind in kinds)
    findings.law("cases of each kind by computer algebra", least >= count, count, least)
    tied = min(table.degenerate[kind] for kind in kinds)
    findings.law("degenerate ones of each kind", tied >= count // 3, count // 3, tied)
    degrees = ", ".join(f"{n:,} of degree {k}" for k, n in sorted(table.degrees.items()))
    findings.note(
        f"{', '.join(kinds)}: minkref's polynomials are {degrees}; {table.not_told} squared radii "
        "are rational, and told by a polynomial of a higher degree alone"
    )
    return {"counts": dict(table.counts), "degenerate": dict(table.degenerate)}


def _fine(findings: Findings, count: int) -> dict[str, Any]:
    """Sets with details far smaller than the set, where doubles tell few places apart."""
    table, refused = Table(), 0
    with DiagramComparison() as comparison:
        for number in range(count):
            family = FINE[number % len(FINE)]
            name, P = disc_diagram.first_operand(family, SEED, number)
            if P.is_empty or P.vertices < 3:
                continue
            try:
                rows = _core.diagram_events(P).rows(0, 10**9)
            except _core.LimitExceeded:
                refused += 1
                continue
            comparison.compare(name, P, rows, table)
    sets = table.counts["sets"]
    wrong = len(table.wrong)
    findings.law(
        f"sets of the families {', '.join(FINE)} without a difference",
        not wrong and not refused,
        f"{sets} of {sets}",
        f"{sets - wrong} of {sets}, and {refused} are refused",
    )  # fmt: skip
    return {"sets": sets, "with a difference": wrong, "refused": refused}
