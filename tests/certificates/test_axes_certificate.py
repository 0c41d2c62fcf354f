"""Certificates of sums in the plane with a factor for each axis: every checker verifies the true
ones and refuses the forged ones."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.certified_cases import written
from minkref.reports.evidence.certificates.checkers import in_cpp, in_proved, in_python, verdicts
from minkref.reports.evidence.plane_scaling.proofs import FORGERIES, certified
from minkref.reports.evidence.plane_scaling.scaled_pairs import scaled_pairs

FRAME = "POLYGON ((0 0, 5 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
TRIANGLE = "POLYGON ((0 0, 2 0, 0 1, 0 0))"


def checkers() -> list[list[str]]:
    """Those that are built: the proved one takes `make proofs`."""
    found = [in_python(), in_cpp()]
    try:
        found.append(in_proved())
    except FileNotFoundError:
        pass
    return found


def certificate() -> Certificate:
    made = Certificate(_core.PolygonSet(FRAME), _core.PolygonSet(TRIANGLE), ("2", "1/3"))
    made.sum(1, passages=True)
    return made


def test_every_checker_verifies_sums_of_all_kinds_of_pairs(tmp_path: Path) -> None:
    cases = [case for case in scaled_pairs(24) if case.vertex_pairs < 150][:8]
    files = [written(certified(case), tmp_path, f"c{k}") for k, case in enumerate(cases)]
    for command in checkers():
        assert [verdict.code for verdict in verdicts(command, files)] == [0] * len(files)


@pytest.mark.parametrize("forgery", FORGERIES)
def test_every_checker_refuses_a_forgery(forgery: str, tmp_path: Path) -> None:
    path = written(certificate(), tmp_path, "it")
    value: dict[str, Any] = FORGERIES[forgery](json.loads(path.read_text(encoding="utf-8")))
    path.write_text(json.dumps(value), encoding="utf-8")
    for command in checkers():
        (verdict,) = verdicts(command, [path])
        assert verdict.code in (1, 2), command


def test_the_case_has_p_as_given() -> None:
    made = certificate()
    value = json.loads(made.case())
    assert value["P"]["polygons"][0]["outer"][1] == ["5", "0"]
    head = json.loads(made.text("case.json"))
    assert (head["certificate"], head["axes"]) == ("axes-certificate-v1", ["2", "1/3"])


def test_without_axes_the_form_is_the_old_one() -> None:
    made = Certificate(_core.PolygonSet(FRAME), _core.PolygonSet(TRIANGLE))
    made.sum(1)
    head = json.loads(made.text("case.json"))
    assert head["certificate"] == "certificate-v1"
    assert "axes" not in head
