"""Seeded faults that each degenerate family shows."""

from __future__ import annotations

import csv
import json
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.plane.case_document import Degenerate
from minkref.fuzz.geometry.region import region_of_rings
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.of_tests import SEEDED, module, seeded_faults
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER, ROOT

MINUTES = Minutes(None, 1, 5)

SEED = 11
MATRIX = FOLDER / "faults_by_family.csv"
MEMBERS = Counts(0, 3, 10)
SCALES = 3  # per member: the critical scale, and one on each side
SECONDS = 1.0  # per call; a slower fault shows
# Families that may show none, and why.
BLAND: dict[str, str] = {}


def run(findings: Findings, size: Size) -> None:
    names = sorted(seeded_faults())
    shown: dict[str, set[str]] = {}
    for family, found, alarms in in_processes(
        _of_family, [(family, size.of(MEMBERS)) for family in FAMILIES]
    ):
        shown[family] = set(found)
        findings.none(f"{family}: answers of the sound implementation that are wrong", alarms)
        print(f"{family}: {len(found)} of {len(names)}", flush=True)
    for family in FAMILIES:
        findings.figures[family] = f"{len(shown[family])} of {len(names)}"
    bland = [family for family in FAMILIES if not shown[family] and family not in BLAND]
    findings.target("families that show no fault, without a reason", not bland, 0,
                    ", ".join(bland) or 0)  # fmt: skip
    _write_matrix(names, shown)
    findings.note(f"Which family shows which fault: {MATRIX.relative_to(ROOT)}.")
    together = set().union(*shown.values())
    findings.figures["all families together"] = f"{len(together)} of {len(names)}"
    findings.figures["faults that none shows"] = sorted(set(names) - together)
    only = {
        family: sorted(shown[family] - set().union(*(shown[o] for o in shown if o != family)))
        for family in FAMILIES
    }
    findings.figures["faults that one family alone shows"] = {k: v for k, v in only.items() if v}


def _write_matrix(names: list[str], shown: dict[str, set[str]]) -> None:
    """A row for each fault, a column for each family: 1 where it shows the fault."""
    MATRIX.parent.mkdir(parents=True, exist_ok=True)
    with MATRIX.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["fault", *FAMILIES])
        for name in names:
            table.writerow([name, *(int(name in shown[family]) for family in FAMILIES)])


def _of_family(task: tuple[str, int]) -> tuple[str, list[str], list[str]]:
    """The family's name, the faults that it shows, and the sound sum's errors."""
    family, members = task
    made = module("seeded_adapter", SEEDED).made
    cases = [_questions(family, index) for index in range(members)]
    found = [
        name for name in sorted(seeded_faults()) if _differences(made(name), cases, first=True)
    ]
    return family, found, _differences(made("sound"), cases, first=False)


Question = tuple[Any, Any, list[tuple[str, Any, str]]]  # P, Q; scale, sP, the canonical sum


def _questions(family: str, index: int) -> Question:
    member = Degenerate.of(FAMILIES[family], SEED, index)
    facts = member.facts
    asked = []
    for scale in (member.scales[0], member.scales[1], member.scales[-1])[:SCALES]:
        sP = json.loads(facts.P.scaled(str(scale)).to_json())
        truth = _core.minkowski_sum(facts.P, facts.Q, str(scale)).region.canonical_json()
        asked.append((str(scale), sP, truth))
    return json.loads(facts.P.to_json()), json.loads(facts.Q.to_json()), asked


def _differences(target: Any, cases: list[Question], first: bool) -> list[str]:
    """Cases where an implementation, which keeps state between cases, answers differently."""
    found = []
    for P, Q, asked in cases:
        target.load(P, Q)
        for scale, sP, truth in asked:
            if _answer(target, scale, sP) not in (truth, "no region"):
                found.append(f"at {Fraction(scale)} of {json.dumps([P, Q])[:300]}")
                if first:
                    return found
    return found


def _answer(target: Any, scale: str, sP: Any) -> str:
    try:
        with module("time_limit", SEEDED).limited(SECONDS):
            result = target.at(scale, sP)
    except Exception as error:  # noqa: BLE001 a fault may raise anything
        return type(error).__name__
    if result is None:
        return "no region"
    region = region_of_rings(result, turned=True)
    return region.json if region.overlap is None and region.degenerate is None else "no set"
