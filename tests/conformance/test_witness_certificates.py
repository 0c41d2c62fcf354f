"""Certificates of witnesses: each shown witness has one or a reason; checkers verify them; the
document and the pages name them; an untrue witness gets none."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run as command
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.witness_certificate import certificate_of
from minkref.fuzz.run import naming
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness
from minkref.reports.conformance.page import write_report

SQUARE = '{"polygons":[{"outer":[[0,0],[1,0],[1,1],[0,1]]}]}'
FAR = '{"polygons":[{"outer":[[4,0],[5,0],[5,1],[4,1]]}]}'
UNION = f'{{"sets":[{SQUARE},{FAR}]}}'
PATH = (
    f'{{"part":{SQUARE},"obstacles":{FAR},"path":[["0","0"],["1","0"]],"contact":"allowed",'
    '"scales":["1"]}'
)


def shown(literal: str, witness: Witness, reason: Reason = Reason.MISSING) -> Finding:
    case: Any = naming.load(CaseName(literal, "named"))
    result = CaseResult(0, case.name, case.scale, [], "P", "Q", case.size, literal=literal)
    pair = case.pair if hasattr(case, "pair") else None
    result.P = pair.P.to_json() if pair else case.P_json
    result.Q = pair.Q.to_json() if pair else case.Q_json
    result.dimension = 3 if pair else 2
    return Finding(Outcome("target", Verdict.WRONG, (reason,), witness=witness), result)


def summed(scale: str) -> str:
    return f'{{"P":{SQUARE},"Q":{FAR},"scale":"{scale}"}}'


def grown(radius: str) -> str:
    return f'{{"offset":{SQUARE},"radius":"{radius}"}}'


BOX = (
    '{"vertices":[[0,0,0],[0,0,1],[0,1,0],[0,1,1],[1,0,0],[1,0,1],[1,1,0],[1,1,1]],"faces":'
    "[[0,1,3,2],[0,2,6,4],[0,4,5,1],[1,5,7,3],[2,3,7,6],[4,6,7,5]]}"
)
SOLIDS = f'{{"P":{BOX},"Q":{BOX},"scale":"1,2,1"}}'
POINT = '{"vertices":[["1","1","1"]],"faces":[]}'
WITH_POINT = f'{{"P":{{"polygons":[{{"outer":[[1,1]]}}]}},"Q":{FAR},"scale":"1"}}'
WITH_SEGMENT = f'{{"P":{{"polygons":[{{"outer":[[0,0],[1,2]]}}]}},"Q":{FAR},"scale":"1"}}'
TRUE = {
    "sum, inside": (summed("1"), Witness(("5", "1"), True)),
    "sum, outside": (summed("1/2"), Witness(("7/2", "1"), False)),
    "sum at another scale": (summed("1"), Witness(("7", "1"), True, scale="2")),
    "a factor for each axis": (summed("1,2"), Witness(("5", "3"), True)),
    "sum with a point": (WITH_POINT, Witness(("5", "3/2"), True)),
    "sum with a segment": (WITH_SEGMENT, Witness(("9/2", "3/2"), True)),
    "sum in space, inside": (SOLIDS, Witness(("2", "5/2", "1"), True)),
    "sum in space, outside": (SOLIDS, Witness(("3/2", "7/2", "1"), False)),
    "union, in a set": (UNION, Witness(("9/2", "1/2"), True, sets=2, of_set=2)),
    "union, in no set": (UNION, Witness(("3", "1/2"), False, sets=2)),
    "grown, in": (grown("2"), Witness(("3", "0"), True, radius="2")),
    "grown, out": (grown("2"), Witness(("5/2", "5/2"), False, radius="2")),
    "path, hits": (PATH, Witness(("7/2", "0"), True, scale="4", contact="allowed")),
    "path, passes": (PATH, Witness(("0", "0"), False, scale="3", contact="allowed")),
}
NONE = {
    "sum of boundaries": (summed("1"), Witness(("5", "1"), True, boundary=True), "boundaries"),
    "erosion": (grown("-1/4"), Witness(("1/2", "1/2"), True, radius="-1/4"), "erosions"),
    "joins": (grown("2"), Witness(("3", "0"), True, radius="2", manner="mitred"), "round"),
    "a point in space": (
        f'{{"P":{BOX},"Q":{POINT},"scale":"1"}}',
        Witness(("9", "9", "9"), False),
        "no volume",
    ),
}


@pytest.mark.parametrize("literal, witness", TRUE.values(), ids=TRUE)
def test_a_true_witness_is_certified_and_its_negation_is_not(
    literal: str, witness: Witness
) -> None:
    made = certificate_of(shown(literal, witness), "it")
    assert made is not None and made.file == "it.cert.json", made
    assert json.loads(made.text)["case"]["path"] == "it.case.json" in made.files
    untrue = replace(witness, in_truth=not witness.in_truth)
    refused = certificate_of(shown(literal, untrue), "it")
    assert refused is not None and refused.why_none and not refused.files


@pytest.mark.parametrize("literal, witness, why", NONE.values(), ids=NONE)
def test_a_witness_of_no_form_says_so(literal: str, witness: Witness, why: str) -> None:
    made = certificate_of(shown(literal, witness), "it")
    assert made is not None and not made.files
    assert "no form of certificate for this" in made.why_none and why in made.why_none


def test_invalid_operands_have_no_certificate() -> None:
    finding = shown(summed("1"), Witness(("0", "0"), False), Reason.ACCEPTED_INVALID)
    made = certificate_of(finding, "it")
    assert made is not None and "invalid" in made.why_none


def test_a_hostile_name_of_a_target_stays_in_the_title() -> None:
    finding = shown(summed("1"), Witness(("5", "1"), True))
    named = Finding(replace(finding.outcome, target='x\x00\udcff"<b>\x1b[31m'), finding.case)
    made = certificate_of(named, "it")
    assert made is not None and made.file and "\x1b" not in json.loads(made.text)["title"]


def test_a_crash_has_no_witness_and_no_certificate(finding: Callable[..., Finding]) -> None:
    crashed = finding(summed("1"), "target", verdict=Verdict.CRASHED)
    assert certificate_of(crashed, "it") is None


def test_the_report_has_them_beside_the_pages_and_check_verifies_the_folder(
    made: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_report(tmp_path, made.run, made.groups, made.value)
    (shrunk,) = made.value["shrunk"]
    name = shrunk["certificate"]["file"]
    assert name == "pysfcgal-hole-lost.cert.json" and (tmp_path / name).exists()
    assert shrunk["certificate"]["claim"] == "(11/5, 5/2) is outside the sum at 1"
    known = next(row for row in made.value["findings"] if row["target"] == "cgal-reduced")
    assert (tmp_path / known["certificate"]["file"]).exists()
    page = (tmp_path / "finding-pysfcgal-hole-lost.html").read_text(encoding="utf-8")
    assert f'href="{name}"' in page and f"minkref check {name}" in page
    boundary = next(row for row in made.value["findings"] if row["target"] == "clipper2")
    assert "boundaries" in boundary["certificate"]["why_none"]
    assert "No certificate: no form of certificate for this" in "".join(
        path.read_text(encoding="utf-8") for path in tmp_path.glob("finding-clipper2*.html")
    )
    capsys.readouterr()
    assert command(["check", str(tmp_path)]) == 0
    assert capsys.readouterr().out.count(": verified") == len(list(tmp_path.glob("*.cert.json")))
