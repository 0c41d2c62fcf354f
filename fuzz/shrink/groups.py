"""A run's findings by kind, each kind shown by different shrunk cases."""

from __future__ import annotations

import signal
from collections.abc import Callable
from dataclasses import dataclass, field

from minkref.errors import message_of
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.run.runner import Finding, Run
from minkref.fuzz.shrink.finding import SmallFinding, shrink_finding
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from minkref.output.signals import Ended

EXAMPLES = 3  # findings shrunk per kind; one for a known fault
UNSHRUNK = (Verdict.GAVE_UP, Verdict.UNDECIDED)  # no fault is shown
CALLS_FOR_KNOWN = 150
CALLS_FOR_MEMORY = 60  # for a target that exhausts its memory
CALLS_FOR_TIME_OUT = 12  # for a target that does not answer, each as long as `brief` says


@dataclass
class Group:
    """All findings for one target, verdict and reasons. `example` is the smallest, `small` holds
    the shrunk findings, without repetition. `also`: reasons from further findings shrinking to the
    same case."""

    example: Finding
    count: int
    unshrunk: str = ""  # why our shrinking failed
    small: list[SmallFinding] = field(default_factory=list)
    also: list[str] = field(default_factory=list)


def groups_of(run: Run) -> list[Group]:
    """The most serious first."""
    return [Group(finding, count) for finding, count in run.smallest()]


def shrunk_groups(
    run: Run,
    catalogue: Catalogue,
    limits: Limits,
    most_calls: int = MOST_CALLS,
    progress: Callable[[str], None] = lambda _: None,
) -> list[Group]:
    """Shrinks the smallest findings of each kind. Deterministic: limits calls, not time. Our own
    failure leaves a finding unshrunk, and the group says so; a signal leaves all other findings
    unshrunk, and the run says so."""
    groups = groups_of(run)
    if run.ended is not None or run.failed is not None:
        return groups
    try:
        _shrink_all(run, groups, catalogue, limits, most_calls, progress)
    except KeyboardInterrupt:
        run.ended = int(signal.SIGINT)
    except Ended as ended:
        run.ended = ended.number
    return merged(groups)


def _shrink_all(
    run: Run,
    groups: list[Group],
    catalogue: Catalogue,
    limits: Limits,
    most_calls: int,
    progress: Callable[[str], None],
) -> None:
    for group in groups:
        outcome = group.example.outcome
        if outcome.verdict in UNSHRUNK or most_calls <= 0:
            continue
        calls, examples = bounds(outcome, most_calls)
        same = [finding for finding in run.findings if finding.kind == group.example.kind]
        same.sort(key=lambda finding: finding.case.size)
        progress(f"shrinking: {outcome.target} {' '.join(outcome.kinds)}")
        for finding in same[:examples]:
            try:
                small = shrink_finding(finding, catalogue, limits, calls)
            except Exception as error:  # noqa: BLE001 a fault of ours costs no finding
                group.unshrunk = message_of(error).splitlines()[0]
                continue
            if small is not None and small.literal not in {s.literal for s in group.small}:
                group.small.append(small)
        group.small.sort(key=lambda small: small.result.size)


def bounds(outcome: Outcome, most_calls: int) -> tuple[int, int]:
    """Bounds the calls for one finding, and the number of findings: fewer for slow calls."""
    faults = (outcome.verdict, outcome.was)
    if Verdict.TIMED_OUT in faults:
        return min(most_calls, CALLS_FOR_TIME_OUT), 1
    if Verdict.OUT_OF_MEMORY in faults:
        return min(most_calls, CALLS_FOR_MEMORY), 1
    if outcome.verdict is Verdict.KNOWN:
        return min(most_calls, CALLS_FOR_KNOWN), 1
    return most_calls, EXAMPLES


def merged(groups: list[Group]) -> list[Group]:
    """Merges groups with the same target and verdict that shrink to a common case: they have one
    cause."""
    kept: list[Group] = []
    for group in groups:
        literals = {small.literal for small in group.small}
        verdict = group.example.outcome.verdict
        same = next(
            (
                other
                for other in kept
                if other.example.outcome.target == group.example.outcome.target
                and other.example.outcome.verdict is verdict
                and literals & {small.literal for small in other.small}
            ),
            None,
        )
        if same is None:
            kept.append(group)
        else:
            same.count += group.count
            same.also.append(" ".join(group.example.outcome.kinds))
            have = {small.literal for small in same.small}
            same.small += [small for small in group.small if small.literal not in have]
    return kept
