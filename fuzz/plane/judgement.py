"""The verdicts on all targets on one case."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from minkref import _core
from minkref.errors import cut
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.boundary_sum import MOST_PAIRS, boundary_sum
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import Definition, SumOf, WitnessRefuted, settle, some_point
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

TRUTHS = tuple(f"minkref:{route}" for route in _core.ROUTES)
REFEREE = "minkref:referee"  # decides single points; named only when it fails
DOUBT = "the decision of a point is refuted by plain fractions"


def judge(
    case: Case,
    answers: dict[str, Answer],
    targets: list[str],
    judging: Callable[[str], None] = lambda name: None,
) -> list[Outcome]:
    """Returns an outcome for each of `targets`, and for each refuted route of ours, selected or
    not. An unrefuted route is the truth; without such a route, others are undecided. `judging`
    hears the name of the next target."""
    outcomes = _judge(case, answers, {}, judging)
    chosen = set(targets) | {
        name for name, outcome in outcomes.items() if outcome.verdict is Verdict.WRONG
    }
    judged = [outcome for name, outcome in outcomes.items() if name in chosen]
    doubted = [
        outcome.message for outcome in outcomes.values() if outcome.message.startswith(DOUBT)
    ]
    if doubted:
        judged.append(Outcome(REFEREE, Verdict.ERRORED, message=doubted[0]))
    return judged


def _judge(
    case: Case,
    answers: dict[str, Answer],
    refuted: dict[str, tuple[Witness, list[Reason]]],
    judging: Callable[[str], None],
) -> dict[str, Outcome]:
    while True:
        truth = next(
            (
                name
                for name in TRUTHS
                if name in answers and answers[name].region and name not in refuted
            ),
            None,
        )
        if truth is None:
            message = "no route of the reference has an answer that stands"
            return {
                name: _refuted(name, answer, *refuted[name], None)
                if name in refuted
                else undecided(name, answer, message)
                for name, answer in answers.items()
            }
        outcomes = _against(case, answers, truth, refuted, judging)
        if outcomes is not None:
            return outcomes


def _against(
    case: Case,
    answers: dict[str, Answer],
    truth: str,
    refuted: dict[str, tuple[Witness, list[Reason]]],
    judging: Callable[[str], None],
) -> dict[str, Outcome] | None:
    """Returns all outcomes, taking the result of `truth` as the sum; None if this truth is itself
    refuted."""
    expected = answers[truth].region
    assert expected is not None
    outcomes: dict[str, Outcome] = {}
    for name, answer in answers.items():
        judging(name)
        try:
            outcome = _one(case, name, answer, expected)
        except WitnessRefuted as error:
            outcome = undecided(name, answer, f"{DOUBT}: {error}")
        except _core.LimitExceeded as error:
            if name in TRUTHS:
                raise
            outcome = too_large(name, answer, error)
        except MemoryError:
            outcome = undecided(name, answer, "there is too little memory to judge the answer")
        if isinstance(outcome, Outcome):
            outcomes[name] = outcome
        else:
            reason = Reason.MISSING if outcome.in_truth else Reason.EXTRA
            refuted[truth] = (outcome, [reason])
            return None
    return outcomes


def _one(case: Case, name: str, answer: Answer, expected: Region) -> Outcome | Witness:
    """The outcome for one target, or the witness that refutes the expected region."""
    region, declared = answer.region, answer.declaration
    if answer.verdict is Verdict.WRONG:
        return rejected(name, answer, some_point(case), expected)
    if region is None:
        return without_answer(name, answer)
    if declared.boundary:
        pairs = case.vertex_pairs
        if pairs > MOST_PAIRS:
            what = f"{pairs:,} pairs of edges, more than {MOST_PAIRS:,}"
            message = f"the sum of the boundaries is not computed for {what}"
            return Outcome(name, Verdict.SKIPPED, message=message)
        expected = boundary_sum(case)
    defined = SumOf(case, declared.boundary)
    found = compared(name, answer, expected, defined, declared.tolerance(case.magnitude))
    if isinstance(found, Witness) and declared.boundary:
        return undecided(name, answer, "the sum of the boundaries is in doubt")
    return found


def compared(
    name: str, answer: Answer, expected: Region, defined: Definition, half: Fraction
) -> Outcome | Witness:
    """The outcome for a target whose answer is a set, which may be off by `half` in each
    coordinate; or the witness that refutes the expected region."""
    region = answer.region
    assert region is not None
    if region.digest == expected.digest:
        return _same_set(name, answer, region, defined)
    settled = settle(defined, expected, region, half)
    if settled.truth is not None:
        return settled.truth
    if half and not settled.differ:
        return Outcome(name, Verdict.PASS_WITHIN, seconds=answer.seconds, digest=region.digest)
    if settled.claim is None:
        return undecided(name, answer, "no point tells the results apart")
    reasons = settled.reasons
    if region.overlap is not None and answer.declaration.exact:
        reasons = [*reasons, Reason.SELF_INTERSECTING]
    return _refuted(name, answer, settled.claim, reasons, expected)


def _same_set(name: str, answer: Answer, region: Region, defined: Definition) -> Outcome:
    """The right set of points; the rings of exact results may still be badly made."""
    if not answer.declaration.exact:
        return Outcome(name, Verdict.PASS, seconds=answer.seconds, digest=region.digest)
    for point, reason in (
        (region.degenerate, Reason.NOT_CLOSED),
        (region.overlap, Reason.SELF_INTERSECTING),
    ):
        if point is not None:
            return _refuted(name, answer, defined.decide(point), [reason], region)
    return Outcome(name, Verdict.PASS, seconds=answer.seconds, digest=region.digest)


def rejected(name: str, answer: Answer, witness: Witness, expected: Region) -> Outcome:
    """Valid operands called invalid: any decided point shows that there is a right answer."""
    return Outcome(
        name,
        Verdict.WRONG,
        (Reason.REJECTED_VALID,),
        message=cut(answer.message),
        seconds=answer.seconds,
        witness=witness,
        expected_digest=expected.digest,
    )


def _refuted(
    name: str, answer: Answer, witness: Witness, reasons: list[Reason], expected: Region | None
) -> Outcome:
    region = answer.region
    assert region is not None
    return Outcome(
        name,
        Verdict.WRONG,
        tuple(reasons),
        seconds=answer.seconds,
        witness=witness,
        digest=region.digest,
        expected_digest=expected.digest if expected else None,
        got=region.json,
    )


def too_large(name: str, answer: Answer, error: Exception) -> Outcome:
    message = cut(f"the answer is too large to be judged: {error}")
    return Outcome(name, Verdict.ERRORED, message=message, seconds=answer.seconds)


def without_answer(name: str, answer: Answer) -> Outcome:
    return Outcome(
        name,
        answer.verdict or Verdict.ERRORED,
        message=cut(answer.message),
        signal=answer.signal,
        seconds=answer.seconds,
        log=answer.log,
    )


def undecided(name: str, answer: Answer, message: str) -> Outcome:
    if answer.region is None:
        return without_answer(name, answer)
    return Outcome(
        name,
        Verdict.UNDECIDED,
        message=message,
        seconds=answer.seconds,
        digest=answer.region.digest,
        got=answer.region.json,
    )
