"""A run's outcome in words and lines, for reports, tables and result files."""

from __future__ import annotations

import re
from collections import Counter

from minkref.fuzz.run.runner import Cell, Finding, Run
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.finding import SmallFinding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import GOOD, Verdict, Witness
from minkref.output.terminal import counted, escaped
from minkref.reports.conformance.feature_words import feature_witness_text
from minkref.reports.conformance.offset_words import offset_witness_text
from minkref.reports.conformance.path_words import path_witness_text
from minkref.reports.conformance.union_words import union_witness_text

LACKING = "does not declare "
LOG_SHOWN = 400  # characters
_NOTHING_AMISS = (*GOOD, Verdict.SKIPPED)


def cell_text(cell: Cell | None) -> str:
    """Lines such as `9,812 pass` and `13 known`, sorted by severity."""
    if cell is None:
        return "-"
    return "\n".join(
        f"{cell.verdicts[verdict]:,} {verdict}" for verdict in Verdict if cell.verdicts[verdict]
    )


def left_out(run: Run) -> Counter[str]:
    """How many cases no target takes for want of each capability."""
    counts: Counter[str] = Counter()
    for message, count in run.untaken.items():
        counts.update(dict.fromkeys(reasons_of(message), count))
    return counts


def counted_cases(count: int) -> str:
    return "1 case" if count == 1 else f"{count:,} cases"


def reasons_of(message: str) -> list[str]:
    """A reason for each capability that a skip names."""
    text = general_reason(message)
    words = text.removeprefix(LACKING)
    return [f"{LACKING}{word}" for word in words.split(", ")] if words != text else [text]


def untaken(run: Run) -> Counter[str]:
    counts: Counter[str] = Counter()
    for message, count in run.untaken.items():
        counts[general_reason(message)] += count
    return counts


def general_reason(message: str) -> str:
    """A skip's reason without details from its case."""
    text = re.sub(r"^[PQ]: ", "", message)
    text = re.sub(r"^\d[\d,]* (pairs of vertices), more than \d[\d,]*", r"too many \1", text)
    return re.sub(r"\brings \d+ and \d+ meet", "rings meet", text)


def describe(group: Group) -> list[str]:
    """Lines about a kind of finding, without control characters."""
    finding = group.example
    outcome = finding.outcome
    times = "once" if group.count == 1 else f"{group.count:,} times"
    was = f" (was {outcome.was})" if outcome.was else ""
    kinds = f": {', '.join(str(reason) for reason in outcome.reasons)}" if outcome.reasons else ""
    also = f" (also {'; '.join(group.also)})" if group.also else ""
    lines = [f"{outcome.target} {outcome.verdict}{was}{kinds}{also}, {times}"]
    if outcome.message:
        lines.append(f"  {outcome.message}")
    if outcome.signal and outcome.signal not in outcome.message:
        lines.append(f"  signal {outcome.signal}")
    if outcome.log:
        lines.append(f"  its log ends: {outcome.log.strip()[-LOG_SHOWN:]}")
    if group.unshrunk:
        lines.append(
            f"  left as it is: shrinking it failed, which is a fault of ours: {group.unshrunk}"
        )
    if not group.small:
        lines += [f"  the smallest: case {finding.case.name.text}", *_lines(finding)]
    else:
        found = finding.case
        lines.append(f"  found on {found.name.text}, {_measures(found)}")
    for small in group.small:
        shown_as = "" if small.stable else ", not every time"
        lines.append(
            f"  shrunk to {small.result.size[0]} vertices in {small.calls} calls"
            f"{_brief(small)}{shown_as}:"
        )
        lines += _lines(Finding(small.outcome, small.result))
    return [escaped(line) for line in lines]


def _measures(case: CaseResult) -> str:
    vertices = f"{case.size[0]} vertices"
    if case.offset or case.features:
        return f"{vertices}, {case.Q_name}"
    return vertices if case.path or case.union else f"scale {case.scale}, {vertices}"


def _brief(small: SmallFinding) -> str:
    return "" if small.seconds is None else f" of {small.seconds:g} s at most"


def _lines(finding: Finding) -> list[str]:
    outcome, case = finding.outcome, finding.case
    lines = [f"    {_measures(case)}"]
    if outcome.witness is not None:
        lines.append(f"    {witness_text(outcome.witness, case.scale)}")
    lines.append(f"    {finding.reproduce}")
    return lines


def witness_text(witness: Witness, scale: str) -> str:
    """One sentence, to be checked by hand."""
    if witness.contact is not None:
        return path_witness_text(witness)
    if witness.sets is not None:
        return union_witness_text(witness)
    if witness.feature is not None:
        return feature_witness_text(witness)
    if witness.radius is not None:
        return offset_witness_text(witness)
    point = f"({', '.join(witness.point)})"
    at = witness.scale or scale
    what = "the sum of the boundaries" if witness.boundary else "the sum"
    where = "" if witness.boundary is False else ", p and q on the boundaries"
    around = (
        f" with all points that differ by at most {witness.tolerance} in each coordinate"
        if witness.tolerance != "0"
        else ""
    )
    if witness.in_truth and witness.p and witness.q:
        return (
            f"witness {point} is in {what}{around}: {at} * ({', '.join(witness.p)}) "
            f"+ ({', '.join(witness.q)}){where}"
        )
    return (
        f"witness {point} is outside {what} at {at}{around}: the scaled P does not meet the "
        "point less Q"
    )


def conclusion(run: Run) -> str:
    """One sentence with the numbers of cases and targets, and the verdicts."""
    verdicts: dict[str, int] = {}
    for cell in run.matrix.values():
        for verdict, count in cell.verdicts.items():
            verdicts[verdict] = verdicts.get(verdict, 0) + count
    counts = ", ".join(f"{verdicts[v]:,} {v}" for v in Verdict if verdicts.get(v))
    return (
        f"{counted_cases(sum(run.cases.values()))}, {counted(len(run.targets), 'target')}: "
        f"{counts or 'nothing run'}"
    )
