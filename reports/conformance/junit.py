"""The verdicts as JUnit XML: a suite for each target, a test case for each family of cases."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections import Counter

from minkref.errors import cut
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.run.runner import Cell, Run
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import BROKEN, Verdict
from minkref.output.terminal import escaped
from minkref.reports.conformance.run_words import cell_text, describe

Kind = tuple[str, str, tuple[str, ...]]


def junit(run: Run, groups: list[Group], walls: Isolation | None = None) -> str:
    """JUnit XML: `wrong` is a failure, a broken target an error, `known` and `undecided` are system
    output. Each kind of finding appears once, under its smallest example's family; other families
    refer to that place."""
    root = ElementTree.Element("testsuites", name="minkref verify")
    where: dict[Kind, set[str]] = {}
    for finding in run.findings:
        where.setdefault(finding.kind, set()).add(finding.case.name.group)
    totals: Counter[str] = Counter()
    for target in run.targets:
        suite = ElementTree.SubElement(root, "testsuite", name=target)
        if walls is not None:
            _say(suite, walls)
        counts = Counter({"tests": 0, "failures": 0, "errors": 0, "skipped": 0})
        seconds = 0.0
        for group in run.groups:
            cell = run.matrix.get((target, group))
            if cell is None:
                continue
            found = [
                kind
                for kind in groups
                if kind.example.outcome.target == target
                and group in where.get(kind.example.kind, {kind.example.case.name.group})
            ]
            _test_case(suite, target, group, cell, found, counts)
            seconds += cell.seconds
        _set(suite, counts, seconds)
        suite.set("skipped", str(counts["skipped"]))
        totals.update(counts)
    seconds = sum(cell.seconds for cell in run.matrix.values())
    _set(root, totals, seconds)
    for element in root.iter():
        _make_legal(element)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _say(suite: ElementTree.Element, walls: Isolation) -> None:
    properties = ElementTree.SubElement(suite, "properties")
    for name, value in walls.document().items():
        text = ", ".join(value) if isinstance(value, list) else str(value)
        ElementTree.SubElement(properties, "property", name=f"isolation.{name}", value=text)


def _set(element: ElementTree.Element, counts: Counter[str], seconds: float) -> None:
    for name in ("tests", "failures", "errors"):
        element.set(name, str(counts[name]))
    element.set("time", f"{seconds:.3f}")


def _make_legal(element: ElementTree.Element) -> None:
    """Escapes characters that XML 1.0 forbids or terminals obey."""
    if element.text:
        element.text = _legal(element.text)
    for name, value in element.items():
        element.set(name, _legal(value))


def _legal(text: str) -> str:
    return "\n".join(escaped(line) for line in text.split("\n"))


def _test_case(
    suite: ElementTree.Element,
    target: str,
    group: str,
    cell: Cell,
    found: list[Group],
    counts: Counter[str],
) -> None:
    test = ElementTree.SubElement(
        suite, "testcase", classname=target, name=group, time=f"{cell.seconds:.3f}"
    )
    counts["tests"] += 1
    summary = cell_text(cell).replace("\n", ", ")
    lines = [summary]
    for item in found:
        there = item.example.case.name.group
        kinds = ", ".join(item.example.outcome.kinds)
        lines += describe(item) if there == group else [f"{kinds}: told under {there}"]
    text = "\n".join(lines)
    broken = [verdict for verdict in BROKEN if cell.verdicts[verdict]]
    if cell.verdicts[Verdict.WRONG]:
        counts["failures"] += 1
        ElementTree.SubElement(test, "failure", message=summary, type="wrong").text = text
    elif broken:
        counts["errors"] += 1
        ElementTree.SubElement(test, "error", message=summary, type=str(broken[0])).text = text
    elif set(cell.verdicts) <= {Verdict.SKIPPED}:
        counts["skipped"] += 1
        ElementTree.SubElement(test, "skipped", message=cut("; ".join(cell.skips)))
    else:
        ElementTree.SubElement(test, "system-out").text = text
