"""Convex sums by the paper's repair in MPFR beside CGAL's Nef polyhedra: agreements, and whose
fault each difference is, by a point."""

from __future__ import annotations

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.beside import AGREE
from minkref.fuzz.judges.space.paper_nef import beside_in_space
from minkref.fuzz.libraries.paper.program_name import PREFIX, read_name
from minkref.fuzz.run.naming import load
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.targets.answer import Limits, Target
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.paper_targets.beside_cgal import Found, Task, tally
from minkref.reports.evidence.paper_targets.chosen_cases import space_cases
from minkref.reports.paper.judged_runs import SOLIDS

MINUTES = Minutes(0.1, 1, 4)

CASES = Counts(10, 24, 40)
FORMS = {"corrected": "repair, all corrected", "printed": "repair, all as printed"}
NEF = "cgal-nef"


def examine(task: Task) -> Found:
    """The repair on some cases of convex bodies, as a worker process."""
    found = Found()
    if not task.cgal:
        return found
    nef = ALL_TARGETS.target(NEF, Limits(seconds=20))
    try:
        for name in task.names:
            case = load(CaseName(name, "evidence"))
            if isinstance(case, SpaceCase) and _is_convex(case):
                found.cases += 1
                _compare(case, task.arithmetics, nef, found)
    finally:
        nef.close()
    return found


def _is_convex(case: SpaceCase) -> bool:
    return all(is_convex(solid) and not solid.is_thin for solid in (case.pair.P, case.pair.Q))


def _compare(case: SpaceCase, arithmetics: tuple[str, ...], nef: Target, found: Found) -> None:
    theirs = nef.sum(case).solid
    for form, program in FORMS.items():
        right: dict[int, bool] = {}
        for arithmetic in arithmetics:
            name = read_name(f"{PREFIX}@{arithmetic},{form}")
            at = found.at(program, arithmetic, NEF)
            agreed = at.counts[AGREE]
            beside_in_space(name, case, theirs, at)
            if name.bits and arithmetic != "double":
                right[name.bits] = at.counts[AGREE] > agreed
        if theirs is not None:
            found.note_least(program, right)


def run(findings: Findings, size: Size) -> None:
    cgal = tuple(available_cgal(findings, NEF))
    names = space_cases(size.of(CASES))
    tally(findings, size, names, cgal, examine, (FORMS["corrected"],), SOLIDS)
