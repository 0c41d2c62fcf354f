"""Short meanings of verdicts and reasons."""

from __future__ import annotations

from minkref.fuzz.verdicts.verdict import Reason, Verdict

VERDICTS = {
    Verdict.PASS: "the sum, exactly",
    Verdict.PASS_WITHIN: "within the tolerance that the target declares",
    Verdict.WRONG: "not the sum, proven by a point that can be checked by hand",
    Verdict.KNOWN: "a fault listed in the baseline, whatever its verdict was",
    Verdict.ERRORED: "reported an error, or gave something that is not an answer",
    Verdict.CRASHED: "the process of the target died",
    Verdict.TIMED_OUT: "no answer in time",
    Verdict.OUT_OF_MEMORY: "needed more memory than allowed",
    Verdict.GAVE_UP: "says itself that it cannot tell, as where its arithmetic knows no sign",
    Verdict.UNDECIDED: "no point settles whether it is right",
    Verdict.SKIPPED: "not asked, or outside what it declares; not counted in any fraction",
}

REASONS = {
    Reason.MISSING: "points of the sum are not in the result",
    Reason.EXTRA: "the result has points that are not in the sum",
    Reason.HOLE_LOST: "a hole of the sum is filled",
    Reason.HOLE_INVENTED: "the result has a hole where the sum has none",
    Reason.COMPONENT: "a component of the sum is missing, or one is invented",
    Reason.NOT_CLOSED: "a ring or surface that does not enclose anything",
    Reason.SELF_INTERSECTING: "rings of the result overlap, cross or run the wrong way",
    Reason.NOT_CANONICAL: "the right set, but not with the canonical rings",
    Reason.EVENT_MISSED: "an event is not reported",
    Reason.EVENT_INVENTED: "an event is reported where there is none",
    Reason.EVENT_MISPLACED: "an event is reported as another change or in another place",
    Reason.STATE_DRIFT: "a state reached by update differs from the true state",
    Reason.NONDETERMINISTIC: "two answers to the same question differ",
    Reason.ACCEPTED_INVALID: "a result for operands that are invalid",
    Reason.REJECTED_VALID: "valid operands are called invalid",
    Reason.PASSAGE_MISSED: "a tight passage is not reported",
    Reason.PASSAGE_INVENTED: "a tight passage is reported where there is none",
    Reason.BAR_MISSED: "a feature's bar is not reported",
    Reason.BAR_INVENTED: "a bar is reported that the set does not have",
    Reason.BRIDGE_MISSED: "a bridge at the radius is not reported",
    Reason.BRIDGE_INVENTED: "a bridge is reported where there is none",
    Reason.COLLISION_MISSED: "a scale is called valid at which the part collides on the path",
    Reason.COLLISION_INVENTED: "a scale is called not valid at which the part passes",
}

SIGNS = {
    Verdict.PASS: "✓",
    Verdict.PASS_WITHIN: "≈",
    Verdict.WRONG: "✗",
    Verdict.KNOWN: "!",
    Verdict.ERRORED: "E",
    Verdict.CRASHED: "☠",
    Verdict.TIMED_OUT: "⏱",
    Verdict.OUT_OF_MEMORY: "M",
    Verdict.GAVE_UP: "⊘",
    Verdict.UNDECIDED: "?",
    Verdict.SKIPPED: "–",
}


def meaning(kind: str) -> str:
    """The meaning of a reason, or of a bare verdict."""
    reasons = {str(reason): text for reason, text in REASONS.items()}
    verdicts = {str(verdict): text for verdict, text in VERDICTS.items()}
    return reasons.get(kind) or verdicts.get(kind) or kind


def ending(code: int) -> str:
    """An exit code's meaning."""
    return {
        0: "Nothing is wrong, except what the baseline lists.",
        1: "Something is proven wrong.",
        2: "Nothing was run: there was no case, or every target skipped all of them.",
        3: "Something crashed, hung or gave no answer; nothing is proven wrong.",
        4: "Something stays undecided, or is given up.",
    }.get(code, f"Exit code {code}.")
