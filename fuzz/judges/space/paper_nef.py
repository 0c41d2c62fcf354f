"""Convex sums by the paper's repair beside CGAL's Nef polyhedra."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
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
from minkref.fuzz.libraries.paper.in_space import SpaceProgram
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.targets.numbers import sent_scale


def beside_in_space(
    name: ProgramName, case: SpaceCase, cgal: Polyhedron | None, found: Beside
) -> None:
    """Holds both sums of convex bodies against the hull of all vertex sums; a witness tells the
    culprit."""
    text = case.name.text
    if cgal is None:
        found.note(ABSENT, text)
        return
    got = _solid(name, case)
    if got is None:
        found.note(GAVE_UP, text)
        return
    theirs = compare(case.pair, cgal)
    ours = compare(case.pair, got, name.is_exact, name.relative * case.magnitude)
    if theirs.verdict == "wrong":
        found.note(THEIRS, text, theirs.witness)
    elif ours.verdict == "wrong":
        found.note(OURS, text, ours.witness)
    else:
        found.note(NEITHER if "undecided" in (ours.verdict, theirs.verdict) else AGREE, text)


def _solid(name: ProgramName, case: SpaceCase) -> Polyhedron | None:
    P, Q = case.asked.P.document(), case.asked.Q.document()
    try:
        value = SpaceProgram(name).at(P, Q, sent_scale(case.scale))
    except REFUSALS:
        return None
    points = [(Fraction(x), Fraction(y), Fraction(z)) for x, y, z in value["vertices"]]
    return Polyhedron(tuple(points), tuple(map(tuple, value["faces"])))
