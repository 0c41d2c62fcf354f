"""Sums by the paper's programs beside CGAL's in the plane."""

from __future__ import annotations

from minkref.fuzz.geometry.region import Region
from minkref.fuzz.judges.beside import (
    ABSENT,
    AGREE,
    GAVE_UP,
    NEITHER,
    OURS,
    REFUSALS,
    THEIRS,
    Beside,
)
from minkref.fuzz.libraries.paper.in_plane import PlaneProgram
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import SumOf, settle
from minkref.fuzz.targets.answer import answered


def plane_answer(name: ProgramName, case: Case) -> Region | None:
    """The program's sum; None for undecided signs."""
    try:
        value = PlaneProgram(name).at(case.P_json, case.Q_json, case.scale)
    except REFUSALS:
        return None
    return answered(value, 0.0).region


def beside_in_plane(
    name: ProgramName, case: Case, got: Region | None, cgal: Region | None, found: Beside
) -> None:
    """Compares a program's sum with CGAL's, within the program's tolerance. The definition decides
    a point of the difference."""
    text = case.name.text
    if cgal is None:
        found.note(ABSENT, text)
        return
    if got is None:
        found.note(GAVE_UP, text)
        return
    if got.digest == cgal.digest:
        found.note(AGREE, text)
        return
    settled = settle(SumOf(case), cgal, got, name.relative * case.magnitude)
    if settled.truth is not None:
        found.note(THEIRS, text, settled.truth)
    elif settled.claim is not None:
        found.note(OURS, text, settled.claim)
    else:
        found.note(NEITHER if settled.differ or not name.relative else AGREE, text)
