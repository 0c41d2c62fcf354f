"""The conformance report: static pages that link to each other, all pages in one file, and
stand-alone programs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref.fuzz.run.runner import Run
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.output.documents import write_together
from minkref.output.terminal import escaped
from minkref.reports.conformance.finding_page import FindingPage, finding_pages
from minkref.reports.conformance.run_words import conclusion, left_out
from minkref.reports.conformance.showcase import showcases
from minkref.reports.conformance.space_showcase import SpaceShowcase
from minkref.reports.conformance.target_page import TargetPage, target_pages
from minkref.reports.conformance.words import SIGNS, VERDICTS, ending
from minkref.reports.pages import environment

ONE_FILE = "report.html"
FRONT = "index.html"
NO_LIMITS = Limits()


def write_report(
    folder: Path,
    run: Run,
    groups: list[Group],
    value: dict[str, Any],
    limits: Limits = NO_LIMITS,
    again: str = "",
    solids: Sequence[SpaceShowcase] = (),
) -> Path:
    """Writes `index.html`, a page for each target and each kind of finding, `report.html` with
    everything, a program for each case that has one, and a certificate for each witness that has
    one. `value` is the run's JSON document, whose findings name their certificates afterwards;
    `again` the command that makes the report again, `solids` sums in space to show. Returns the
    front page's path."""
    findings = finding_pages(groups, value, limits)
    targets = target_pages(run, value, findings)
    files = _programs(findings) | _certificates(findings)
    _name_certificates(run, findings, value)
    shared = {**_shared(run, value, targets, findings, again), "solids": solids}
    templates = environment("conformance")

    def page(template: str, **more: Any) -> str:
        return templates.get_template(template).render(**shared, one=False, **more)

    for target in targets:
        files[f"target-{target.name}.html"] = page("target.html.j2", target=target)
    for finding in findings:
        files[f"finding-{finding.name}.html"] = page("finding.html.j2", finding=finding)
    files[ONE_FILE] = templates.get_template("one.html.j2").render(**shared, one=True)
    files[FRONT] = page("index.html.j2")
    write_together({folder / name: text for name, text in files.items()})
    return folder / FRONT


def _programs(findings: list[FindingPage]) -> dict[str, str]:
    return {
        case.program.file: case.program.text
        for finding in findings
        for case in finding.cases
        if case.program is not None
    }


def _certificates(findings: list[FindingPage]) -> dict[str, str]:
    cases = (case for finding in findings for case in finding.cases)
    return {
        name: text
        for case in cases
        if case.certificate is not None
        for name, text in case.certificate.files.items()
    }


def _name_certificates(run: Run, findings: list[FindingPage], value: dict[str, Any]) -> None:
    """Adds `certificate` to the shrunk findings of the document, and to the findings that are shown
    as they were found."""
    shrunk = iter(value["shrunk"])
    as_found = list(zip(run.findings, value["findings"], strict=False))
    for page in findings:
        for case in page.cases:
            rows = [row for finding, row in as_found if finding is case.finding]
            if page.group.small:
                rows = [next(shrunk)]
            if case.certificate is not None:
                for row in rows:
                    row["certificate"] = case.certificate.document()


def _shared(
    run: Run,
    value: dict[str, Any],
    targets: list[TargetPage],
    findings: list[FindingPage],
    again: str,
) -> dict[str, Any]:
    """The values that every page may use."""
    absent: dict[str, list[str]] = {}
    for row in value["absent"]:
        absent.setdefault(escaped(row["reason"] or "not found"), []).append(row["name"])
    return {
        "value": value,
        "conclusion": escaped(conclusion(run)),
        "ending": ending(value["exit_code"]),
        "again": escaped(again),
        "cases": sum(run.cases.values()),
        "families": [(group, run.cases[group]) for group in run.groups],
        "targets": targets,
        "findings": findings,
        "absent": absent,
        "absent_cases": run.absent,
        "left_out": left_out(run).most_common(),
        "notes": [escaped(note) for note in value["notes"]],
        "verdicts": [(str(v), SIGNS[v], VERDICTS[v]) for v in Verdict],
        "showcases": showcases(),
        "target_of": {target.target: target for target in targets},
    }
