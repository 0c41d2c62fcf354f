"""The verdict on an answer in space."""

from __future__ import annotations

from dataclasses import replace

from minkref.errors import cut
from minkref.fuzz.plane.judgement import without_answer
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.exact_sum import DEFINITION, EDGES
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict

BY_EDGES = f"minkref:{EDGES}"


def judge_in_space(case: SpaceCase, name: str, answer: Answer) -> Outcome:
    """Judges against the exact sum, or against its points beyond a limit; the route that computes
    the exact sum, against the other route."""
    if answer.verdict is Verdict.WRONG:
        witness = case.some_point()
        return Outcome(
            name,
            Verdict.WRONG,
            (Reason.REJECTED_VALID,),
            message=cut(answer.message),
            seconds=answer.seconds,
            witness=witness,
        )
    if answer.solid is None:
        return without_answer(name, answer)
    declared = answer.declaration
    half = declared.tolerance(case.magnitude)
    pair = replace(case.pair, route=DEFINITION) if name == BY_EDGES else case.pair
    found = compare(pair, case.back(answer.solid), declared.exact, half)
    return Outcome(
        name,
        Verdict(found.verdict),
        tuple(found.reasons),
        message=found.message,
        seconds=answer.seconds,
        witness=found.witness,
        got=answer.solid.to_json() if found.verdict == "wrong" else None,
    )
