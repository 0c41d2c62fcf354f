"""Damaged sets in the plane, each kind in turn."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

from minkref import PolygonSet
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.refusals.damage import KINDS, Damaged, damaged
from minkref.reports.evidence.refusals.judge import difference, untold, welded
from minkref.reports.evidence.refusals.repairing import Repair, repair

MINUTES = Minutes(0.05, 0.5, 4)
FILES = Counts(32, 208, 2000)
LEADS_TO = {
    "spike": {"repeated-point"},
    "no-area": {"spike", "repeated-point"},
    "self-crossing": {"turned"},
    "welded": {"repeated-point"},
}


def run(findings: Findings, size: Size) -> None:
    wrong, again, unsaid, silent, invalid, made_up = [], [], [], [], [], []
    kinds: Counter[str] = Counter()
    count = size.of(FILES)
    with TemporaryDirectory() as folder:
        for index in range(count):
            case = damaged(index)
            found = repaired_case(case, index, Path(folder))
            kinds.update({change["kind"] for change in found.changes})
            wrong += [case.name] * bool(other_set(case, found))
            again += [case.name] * bool(found.again)
            unsaid += [case.name] * bool(unlisted(case, found))
            silent += [case.name] * bool(missing(case, found))
            made_up += [case.name] * bool(invented(case, found))
            invalid += [case.name] * (not is_operand(found))
    findings.none("sets other than the rings describe", wrong)
    findings.none("repaired files that need repair", again)
    findings.none("files with rings that changed unlisted", unsaid)
    findings.none("files with damage that no change names", silent)
    findings.none("files with a change of a kind that the damage does not lead to", made_up)
    findings.none("repaired files that are no operands", invalid)
    findings.figures |= {"files": count, "kinds of damage": len(KINDS)}
    findings.figures["files with a change, by kind"] = dict(sorted(kinds.items()))


def repaired_case(case: Damaged, index: int, folder: Path) -> Repair:
    form = "wkt" if case.is_open or index % 2 == 0 else "json"
    file = folder / f"damaged.{form}"
    file.write_text(case.text(form), encoding="utf-8")
    return repair(file, folder / "repaired.json", case.rule, case.weld)


def other_set(case: Damaged, found: Repair) -> str:
    written = case.polygons if case.weld is None else welded(case.polygons, case.weld)
    return difference(written, rings_of(found), case.rule)


def rings_of(found: Repair) -> list[list[list[tuple[Fraction, Fraction]]]]:
    return PolygonSet.from_json(found.output).rings()


def unlisted(case: Damaged, found: Repair) -> list[int]:
    named = {
        change[name]
        for change in found.changes
        for name in ("ring", "other_ring")
        if name in change
    }
    for holes in _with_outer(case):  # a change of a hole or an outer ring remakes their polygon
        if named & holes:
            named |= holes
    return untold(case.polygons, rings_of(found), named)


def _with_outer(case: Damaged) -> list[set[int]]:
    groups, first = [], 0
    for rings in case.polygons:
        groups.append(set(range(first, first + len(rings))))
        first += len(rings)
    return groups


def missing(case: Damaged, found: Repair) -> set[str]:
    return case.expected - {change["kind"] for change in found.changes}


def invented(case: Damaged, found: Repair) -> set[str]:
    """Return kinds of changes that neither the damage nor its repair leads to."""
    led_to = {kind for cause in case.expected for kind in LEADS_TO.get(cause, ())}
    return {change["kind"] for change in found.changes} - case.expected - led_to


def is_operand(found: Repair) -> bool:
    try:
        PolygonSet(json.loads(found.output))
    except ValueError:
        return False
    return True
