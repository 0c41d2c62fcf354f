"""The differential run: cases through workers, verdicts into a matrix and a list of findings."""

from __future__ import annotations

import shlex
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from minkref.fuzz.cases.verbs import (
    EVENTS,
    FEATURES,
    OFFSET,
    PAIR_EVENTS,
    PATH,
    RANGES,
    REJECTS,
    UNION,
    UPDATE,
    is_features,
    is_offset,
    is_path,
    is_union,
)
from minkref.fuzz.invalid.invalid_case import FAMILY as INVALID
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.plane.judgement import REFEREE
from minkref.fuzz.run.case_list import CaseList, Wait
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.pool import InternalError, run_cases
from minkref.fuzz.run.resting import Resting
from minkref.fuzz.run.worker import CaseResult, Job
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import BROKEN, GOOD, Outcome, Verdict
from minkref.output.exits import ExitCode
from minkref.output.signals import OUT_OF_TIME, Ended, Stoppable


@dataclass(frozen=True)
class Finding:
    """Whatever is neither a pass nor a skip, with the case it happened on."""

    outcome: Outcome
    case: CaseResult

    @property
    def kind(self) -> tuple[str, str, tuple[str, ...]]:
        """Findings of equal kind appear once, by the smallest."""
        return (self.outcome.target, str(self.outcome.verdict), self.outcome.kinds)

    @property
    def reproduce(self) -> str:
        named = () if self.outcome.target == REFEREE else (self.outcome.target,)
        return shlex.join(["minkref", "verify", *named, "--case", self.case.name.text])


@dataclass
class Cell:
    """A target's results for one group of cases."""

    verdicts: Counter[str] = field(default_factory=Counter)
    skips: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0


@dataclass
class Run:
    targets: list[str]
    groups: list[str] = field(default_factory=list)
    matrix: dict[tuple[str, str], Cell] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    cases: Counter[str] = field(default_factory=Counter)
    began: dict[str, int] = field(default_factory=dict)  # the first case of each group
    asked: Counter[tuple[str, str, int]] = field(default_factory=Counter)  # target, verb, dimension
    met: Counter[tuple[str, str, int]] = field(default_factory=Counter)  # and what cases needed
    ended: int | None = None  # the signal that ended the run, or OUT_OF_TIME
    failed: str | None = None  # our fault that ended the run
    absent: int = 0  # derived cases that do not exist, as probes of a pair without events
    untaken: Counter[str] = field(default_factory=Counter)  # why no target takes a generated case
    resting: dict[str, str] = field(default_factory=dict)  # target: the case it last did not answer
    remarks: dict[str, list[tuple[int, str]]] = field(default_factory=dict)  # a pass's assumptions

    def smallest(self) -> list[tuple[Finding, int]]:
        """The smallest finding of each kind, with the count; the most serious first."""
        counts = Counter(finding.kind for finding in self.findings)
        best: dict[tuple[str, str, tuple[str, ...]], Finding] = {}
        for finding in self.findings:
            known = best.get(finding.kind)
            if known is None or finding.case.size < known.case.size:
                best[finding.kind] = finding
        order = list(Verdict)
        return sorted(
            ((finding, counts[kind]) for kind, finding in best.items()),
            key=lambda item: (order.index(item[0].outcome.verdict), item[0].kind),
        )

    def exit_code(self, strict: bool = False) -> int:
        """Returns an ExitCode; or 128 plus the number of the signal that ended the run. A time
        limit that ended the run changes nothing."""
        if self.failed is not None:
            return ExitCode.INTERNAL
        if self.ended not in (None, OUT_OF_TIME):
            return 128 + self.ended
        verdicts = {finding.outcome.verdict for finding in self.findings}
        if Verdict.WRONG in verdicts:
            return ExitCode.WRONG
        if not sum(self.cases.values()) or not self._ran():
            return ExitCode.USAGE
        if verdicts & set(BROKEN):
            return ExitCode.BROKEN
        if strict and verdicts & {Verdict.UNDECIDED, Verdict.GAVE_UP}:
            return ExitCode.UNDECIDED
        return ExitCode.ALL_WELL

    def _ran(self) -> bool:
        """Whether anything other than skips happened."""
        return any(
            count
            for cell in self.matrix.values()
            for verdict, count in cell.verdicts.items()
            if verdict != Verdict.SKIPPED
        )


def verb_of(text: str) -> str:
    """Returns the capability that a case's name asks for, or the verb `at`."""
    verbs = {f"{verb}(": verb for verb in (UPDATE, EVENTS, PAIR_EVENTS)}
    verbs |= {f"{INVALID}:": REJECTS}
    verbs |= {f"{RANGES}:": RANGES, f"{RANGES}-": RANGES, f"{PATH}:": PATH, f"{PATH}-grid": PATH}
    verbs |= {f"{UNION}:": UNION, f"{UNION}-": UNION}
    verbs |= dict.fromkeys((f"{family}:" for family in OFFSETS.families), OFFSET)
    verbs |= {f"{FEATURES}:": FEATURES, f"{FEATURES}-": FEATURES}
    if is_union(text):
        return UNION
    if is_offset(text):
        return OFFSET
    if is_features(text):
        return FEATURES
    if is_path(text):
        return PATH if '"scales"' in text else RANGES
    return next((verb for start, verb in verbs.items() if text.startswith(start)), "at")


def run(
    cases: CaseList,
    targets: list[str],
    catalogue: Catalogue,
    versions: dict[str, str | None],
    baseline: Baseline,
    limits: Limits,
    jobs: int,
    progress: Callable[[Run], None] = lambda _: None,
    ledger: Ledger | None = None,
    first: bool = False,
) -> Run:
    """Runs all cases. With `cases.pairs` the verdicts do not depend on `jobs`: results are taken in
    the order of cases. Cases in the ledger are not run again; every result enters the ledger before
    it is shown. `first`: ends with the first case that shows an unknown wrong or broken target.
    Unresponsive targets rest, unless the cases are named. SIGINT, SIGTERM, SIGHUP, a time limit
    and our own faults end the run: the result holds all cases judged until then, and `ended` or
    `failed` says so."""

    def ask(wanted: Iterator[Job | Wait]) -> Iterator[CaseResult]:
        return run_cases(wanted, targets, catalogue, limits, jobs)

    return run_asking(ask, cases, targets, versions, baseline, progress, ledger, first)


def run_asking(
    ask: Callable[[Iterator[Job | Wait]], Iterator[CaseResult]],
    cases: CaseList,
    targets: list[str],
    versions: dict[str, str | None],
    baseline: Baseline,
    progress: Callable[[Run], None] = lambda _: None,
    ledger: Ledger | None = None,
    first: bool = False,
    keep: Callable[[CaseResult], None] = lambda _: None,
) -> Run:
    """Runs all cases by `ask`. `keep` gets each result as it counts, in the order of cases."""
    done = Run(list(targets))
    resting = Resting([] if cases.named else targets, done.resting)
    waiting: dict[int, CaseResult] = {}
    number = 0

    def is_over() -> bool:
        amiss = (Verdict.WRONG, *BROKEN)
        return resting.is_over or (
            first and any(finding.outcome.verdict in amiss for finding in done.findings)
        )

    def take_next(result: CaseResult) -> None:
        result = resting.applied(result)
        keep(result)
        take(done, result, versions, baseline)
        if not result.is_run:
            cases.miss()
        cases.learn(result.number, result.name.text, coverage_of(result))
        resting.note(result)

    with Stoppable() as stoppable:

        def receive(result: CaseResult, ledger: Ledger | None = None) -> None:
            nonlocal number
            with stoppable.held():
                if ledger is not None:
                    ledger.write(result)
                waiting[result.number] = result
                while number in waiting and not is_over():
                    take_next(waiting.pop(number))
                    number += 1
            progress(done)

        try:
            for result in ask(_jobs(cases, ledger, receive, done.resting)):
                receive(result, ledger)
                if is_over():
                    break
        except Ended as ended:
            done.ended = ended.number
        except InternalError as error:
            done.failed = str(error)
        try:
            with stoppable.held():  # results after a case without result
                for _, result in sorted(waiting.items()):
                    if not is_over():
                        take_next(result)
        except Ended as ended:
            done.ended = ended.number
    done.findings.sort(key=lambda finding: (finding.outcome.target, finding.case.number))
    done.groups.sort(key=lambda group: done.began[group])
    return done


def coverage_of(result: CaseResult) -> str | None:
    """Returns the case's coverage, with all faults."""
    if result.coverage is None:
        return None
    amiss = sorted(
        f"{outcome.target} {' '.join(outcome.kinds)}"
        for outcome in result.outcomes
        if outcome.verdict not in (*GOOD, Verdict.SKIPPED)
    )
    return "|".join([result.coverage, *amiss])


def _jobs(
    cases: CaseList,
    ledger: Ledger | None,
    take: Callable[[CaseResult], None],
    resting: Mapping[str, str],
) -> Iterator[Job | Wait]:
    number = 0
    for name in cases:
        if isinstance(name, Wait):
            yield name
            continue
        known = ledger.result(number, name) if ledger is not None else None
        if known is not None:
            take(known)
        else:
            yield Job(number, name, cases.derived, cases.generating, frozenset(resting))
        number += 1


def take(
    done: Run, result: CaseResult, versions: dict[str, str | None], baseline: Baseline
) -> None:
    """Adds a result to a run."""
    if result.absent is not None:
        done.absent += 1
        return
    if result.untaken is not None:
        done.untaken[result.untaken] += 1
        return
    group = result.name.group
    if group not in done.groups:
        done.groups.append(group)
    done.cases[group] += 1
    done.began[group] = min(done.began.get(group, result.number), result.number)
    for outcome in result.outcomes:
        judged = baseline.apply(outcome, versions.get(outcome.target))
        cell = done.matrix.setdefault((outcome.target, group), Cell())
        cell.verdicts[str(judged.verdict)] += 1
        cell.seconds += judged.seconds
        if judged.verdict is not Verdict.SKIPPED:
            done.asked[outcome.target, verb_of(result.name.text), result.dimension] += 1
            done.met.update((outcome.target, need, result.dimension) for need in result.needs)
        if judged.verdict is Verdict.SKIPPED:
            cell.skips[judged.message] += 1
        elif judged.verdict not in GOOD:
            done.findings.append(Finding(judged, result))
        elif judged.message:
            remark = (result.number, f"{result.name.text}: {judged.message}")
            done.remarks.setdefault(outcome.target, []).append(remark)
        if outcome.target not in done.targets:
            done.targets.append(outcome.target)
