"""The verdict on what a target says of the scales at which a part passes along a path."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

import minkref
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_claim import PathClaim
from minkref.fuzz.motion.path_witness import ALLOWED, Asked, path_witness
from minkref.fuzz.plane.comparison import WitnessRefuted
from minkref.fuzz.plane.event_judgement import Within
from minkref.fuzz.plane.judgement import DOUBT, REFEREE, without_answer
from minkref.fuzz.plane.tolerance import grown, shrunk
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

FORBIDDEN = "forbidden"


@dataclass(frozen=True)
class Sides:
    """Scales that must be called valid (`strict`) and scales that may be (`loose`). The tolerance
    makes the difference: obstacles are larger by it, and must not be touched; or smaller, and may
    be."""

    strict: minkref.ValidScales
    loose: minkref.ValidScales
    larger: Asked
    smaller: Asked

    @staticmethod
    def of(case: AskedPath, declared: Declaration) -> Sides:
        half = declared.tolerance(case.magnitude)
        if not half:
            valid, asked = case.valid(), Asked(case, case.obstacles, case.contact)
            return Sides(valid, valid, asked, asked)
        larger = Asked(case, grown(case.obstacles, half), FORBIDDEN, half)
        smaller = Asked(case, shrunk(case.obstacles, half), ALLOWED, half)
        strict, loose = (
            replace(case, obstacles=one.obstacles, contact=one.contact).valid()
            for one in (larger, smaller)
        )
        return Sides(strict, loose, larger, smaller)


def judge_path(
    case: AskedPath, name: str, claim: PathClaim, declared: Declaration
) -> list[Outcome]:
    """Compares a claim with the route `contacts`, up to the tolerance; if the target differs, the
    definition decides the scale, twice. The witness of a missed collision is a place with p and q;
    for an invented collision, the fact that no deciding place collides. If the definition refutes
    the reference, the target is undecided, and the outcome names the referee."""
    sides = Sides.of(case, declared)
    claim = _snapped(claim, declared, (sides.strict, sides.loose))
    differing = _differing(case, claim, sides)
    if not differing:
        return [Outcome(name, _good(case, claim, declared, sides))]
    reasons: list[Reason] = []
    texts: list[str] = []
    witness: Witness | None = None
    for scale, is_valid in differing:
        try:
            found = path_witness(sides.smaller if is_valid else sides.larger, scale)
        except WitnessRefuted as error:
            return _doubt(name, f"{DOUBT}: {error}")
        if found.in_truth != is_valid:
            return _doubt(name, f"the route contacts is refuted at the scale {scale}")
        reasons.append(Reason.COLLISION_MISSED if is_valid else Reason.COLLISION_INVENTED)
        told = "called valid, and the part collides" if is_valid else "valid, and not called so"
        texts.append(f"the scale {scale} is {told}")
        witness = witness or found
    return [Outcome(name, Verdict.WRONG, tuple(reasons), message="; ".join(texts), witness=witness)]


def _snapped(
    claim: PathClaim, declared: Declaration, true: Sequence[minkref.ValidScales]
) -> PathClaim:
    """Replaces doubles next to the true end of a range by this end, if the target's numbers are
    doubles."""
    if claim.ranges is None or declared.numbers != "double":
        return claim
    within = Within(declared)
    ends = {bound.scale for found in true for bound in found.bounds}
    stands_for = {double: end for end in ends for double in within.beside(end)}

    def snapped(end: Fraction | None) -> Fraction | None:
        return end if end is None else stands_for.get(end, end)

    return PathClaim(
        ranges=tuple(
            replace(one, low=stands_for.get(one.low, one.low), high=snapped(one.high))
            for one in claim.ranges
        )
    )


def _doubt(name: str, message: str) -> list[Outcome]:
    return [
        Outcome(name, Verdict.UNDECIDED, message=message),
        Outcome(REFEREE, Verdict.ERRORED, message=message),
    ]


def _differing(case: AskedPath, claim: PathClaim, sides: Sides) -> list[tuple[Fraction, bool]]:
    """Returns the least scale called valid that may not be, and the least scale that must be valid
    but is not called so; each with the claim about it."""
    scales, says = _said(case, claim, (sides.strict, sides.loose))
    missed = next((s for s in scales if says(s) and s not in sides.loose), None)
    invented = next((s for s in scales if not says(s) and s in sides.strict), None)
    return [(s, said) for s, said in ((missed, True), (invented, False)) if s is not None]


def _said(
    case: AskedPath, claim: PathClaim, others: Sequence[minkref.ValidScales]
) -> tuple[list[Fraction], Callable[[Fraction], bool]]:
    """Returns scales that reveal all differences, ascending, and the claim about each."""
    if claim.ranges is None:
        said = dict(zip(map(Fraction, case.scales), claim.valid, strict=True))
        return sorted(said), said.__getitem__
    assert case.window is not None
    ranges = claim.ranges
    low, high = map(Fraction, case.window)
    every = [*ranges, *(one for found in others for one in found.ranges)]
    ends = {end for one in every for end in (one.low, one.high) if end is not None}
    cuts = sorted({low, high, *(end for end in ends if low < end < high)})
    middles = [(a + b) / 2 for a, b in pairwise(cuts)]
    return sorted([*cuts, *middles]), lambda scale: any(scale in one for one in ranges)


def _good(case: AskedPath, claim: PathClaim, declared: Declaration, sides: Sides) -> Verdict:
    if declared.exact or sides.strict is sides.loose:
        return Verdict.PASS
    exact = case.valid()
    scales, says = _said(case, claim, (exact,))
    right = all(says(scale) == (scale in exact) for scale in scales)
    return Verdict.PASS if right else Verdict.PASS_WITHIN


def without_claim(case: AskedPath, name: str, answer: Answer) -> Outcome:
    """The outcome if an answer gives a reason instead of a claim; WRONG: valid input was
    rejected."""
    outcome = without_answer(name, answer)
    if outcome.verdict is not Verdict.WRONG:
        return outcome
    scale = Fraction(case.scales[0]) if case.scales else case.greatest_scale
    witness = path_witness(Asked(case, case.obstacles, case.contact), scale)
    return replace(outcome, reasons=(Reason.REJECTED_VALID,), witness=witness)
