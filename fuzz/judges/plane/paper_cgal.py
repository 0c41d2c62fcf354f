"""Sums by the paper's programs beside CGAL's, in the plane and in space: agreements, and whose
fault a difference is, by a witness."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.libraries.paper.in_plane import PlaneProgram
from minkref.fuzz.libraries.paper.in_space import SpaceProgram
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import settle
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.protocol import sent_scale
from minkref.fuzz.targets.answer import answered
from minkref.fuzz.verdicts.verdict import Witness

AGREE, GAVE_UP, ABSENT = "agree", "gave up", "no answer of CGAL"
OURS, THEIRS, NEITHER = "the program's fault", "CGAL's fault", "not settled"
REFUSALS = (_core.UndecidedSign, _core.BadInput, _core.LimitExceeded)


@dataclass
class Beside:
    """How a program's sums stand to CGAL's. `shown`: the first difference of each kind, with the
    point that settles it."""

    counts: Counter[str] = field(default_factory=Counter)
    shown: dict[str, str] = field(default_factory=dict)

    def note(self, kind: str, case: str, witness: Witness | None = None) -> None:
        self.counts[kind] += 1
        if kind in (OURS, THEIRS, NEITHER):
            point = f" at ({', '.join(witness.point)})" if witness else ""
            self.shown.setdefault(kind, f"{case}{point}")

    def add(self, other: Beside) -> None:
        self.counts += other.counts
        self.shown = {**other.shown, **self.shown}


def plane_answer(name: ProgramName, case: Case) -> Region | None:
    """The program's sum; None where its arithmetic tells no sign."""
    try:
        value = PlaneProgram(name).at(case.P_json, case.Q_json, case.scale)
    except REFUSALS:
        return None
    return answered(value, 0.0).region


def beside_in_plane(
    name: ProgramName, case: Case, got: Region | None, cgal: Region | None, found: Beside
) -> None:
    """Compares a program's sum with one by CGAL, within the program's tolerance. Where they differ,
    the definition decides a point that only one of them has."""
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
    settled = settle(case, cgal, got, name.relative * case.magnitude)
    if settled.truth is not None:
        found.note(THEIRS, text, settled.truth)
    elif settled.claim is not None:
        found.note(OURS, text, settled.claim)
    else:
        found.note(NEITHER if settled.differ or not name.relative else AGREE, text)


def beside_in_space(
    name: ProgramName, case: SpaceCase, cgal: Polyhedron | None, found: Beside
) -> None:
    """Holds both sums of convex bodies against the hull of all sums of vertices: a difference is
    the fault of the one that has a witness against it."""
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


def least_bits(tried: dict[int, bool]) -> int | None:
    """The fewest bits from which on all tried precisions agree; None if the last does not."""
    least = None
    for bits in sorted(tried, reverse=True):
        if not tried[bits]:
            break
        least = bits
    return least
