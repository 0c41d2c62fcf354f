"""What a run says: findings first and once each, what no target takes, as many cases as asked."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parent
CONVEX = """
from minkref import _core
import json


def convex(P, Q):
    a, b = (_core.PolygonSet.from_json(json.dumps(operand)) for operand in (P, Q))
    return json.loads(_core.minkowski_sum(a, b, "1").region.canonical_json())


convex.minkref = {"capabilities": ["plane"]}
"""


def verify(folder: Path, *words: str, code: int) -> str:
    path = f"{FOLDER}{os.pathsep}{os.environ.get('PYTHONPATH', '')}"
    ran = subprocess.run(
        [sys.executable, "-m", "minkref", "verify", "--no-models", "--jobs", "2", *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        timeout=200,
    )
    assert ran.returncode == code, ran.stdout + ran.stderr
    return ran.stdout


def cases(value: Any) -> int:
    return sum(group["cases"] for group in value["groups"])


@pytest.mark.parametrize("jobs", ["1", "2"])
@pytest.mark.parametrize("pairs", [1, 37])
def test_as_many_cases_are_judged_as_asked(tmp_path: Path, pairs: int, jobs: str) -> None:
    """Those that do not exist, or that no target takes, do not count."""
    (tmp_path / "sums.py").write_text(CONVEX)
    words = ("py:sums:convex", "--pairs", str(pairs), "--jobs", jobs, "--json")
    value = json.loads(verify(tmp_path, *words, code=0))
    assert cases(value) == pairs
    assert [cell["verdicts"] for cell in value["matrix"] if "skipped" in cell["verdicts"]] == []
    assert value["left_out"] or pairs == 1


def test_the_cases_of_a_number_depend_on_no_order(tmp_path: Path) -> None:
    (tmp_path / "sums.py").write_text(CONVEX)
    values = [
        json.loads(verify(tmp_path, "py:sums:convex", "--pairs", "60", *more, "--json", code=0))
        for more in (("--jobs", "1"), ("--jobs", "2"))
    ]
    assert values[0]["groups"] == values[1]["groups"]
    assert values[0]["left_out"] == values[1]["left_out"]


def test_a_family_that_no_target_takes_ends(tmp_path: Path) -> None:
    (tmp_path / "sums.py").write_text(CONVEX)
    words = ("py:sums:convex", "--family", "holes", "--pairs", "3", "--no-derived", "--json")
    value = json.loads(verify(tmp_path, *words, code=2))
    assert cases(value) == 0 and any("the targets take 0" in note for note in value["notes"])


def test_what_is_missing_is_a_line_for_each_capability(tmp_path: Path) -> None:
    (tmp_path / "sums.py").write_text(CONVEX)
    text = verify(tmp_path, "py:sums:convex", "--pairs", "60", code=0)
    lines = [line for line in text.splitlines() if line.startswith("left out")]
    assert len(lines) == len({line.partition(": ")[2] for line in lines})
    assert any("cases: does not declare holes (no target takes them)" in line for line in lines)
    assert not any("holes," in line for line in lines)


def test_findings_come_first_and_each_once(tmp_path: Path) -> None:
    files = ("--junit", "junit.xml", "--sarif", "verify.sarif")
    words = ("py:faulty_sums:loses_holes", "--pairs", "200", "--shrink-calls", "20", *files)
    text = verify(tmp_path, *words, code=1)
    assert text.startswith("py:faulty_sums:loses_holes wrong")
    assert text.index(" wrong") < text.index("Verdicts on 200 cases")
    assert "  found on " in text.split("shrunk to")[0]
    root = ElementTree.parse(tmp_path / "junit.xml").getroot()
    failures = [failure.text or "" for failure in root.iter("failure")]
    assert len(failures) > 1
    lines = [line for text in failures for line in text.splitlines()]
    heads = [line for line in lines if line.startswith("py:faulty_sums:loses_holes wrong")]
    assert heads and len(heads) == len(set(heads))
    assert any("told under" in line for line in lines)


def test_places_of_code_scanning(tmp_path: Path) -> None:
    """A file of the current folder where there is one; else the name of the target."""
    (tmp_path / "my_sums.py").write_text("from faulty_sums import loses_holes\n")
    for target, place in (
        ("py:my_sums:loses_holes", "my_sums.py"),
        ("py:faulty_sums:loses_holes", "py%3Afaulty_sums%3Aloses_holes"),
    ):
        words = (target, "--family", "holes", "--pairs", "30", "--shrink-calls", "0")
        verify(tmp_path, *words, "--sarif", "verify.sarif", code=1)
        results = json.loads((tmp_path / "verify.sarif").read_text())["runs"][0]["results"]
        for result in results:
            where = result["locations"][0]["physicalLocation"]
            assert where["artifactLocation"]["uri"] == place
            assert where["region"]["startLine"] == 1
