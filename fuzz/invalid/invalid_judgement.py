"""The verdict on a target that was given an invalid operand."""

from __future__ import annotations

from minkref.fuzz.invalid.invalid_case import InvalidCase
from minkref.fuzz.plane.judgement import without_answer
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness


def judge_invalid(case: InvalidCase, name: str, answer: Answer) -> Outcome:
    """A target that promises to reject has to say `rejected`; errors, crashes and hangs count as
    for any case. The witness is the point that the reference's own refusal names."""
    if answer.verdict is Verdict.WRONG and answer.region is None:
        return Outcome(name, Verdict.PASS, seconds=answer.seconds)
    if answer.region is None:
        return without_answer(name, answer)
    return Outcome(
        name,
        Verdict.WRONG,
        (Reason.ACCEPTED_INVALID,),
        message=f"{case.kind}: {case.refusal}",
        seconds=answer.seconds,
        witness=Witness(case.place, False) if case.place else None,
        got=answer.region.json,
    )
