"""Sums in the plane by the paper's programs in MPFR beside CGAL's static sums: agreements, and
whose fault each difference is, by a point."""

from __future__ import annotations

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.judges.beside import NEITHER, OURS
from minkref.fuzz.judges.plane.paper_cgal import beside_in_plane, plane_answer
from minkref.fuzz.libraries.paper.program_name import PREFIX, read_name
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.naming import load_in_plane
from minkref.fuzz.targets.answer import Limits
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.paper_targets.beside_cgal import Found, Task, tally
from minkref.reports.evidence.paper_targets.chosen_cases import plane_cases
from minkref.reports.paper.judged_runs import SUMS

MINUTES = Minutes(0.3, 1, 3)

CASES = Counts(24, 80, 200)
FORMS = {
    "corrected": "update, all corrected",
    "corrected,solve=printed": "update, the solve as printed",
    "printed": "update, all as printed",
    "static": "static program",
}
CGAL = ("cgal-reduced", "cgal-vertical", "cgal-triangulation", "cgal-optimal")
EXACT = (FORMS["corrected"], FORMS["static"])  # in rational numbers


def examine(task: Task) -> Found:
    """All programs on some cases, as a worker process."""
    found = Found()
    targets = {name: ALL_TARGETS.target(name, Limits(seconds=20)) for name in task.cgal}
    try:
        for name in task.names:
            case = load_in_plane(CaseName(name, "evidence"))
            found.cases += 1
            theirs = {n: target.sum(case).region for n, target in targets.items()}
            for form, program in FORMS.items():
                _compare(case, form, program, task.arithmetics, theirs, found)
    finally:
        for target in targets.values():
            target.close()
    return found


def _compare(
    case: Case,
    form: str,
    program: str,
    arithmetics: tuple[str, ...],
    theirs: dict[str, Region | None],
    found: Found,
) -> None:
    right: dict[int, bool] = {}
    for arithmetic in arithmetics:
        name = read_name(f"{PREFIX}@{arithmetic},{form}")
        got = plane_answer(name, case)
        before = found.count(program, arithmetic, OURS, NEITHER)
        for other, region in theirs.items():
            beside_in_plane(name, case, got, region, found.at(program, arithmetic, other))
        if name.bits and arithmetic != "double":
            after = found.count(program, arithmetic, OURS, NEITHER)
            right[name.bits] = got is not None and before == after
    if any(region is not None for region in theirs.values()):
        found.note_least(program, right)


def run(findings: Findings, size: Size) -> None:
    cgal = tuple(available_cgal(findings, *CGAL))
    tally(findings, size, plane_cases(size.of(CASES)), cgal, examine, EXACT, SUMS)
