"""A target's page: declaration, verdicts by family, skips, findings."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from minkref.errors import cut
from minkref.exact import scientific
from minkref.fuzz.run.runner import Run
from minkref.output.terminal import escaped
from minkref.reports.conformance.counts import Counts, total
from minkref.reports.conformance.finding_page import FindingPage, file_names


@dataclass
class TargetPage:
    """`cells` follow the run's families."""

    name: str
    target: str
    version: str | None
    facts: list[tuple[str, str]]
    cells: list[Counts]
    total: Counts
    findings: list[FindingPage] = field(default_factory=list)

    @property
    def title(self) -> str:
        return escaped(self.target)

    def rows(self, families: list[tuple[str, int]]) -> list[tuple[str, int, Counts]]:
        """Family, its cases, counts; at the end all families."""
        each = [
            (name, count, cell) for (name, count), cell in zip(families, self.cells, strict=True)
        ]
        return [*each, ("all", self.total.cases, self.total)]


def target_pages(run: Run, value: dict[str, Any], findings: list[FindingPage]) -> list[TargetPage]:
    rows = {row["name"]: row for row in value["targets"]}
    pages = []
    for target, name in zip(run.targets, file_names(run.targets), strict=True):
        row = rows.get(target)
        cells = [total([(run.matrix.get((target, g)), run.cases[g])]) for g in run.groups]
        whole = total((run.matrix.get((target, g)), run.cases[g]) for g in run.groups)
        own = [finding for finding in findings if finding.target == target]
        version = row["version"] if row else None
        pages.append(TargetPage(name, target, version, facts_of(row), cells, whole, own))
    return pages


def facts_of(row: dict[str, Any] | None) -> list[tuple[str, str]]:
    """The target's declaration in words."""
    if row is None:
        return [("declaration", "not among the chosen targets: it was found wrong on the way")]
    sums = {
        "region": "of the regions: all p + q of the closed sets",
        "boundary": "of the boundaries: p and q on the outlines alone",
    }
    absolute, relative = row["tolerance"]["absolute"], row["tolerance"]["relative"]
    tolerance = "none: the result has to be the sum, exactly"
    if row["arithmetic"] != "exact" or absolute != "0" or relative != "0":
        tolerance = (
            f"{_number(absolute)} + {_number(relative)} times the largest coordinate of sP plus "
            "that of Q, in each coordinate"
        )
    if "radius" in row["tolerance"]:
        tolerance += f"; of an offset also {_number(row['tolerance']['radius'])} times the radius"
    return [
        ("version", row["version"] or "not known"),
        ("sum", sums.get(row["sum"], row["sum"])),
        ("arithmetic", row["arithmetic"]),
        ("tolerance", tolerance),
        ("capabilities", ", ".join(row["capabilities"])),
    ]


def _number(text: str) -> str:
    return text if len(text) < 6 else f"{cut(text)} (about {scientific(text)})"
