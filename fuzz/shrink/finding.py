"""A finding made small."""

from __future__ import annotations

from dataclasses import dataclass, replace

from minkref.fuzz.cases.verbs import REJECTS
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.run.runner import Finding, verb_of
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.setting import SmallCase
from minkref.fuzz.settings import small_case
from minkref.fuzz.shrink.asker import Asker, same_fault
from minkref.fuzz.shrink.shrinker import MOST_CALLS, shrink
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict


@dataclass(frozen=True)
class SmallFinding:
    """The shrunk case as a text that names it, and the target's outcome there. `stable`: asked
    again, the target showed the fault again."""

    literal: str
    result: CaseResult
    outcome: Outcome
    calls: int
    complete: bool
    stable: bool
    seconds: float | None = None  # for a time-out: the limit of the calls that made it small


BRIEF = (0.25, 1.0)  # seconds


def brief(limits: Limits) -> Limits:
    """For a target that does not answer: a tenth of the seconds, though not less or more than BRIEF
    and never more than before; once each time. A case found so is asked again as usual."""
    least, most = BRIEF
    seconds = min(limits.seconds, max(least, min(most, limits.seconds / 10)))
    return replace(limits, seconds=seconds, tries=1)


def shrink_finding(
    finding: Finding, catalogue: Catalogue, limits: Limits, most_calls: int = MOST_CALLS
) -> SmallFinding | None:
    """The smallest case found with the same fault: verdict, reasons, signal. None where the fault
    does not show again in a fresh process. After a time-out, smaller cases are asked about with
    the limits of `brief`, and the smallest with the limits of the run."""
    literal = finding.case.literal
    if literal is None or finding.case.P is None or finding.case.Q is None:
        return None
    if verb_of(finding.case.name.text) == REJECTS:  # no smaller operands are known to be invalid
        return None
    silent = Verdict.TIMED_OUT in (finding.outcome.verdict, finding.outcome.was)
    used = brief(limits) if silent else limits
    with Asker(finding.outcome.target, catalogue, used) as asker:
        first = asker.ask(literal)
        if not same_fault(finding.outcome, first[1]):
            return None
        kept = first

        def still(case: SmallCase) -> bool:
            nonlocal kept
            asked = asker.ask(case.literal)
            if same_fault(finding.outcome, asked[1]):
                kept = asked
                return True
            return False

        case = finding.case
        small, smaller = small_case(
            case.dimension, finding.case.P, finding.case.Q, case.scale, literal
        )
        made = shrink(small, smaller, still, most_calls)
        again = asker.ask(kept[0].name.text) if not silent else None
    if again is None:
        with Asker(finding.outcome.target, catalogue, limits) as asker:
            again = kept = asker.ask(kept[0].name.text)
        if not same_fault(finding.outcome, again[1]):
            return None
    result, outcome = kept
    assert outcome is not None
    return SmallFinding(
        result.name.text,
        result,
        outcome,
        made.calls,
        made.complete,
        same_fault(finding.outcome, again[1]),
        used.seconds if silent else None,
    )
