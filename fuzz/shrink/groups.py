"""The findings of a run by kind, each kind shown by shrunk cases that differ."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from minkref.fuzz.run.runner import Finding, Run
from minkref.fuzz.shrink.finding import SmallFinding, shrink_finding
from minkref.fuzz.shrink.shrinker import MOST_CALLS
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Verdict

EXAMPLES = 3  # findings of a kind that are shrunk; of a known fault one
CALLS_FOR_KNOWN = 150


@dataclass
class Group:
    """All findings of one target, verdict and reasons. `example` is the smallest, `small` what it
    and others shrink to, without doubles."""

    example: Finding
    count: int
    small: list[SmallFinding] = field(default_factory=list)


def groups_of(run: Run) -> list[Group]:
    """The most serious first."""
    return [Group(finding, count) for finding, count in run.smallest()]


def shrunk_groups(
    run: Run,
    limits: Limits,
    most_calls: int = MOST_CALLS,
    progress: Callable[[str], None] = lambda _: None,
) -> list[Group]:
    """Shrinks the smallest findings of each kind. Deterministic: bounded by calls, not by time."""
    groups = groups_of(run)
    for group in groups:
        outcome = group.example.outcome
        if outcome.verdict is Verdict.UNDECIDED or most_calls == 0:
            continue
        known = outcome.verdict is Verdict.KNOWN
        same = [finding for finding in run.findings if finding.kind == group.example.kind]
        same.sort(key=lambda finding: finding.case.size)
        progress(f"shrinking: {outcome.target} {' '.join(outcome.kinds)}")
        calls = min(most_calls, CALLS_FOR_KNOWN) if known else most_calls
        for finding in same[: 1 if known else EXAMPLES]:
            small = shrink_finding(finding, limits, calls)
            if small is not None and small.literal not in {s.literal for s in group.small}:
                group.small.append(small)
        group.small.sort(key=lambda small: small.result.size)
    return groups
