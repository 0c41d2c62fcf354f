"""Output of a run: findings first and once each, cases no target takes, as many cases as asked."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.fuzz.run import case_list
from thoroughness import draws

Verify = Callable[..., str]
PAIRS = draws(24, 60)
PAIRS_WITH_HOLES = str(draws(16, 200))
CONVEX = """
from minkref import _core
import json


def convex(P, Q):
    a, b = (_core.PolygonSet.from_json(json.dumps(operand)) for operand in (P, Q))
    return json.loads(_core.minkowski_sum(a, b, "1").region.canonical_json())


convex.minkref = {"capabilities": ["plane"]}
"""


@pytest.fixture
def verify(
    faulty_sums: None,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> Callable[..., str]:
    """Gives the output of a run in a folder with a function for convex sets."""
    (tmp_path / "sums.py").write_text(CONVEX)
    monkeypatch.chdir(tmp_path)

    def call(*words: str, code: int) -> str:
        found = run(["verify", "--no-models", *words])
        said = capsys.readouterr()
        assert found == code, said.out + said.err
        return said.out

    return call


def cases(value: Any) -> int:
    return sum(group["cases"] for group in value["groups"])


def test_as_many_cases_are_judged_as_asked_in_no_order(verify: Verify) -> None:
    """Cases that do not exist, or that no target takes, do not count."""
    values = []
    for pairs, jobs in ((1, 1), (PAIRS, 1), (PAIRS, 2)):
        words = ("py:sums:convex", "--pairs", str(pairs), "--jobs", str(jobs), "--json")
        value = json.loads(verify(*words, code=0))
        assert cases(value) == pairs
        assert [cell["verdicts"] for cell in value["matrix"] if "skipped" in cell["verdicts"]] == []
        assert value["left_out"] or pairs == 1
        values.append((value["groups"], value["left_out"]))
    assert values[1] == values[2]


def test_a_family_that_no_target_takes_ends(
    verify: Verify, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(case_list, "FEWEST_TRIES", draws(20, case_list.FEWEST_TRIES))
    words = ("py:sums:convex", "--family", "holes", "--pairs", "3", "--no-derived", "--json")
    value = json.loads(verify(*words, "--jobs", "1", code=2))
    assert cases(value) == 0 and any("the targets take 0" in note for note in value["notes"])


def test_what_is_missing_is_a_line_for_each_capability(verify: Verify) -> None:
    text = verify("py:sums:convex", "--pairs", str(PAIRS), "--jobs", "1", code=0)
    lines = [line for line in text.splitlines() if line.startswith("left out")]
    assert len(lines) == len({line.partition(": ")[2] for line in lines})
    assert any("cases: does not declare holes (no target takes them)" in line for line in lines)
    assert not any("holes," in line for line in lines)


def test_findings_come_first_and_each_once(verify: Verify, tmp_path: Path) -> None:
    files = ("--junit", "junit.xml", "--sarif", "verify.sarif")
    words = ("py:faulty_sums:loses_holes", "--family", "holes", "--jobs", "1", *files)
    text = verify(*words, "--pairs", PAIRS_WITH_HOLES, "--shrink-calls", "8", code=1)
    assert text.startswith("py:faulty_sums:loses_holes wrong")
    assert text.index(" wrong") < text.index(f"Verdicts on {PAIRS_WITH_HOLES} cases")
    assert "  found on " in text.split("shrunk to")[0]
    root = ElementTree.parse(tmp_path / "junit.xml").getroot()
    failures = [failure.text or "" for failure in root.iter("failure")]
    assert len(failures) > 1
    lines = [line for text in failures for line in text.splitlines()]
    heads = [line for line in lines if line.startswith("py:faulty_sums:loses_holes wrong")]
    assert heads and len(heads) == len(set(heads))
    assert any("told under" in line for line in lines)


def test_places_of_code_scanning(verify: Verify, tmp_path: Path) -> None:
    """Names a file of the current folder if possible, otherwise the target."""
    (tmp_path / "my_sums.py").write_text("from faulty_sums import loses_holes\n")
    for target, place in (
        ("py:my_sums:loses_holes", "my_sums.py"),
        ("py:faulty_sums:loses_holes", "py%3Afaulty_sums%3Aloses_holes"),
    ):
        words = (target, "--family", "holes", "--pairs", "8", "--shrink-calls", "0", "--jobs", "1")
        verify(*words, "--sarif", "verify.sarif", code=1)
        results = json.loads((tmp_path / "verify.sarif").read_text())["runs"][0]["results"]
        for result in results:
            where = result["locations"][0]["physicalLocation"]
            assert where["artifactLocation"]["uri"] == place
            assert where["region"]["startLine"] == 1
