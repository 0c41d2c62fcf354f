"""Erosions by all routes before the slow engine, single places, CGAL, and laws."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.api import closing, erode, inner_fit, opening, subtract, unite
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cgal.executables import target_names
from minkref.fuzz.judges.plane.cgal_claims import CgalClaims
from minkref.fuzz.judges.plane.erosion_pairs import erosion_case
from minkref.fuzz.judges.plane.places_pairs import jigsaw, place_faults
from minkref.fuzz.judges.plane.slow_erosion import judge
from minkref.fuzz.plane.case import Case
from minkref.plane.erosion import Erosion
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 1, 30)

SEED = 3319
PAIRS = Counts(12, 60, 2000)
PLACES = Counts(10, 40, 500)
Result = tuple[Counter[str], list[str]]


def slow(index: int) -> Result:
    """Judge a pair by the slow engine, then place by place."""
    ruling = judge(erosion_case(SEED, index), 6)
    return Counter({"slow engine": ruling.compared}), ruling.messages


_claims: CgalClaims | None = None


def cgal(index: int) -> Result:
    """Sum outsides and -Q by CGAL; the slow engine judges its answers."""
    global _claims
    if _claims is None:
        _claims = CgalClaims(target_names())
    case = erosion_case(SEED, index)
    outside, turned = _core.Outside(case.P).set, _core.negated(case.Q)
    name = CaseName(f"outside of {case.name.text}", "erosion")
    rows = _claims.against(Case(name, outside, turned, case.scale, "outside", "-Q"))
    return Counter(f"CGAL, {row['outcome']}" for row in rows), []


def laws(index: int) -> Result:
    """Translation, scaling, monotony, duality, erosion twice, opening and closing."""
    case = erosion_case(SEED + 1, index)
    P, Q = case.P.scaled(case.scale), case.Q
    left = erode(P, Q)
    faults: list[str] = []
    held: Counter[str] = Counter()

    def law(name: str, holds: bool) -> None:
        held[name] += 1
        if not holds:
            faults.append(f"{case.name.text}: {name}")

    moved = erode(P.translated("7/3", "-5"), Q.translated("1/9", "4"))
    law("translation", moved.points == _shifted(left, Fraction(20, 9), Fraction(-9)))
    law("translation", moved.region == left.region.translated("20/9", "-9"))
    law("scaling", erode(P.scaled("3/2"), Q.scaled("3/2")).region == left.region.scaled("3/2"))
    opened, closed = opening(P, Q), closing(P, Q)
    law("an opening lies within", subtract(opened.region, [P]).is_empty)
    law("a closing contains", subtract(P, [closed.region]).is_empty)
    law("an opening is eroded to the same", erode(opened.region, Q).region == left.region)
    law("a closing has the same sum", (closed.region + Q) == (P + Q))
    law("closing twice", closing(closed.region, Q) == closed)
    if not opened.region.is_empty:
        law("opening twice", opening(opened.region, Q).region == opened.region)
    more = unite([P, P.translated("1/5", "1/3")])
    law("a larger set leaves more", subtract(left.region, [erode(more, Q).region]).is_empty)
    if Q.is_region:
        wider = unite([Q, Q.translated("1/5", "1/3")])
        law("a larger shape leaves less", subtract(erode(P, wider).region, [left.region]).is_empty)
    if Q.is_region and not left.remnants:
        twice = erode(left.region, Q.scaled("1/3"))
        law("erosion twice", erode(P, Q + Q.scaled("1/3")) == twice)
    return held, faults


def _shifted(left: Erosion, x: Fraction, y: Fraction) -> tuple[Any, ...]:
    return tuple(tuple((a + x, b + y) for a, b in points) for points in left.points)


def places(index: int) -> Result:
    """Judge no-fit places one by one; put a cut-out piece back at its only place."""
    compared, faults = place_faults(SEED, index)
    container, piece, at = jigsaw(SEED, index)
    found = inner_fit(container, piece)
    if found.points != ((at,),) or not found.region.is_empty:
        faults.append(f"jigsaw:{SEED}:{index}: {found.points}")
    return Counter({"places of parts": compared, "pieces put back": 1}), faults


def run(findings: Findings, size: Size) -> None:
    steps: tuple[tuple[str, Callable[[int], Result], Counts[int]], ...] = (
        ("erosions before the slow engine", slow, PAIRS),
        ("sums of outsides by CGAL", cgal, Counts(8, 30, 400)),
        ("laws of erosions", laws, PAIRS),
        ("places of parts", places, PLACES),
    )
    for name, work, counts in steps:
        tally: Counter[str] = Counter()
        faults: list[str] = []
        wanted = size.of(counts)
        for counted, found in in_processes(work, range(wanted), each=100, what=name):
            tally.update(counted)
            faults += found
        findings.none(f"{name}: faults in {wanted:,}", faults)
        findings.law(f"{name}: compared", bool(tally), "some", f"{sum(tally.values()):,}")
        findings.figures[name] = dict(sorted(tally.items()))
    equal = findings.figures["sums of outsides by CGAL"].get("CGAL, equal", 0)
    findings.target("sums of outsides by CGAL that agree", equal > 0, "some", f"{equal:,}")
    findings.figures["seed"] = SEED
