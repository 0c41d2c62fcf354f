"""The page about a kind of finding."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from minkref.errors import cut
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from minkref.output.terminal import escaped
from minkref.reports.conformance.bug_report import bug_report
from minkref.reports.conformance.case_view import CaseView, case_views
from minkref.reports.conformance.plane_pictures import Picture
from minkref.reports.conformance.run_words import describe
from minkref.reports.conformance.versions import Presence, presence
from minkref.reports.conformance.words import SIGNS, meaning

LONGEST = 60  # characters of a file name


@dataclass
class FindingPage:
    """`name` names the page and its programs."""

    name: str
    group: Group
    version: str | None
    cases: list[CaseView]
    presence: list[Presence]

    @property
    def outcome(self) -> Outcome:
        return self.group.example.outcome

    @property
    def target(self) -> str:
        return self.outcome.target

    @property
    def verdict(self) -> str:
        return str(self.outcome.verdict)

    @property
    def sign(self) -> str:
        return SIGNS[self.outcome.verdict]

    @property
    def title(self) -> str:
        return describe(self.group)[0]

    @property
    def meanings(self) -> list[tuple[str, str]]:
        return [(kind, meaning(kind)) for kind in self.outcome.kinds]

    @property
    def baseline(self) -> str:
        """The text of the baseline on a known fault."""
        return escaped(self.outcome.message) if self.outcome.verdict is Verdict.KNOWN else ""

    @property
    def message(self) -> str:
        """The message by or about the target."""
        known = self.outcome.verdict is Verdict.KNOWN
        return "" if known else escaped(cut(self.outcome.message))

    @property
    def log(self) -> list[str]:
        return [escaped(line) for line in self.outcome.log.strip()[-2000:].splitlines()]

    @property
    def thumbnail(self) -> Picture | None:
        """The difference, else the first of the panes."""
        panes = self.cases[0].panes
        return panes[min(2, len(panes) - 1)] if panes else None

    @property
    def reports(self) -> list[str]:
        """For each case a text for the library's issue tracker."""
        others = [f"{p.target} {p.version}: {p.says}" for p in self.presence]
        if self.baseline:
            others.append(f"known: {self.baseline}")
        return [bug_report(case, self.version, others) for case in self.cases]


def finding_pages(groups: list[Group], value: dict[str, Any], limits: Limits) -> list[FindingPage]:
    """The most serious first, as the groups are."""
    rows = {row["name"]: row for row in value["targets"]}
    names = file_names(
        f"{group.example.outcome.target}-{'-'.join(group.example.outcome.kinds)}"
        for group in groups
    )
    pages = []
    for group, name in zip(groups, names, strict=True):
        row = rows.get(group.example.outcome.target, {})
        boundary = row.get("sum") == "boundary"
        pages.append(
            FindingPage(
                name,
                group,
                row.get("version"),
                case_views(group, name, boundary),
                presence(group, value, limits),
            )
        )
    return pages


def file_names(texts: Iterable[str]) -> list[str]:
    """Distinct file names made from letters, digits, dots and dashes."""
    found: list[str] = []
    for text in texts:
        plain = re.sub(r"[^A-Za-z0-9.]+", "-", text).strip("-.")[:LONGEST].rstrip("-.") or "unnamed"
        name, number = plain, 1
        while name.lower() in {other.lower() for other in found}:
            number += 1
            name = f"{plain}-{number}"
        found.append(name)
    return found
