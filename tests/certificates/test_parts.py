"""The parts make up check.py, one after another; each claim needs a few parts only."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import bridges
import cubes
import grown
import pytest
import solid_pairs
import squares
import touching
import walls
from file_alone import laid
from minkref.certify.space.solid_point_certificate import SolidPointCertificate
from minkref.reports.evidence.certificates.checkers import CHECKER

PARTS = sorted((CHECKER.parent / "parts").glob("*.py"))
ROW = re.compile(r"^\|[^|]*\| ([\dbc, ]+) \| (\d+) \|$", re.MULTILINE)


def text_of(*numbers: str) -> str:
    return "".join(
        part.read_text(encoding="utf-8") for part in PARTS if part.name.split("_")[0] in numbers
    )


def test_the_file_is_its_parts() -> None:
    parts = "".join(part.read_text(encoding="utf-8") for part in PARTS)
    assert CHECKER.read_text(encoding="utf-8") == parts, "make checker"


def test_parts_are_short() -> None:
    assert max(len(part.read_text(encoding="utf-8").splitlines()) for part in PARTS) <= 600
    assert len(text_of("01", "02", "09").splitlines()) <= 700


def test_the_page_says_how_many_lines_a_claim_needs() -> None:
    rows = ROW.findall((CHECKER.parent / "README.md").read_text(encoding="utf-8"))
    assert len(rows) == 11
    for numbers, lines in rows:
        assert len(text_of(*numbers.split(", ")).splitlines()) == int(lines), numbers


def followed(numbers: str, folder: Path, case: Any, certificate: Any) -> tuple[int, str]:
    """Runs a checker made from these parts; returns its words."""
    laid(folder, case, certificate)
    (folder / "some.py").write_text(text_of(*numbers.split()), encoding="utf-8")
    command = [sys.executable, "-I", "-S", "some.py", "it.cert.json"]
    ran = subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout


@pytest.mark.parametrize(
    ("given", "numbers"),
    [
        (squares, "01 02 09"),
        (cubes, "01 04 09"),
        (walls, "01 02 06 09"),
        (bridges, "01 02 07 09"),
        (touching, "01 02 08 09"),
        (grown, "01 02 07 08b 09"),
    ],
    ids=["plane", "convex", "paths", "bridges", "unions", "sums with a disc"],
)
def test_the_parts_that_a_claim_needs_run_alone(tmp_path: Path, given: Any, numbers: str) -> None:
    code, said = followed(numbers, tmp_path, given.CASE, given.certificate())
    assert code == 0 and "verified" in said, said


def test_those_of_solids_too(tmp_path: Path) -> None:
    certificate, case = solid_pairs.values(*solid_pairs.PAIRS["cup and less"])
    code, said = followed("01 02 04 05 05c 09", tmp_path, case, certificate)
    assert code == 0 and "1 components, 0 cavities, 0 tunnels" in said, said
    assert followed("01 02 04 05 09", tmp_path, case, certificate)[0] == 2
    for claim in certificate["claims"]:
        for name in ("components", "cavities", "tunnels"):
            del claim[name]
    code, said = followed("01 02 04 05 09", tmp_path, case, certificate)
    assert code == 0 and "components" not in said, said
    of_point = SolidPointCertificate(*map(solid_pairs.given, solid_pairs.PAIRS["convex"][:2]))
    of_point.outside(solid_pairs.ONE, ("9", "9", "9"))
    values = json.loads(of_point.case()), json.loads(of_point.text("case.json"))
    assert followed("01 02 04 05 05b 09", tmp_path, *values)[0] == 0
    assert followed("01 02 04 05 09", tmp_path, *values)[0] == 2


def test_a_claim_of_a_part_that_is_missing_is_malformed(tmp_path: Path) -> None:
    value = squares.certificate()
    value["claims"].append({"claim": "sign"})
    code, said = followed("01 02 09", tmp_path, squares.CASE, value)
    assert code == 2 and "there is no claim 'sign'" in said
