"""Other versions of a finding's library, among the run's targets, that may show the finding too."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.shrink.asker import Asker, same_fault
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import GOOD, Verdict

MOST_CASES = 3


@dataclass(frozen=True)
class Presence:
    """Another library version's answer to the cases of a finding."""

    target: str
    version: str
    says: str


def siblings(target: str, value: dict[str, Any]) -> list[tuple[str, str]]:
    """The run's other targets with the same library: `NAME@VERSION`."""
    name = target.partition("@")[0]
    return [
        (row["name"], row["version"] or "")
        for row in value["targets"]
        if row["name"] != target
        and row["name"].startswith("cgal-")
        and row["name"].partition("@")[0] == name
    ]


def presence(group: Group, value: dict[str, Any], limits: Limits) -> list[Presence]:
    """Asks each other version about the finding's cases."""
    example = group.example
    cases = [small.literal for small in group.small[:MOST_CASES]]
    if not cases:
        cases = [example.case.literal or example.case.name.text]
    found = []
    for target, version in siblings(example.outcome.target, value):
        with Asker(target, ALL_TARGETS, limits) as asker:
            asked = [asker.ask(text)[1] for text in cases]
        there = sum(same_fault(example.outcome, outcome) for outcome in asked)
        fine = sum(outcome is not None and outcome.verdict in GOOD for outcome in asked)
        others = [
            str(outcome.verdict)
            for outcome in asked
            if outcome is not None
            and outcome.verdict not in GOOD
            and not same_fault(example.outcome, outcome)
        ]
        parts = []
        if there:
            parts.append(f"still present: the same fault on {there} of {len(cases)} cases")
        if fine:
            parts.append(f"right on {fine} of {len(cases)} cases")
        if others:
            parts.append(f"otherwise: {', '.join(others)}")
        if fine == len(cases):
            parts = [f"fixed: right on {fine} of {len(cases)} cases"]
        if not parts:
            parts = [str(Verdict.UNDECIDED)]
        found.append(Presence(target, version, "; ".join(parts)))
    return found
