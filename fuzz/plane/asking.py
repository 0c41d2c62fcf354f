"""Targets asked about a case in the plane."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

from minkref.fuzz.cases.verbs import EVENTS, PAIR_EVENTS, UPDATE
from minkref.fuzz.plane.asked_events import asked_events
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.event_judgement import MOST_PAIRS, judge_events, window, without_scales
from minkref.fuzz.plane.judgement import TRUTHS, judge
from minkref.fuzz.plane.law_judgement import judge_law
from minkref.fuzz.plane.laws import LAWS
from minkref.fuzz.plane.reference import ReferenceTarget
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import REFERENCE, Answer, skipped
from minkref.fuzz.targets.asking import JUDGING, Asking, is_asked_again
from minkref.fuzz.verdicts.verdict import BROKEN, GOOD, Outcome, Reason, Verdict


@dataclass
class PlaneAsking(Asking):
    """Asks a route of the reference, too; if answers differ, a point settles the case."""

    def outcomes(self, names: list[str]) -> list[Outcome]:
        if not names:
            return []
        if self.case.law is not None:
            return self._by_law(self.case, names)
        for name in dict.fromkeys([*TRUTHS, *names]):
            if name not in names and any(answer.region for answer in self.answers.values()):
                continue  # one own route is truth enough until somebody disagrees
            self.answers[name] = self._ask(name, self.case)
        outcomes = self._judged(self.case, self.answers, names)
        return [self._once_more(self.case, outcome) for outcome in outcomes]

    def coverage(self) -> str | None:
        """Returns family, position of the scale, shape of the sum, needs. None if none of our
        routes has a sum."""
        case: Case = self.case
        if case.law is not None:
            return None
        region = next((self.answers[n].region for n in TRUTHS if n in self.answers), None)
        if region is None:
            return None
        shape = f"{min(region.components, 3)} {min(region.holes, 4)}"
        return "|".join([case.family, case.position, shape, " ".join(sorted(case.needs))])

    def expected(self, outcomes: list[Outcome]) -> str | None:
        """Returns the sum as canonical JSON by an unrefuted route."""
        wrong = {outcome.target for outcome in outcomes if outcome.verdict is Verdict.WRONG}
        regions = (
            self.answers[name].region
            for name in TRUTHS
            if name in self.answers and name not in wrong
        )
        return next((region.json for region in regions if region), None)

    def _ask(self, name: str, case: Case) -> Answer:
        if name in self.lost:
            lost = self.lost[name]
            return Answer(
                verdict=lost.verdict, message=lost.message, signal=lost.signal, seconds=lost.seconds
            )
        target = self.target(name)
        limit = target.most_pairs and (self.limits.size or target.most_pairs)
        if limit is not None and case.vertex_pairs > limit:
            pairs = f"{case.vertex_pairs:,} pairs of vertices"
            return skipped(f"{pairs}, more than {limit:,} (--size-limit)")
        return self._in_time(name, lambda: target.sum(case))

    def _once_more(self, case: Case, outcome: Outcome) -> Outcome:
        """Repeats the question after a wrong answer, and after some right answers, to see whether
        the answer stays."""
        name = outcome.target
        if name.startswith(REFERENCE) or name not in self.answers:
            return outcome
        if not is_asked_again(case, outcome):
            return outcome
        second = self._ask(name, case)
        if second.digest is None and outcome.verdict not in GOOD:
            return outcome
        if second.digest is not None and second.digest == outcome.digest:
            return outcome
        rejudged = self._judged(case, {**self.answers, name: second}, [name])
        for worse in (outcome, *rejudged):
            if worse.target == name and worse.verdict is Verdict.WRONG:
                return replace(worse, reasons=(*worse.reasons, Reason.NONDETERMINISTIC))
        return next((each for each in rejudged if each.verdict in BROKEN), outcome)

    def _judged(self, case: Case, answers: dict[str, Answer], names: list[str]) -> list[Outcome]:
        judged = {name: self._judgeable(name, answer) for name, answer in answers.items()}
        return judge(case, judged, names, self._judging)

    def _by_law(self, case: Case, names: list[str]) -> list[Outcome]:
        assert case.law is not None
        law, base = case.law
        outcomes = []
        for name in names:
            if law == UPDATE:
                outcomes.append(self._updated(name, base, case))
                continue
            if law in (EVENTS, PAIR_EVENTS):
                outcomes.append(self._events(name, law, case))
                continue
            answer = self._ask(name, case)
            before = None if LAWS[law].constant else self._ask(name, base)
            answer = self._judgeable(name, answer)
            self._judging(name)
            against_truth = partial(self._against_truth, case, name, answer)
            outcomes += judge_law(law, name, base, before, case, answer, against_truth)
        return outcomes

    def _against_truth(self, case: Case, name: str, answer: Answer) -> list[Outcome]:
        answers = {TRUTHS[0]: self._ask(TRUTHS[0], case), name: answer}
        return self._judged(case, answers, [name])

    def _updated(self, name: str, base: Case, case: Case) -> Outcome:
        """Compares the sum by `update` with a fresh sum and the truth."""
        if name in self.lost:
            return self.lost[name]
        target = self.target(name)
        if not isinstance(target, AdapterTarget | ReferenceTarget):
            message = "does not declare update"
            return Outcome(name, Verdict.SKIPPED, message=message)
        self.begin(name)
        updated = target.updated_sum(base, case)
        judged = self._against_truth(case, name, updated)
        (outcome,) = (o for o in judged if o.target == name)
        if outcome.verdict is not Verdict.WRONG:
            return outcome
        fresh = self._ask(name, case)
        if fresh.region is None or fresh.region.digest != outcome.digest:
            return replace(outcome, reasons=(*outcome.reasons, Reason.STATE_DRIFT))
        return outcome

    def _events(self, name: str, verb: str, case: Case) -> Outcome:
        """Judges the scales of events that a target lists."""
        if name in self.lost:
            return self.lost[name]
        target = self.target(name)
        if not isinstance(target, AdapterTarget):
            return Outcome(name, Verdict.SKIPPED, message=f"does not declare {verb}")
        if case.vertex_pairs > MOST_PAIRS:
            message = f"{case.vertex_pairs:,} pairs of vertices, more than {MOST_PAIRS:,}"
            return Outcome(name, Verdict.SKIPPED, message=message)
        if not (case.P.is_region or case.Q.is_region):
            message = "of two operands without area no events are known"
            return Outcome(name, Verdict.SKIPPED, message=message)
        self.begin(name)
        claimed = asked_events(target, case, verb, *window(case))
        if isinstance(claimed, Answer):
            return without_scales(case, name, claimed)
        if JUDGING + name in self.lost:
            return without_scales(case, name, self._judgeable(name, Answer()))
        self._judging(name)
        scales, declared = claimed
        if declared.boundary:
            message = "of the sum of the boundaries no events are known"
            return Outcome(name, Verdict.SKIPPED, message=message)
        return judge_events(case, name, scales, declared, verb)
