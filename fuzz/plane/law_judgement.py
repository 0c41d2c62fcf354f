"""The verdict on a target whose two answers a law relates."""

from __future__ import annotations

from collections.abc import Callable

from minkref import _core
from minkref.fuzz.geometry.region import Region, region_of_polygons
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import SumOf, WitnessRefuted, settle
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.judgement import too_large
from minkref.fuzz.plane.laws import LAWS, applies
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Outcome, Verdict


def judge_law(
    law: str,
    name: str,
    base: Case,
    before: Answer | None,
    case: Case,
    answer: Answer,
    against_truth: Callable[[], list[Outcome]],
) -> list[Outcome]:
    """Judges by a law. `before` answers `base`, and `answer` the case changed by the law. An exact
    target must keep the law: no expected value is needed, and for a breach, the point that shows
    the breach is decided. A rounding target keeps laws only within its tolerance, so its answer is
    judged `against_truth`."""
    if not applies(law, base):
        what = "the law says nothing of points and segments"
        return [Outcome(name, Verdict.SKIPPED, message=what)]
    related = answer.declaration.exact and not answer.declaration.boundary
    if answer.region is not None and related and (before is None or before.region is not None):
        R = shape_of(before.region.set) if before and before.region else []
        try:
            said = region_of_polygons(LAWS[law].carry(base, R), True)
            outcome = _related(law, name, case, answer, said)
        except _core.LimitExceeded as error:
            outcome = too_large(name, answer, error)
        if outcome is not None:
            return [outcome]
    return [outcome for outcome in against_truth() if outcome.target == name]


def _related(law: str, name: str, case: Case, answer: Answer, said: Region) -> Outcome | None:
    """Returns None if the law is broken, but not by `answer`: the other answer is judged as a case
    of its own."""
    got = answer.region
    assert got is not None
    if got.digest != said.digest:
        try:
            settled = settle(SumOf(case), said, got)
        except WitnessRefuted as error:
            return Outcome(name, Verdict.UNDECIDED, message=f"the referee fails: {error}")
        if settled.claim is not None:
            return Outcome(
                name,
                Verdict.WRONG,
                tuple(settled.reasons),
                message=f"breaks the law {law}: {LAWS[law].title}",
                seconds=answer.seconds,
                witness=settled.claim,
                digest=got.digest,
                expected_digest=said.digest,
                got=got.json,
            )
        if not LAWS[law].contains or _core.inner_point(_core.minus(said.set, got.set)) is not None:
            return None
    return Outcome(name, Verdict.PASS, seconds=answer.seconds, digest=got.digest)
