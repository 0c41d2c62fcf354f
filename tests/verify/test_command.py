"""`minkref verify` as a command: document, report, JUnit, exit codes."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from thoroughness import draws

WRONG = "py:faulty_sums:loses_holes"
ALWAYS = ("--no-derived", "--no-models", "--jobs", "1")
UNSHRUNK = ("--shrink-calls", "0")
PLAIN = ("--family", "random", *ALWAYS, *UNSHRUNK)
COUNT = str(draws(12, 500))
HOLES = ("--pairs", COUNT, "--family", "holes", *ALWAYS)
FEW = (*HOLES, "--shrink-calls", "8")


@pytest.fixture
def minkref(faulty_sums: None, capsys: pytest.CaptureFixture[str]) -> Any:
    def call(*arguments: str | Path) -> tuple[int, str, str]:
        code = run(["verify", *(str(argument) for argument in arguments)])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return call


def test_document_follows_its_schema_and_findings_carry_their_case(
    minkref: Any, follows_schema: Callable[[Any, str], None]
) -> None:
    code, out, err = minkref("minkref:paper", WRONG, *HOLES, "--json", *UNSHRUNK)
    assert (code, err) == (1, "")
    value = json.loads(out)
    follows_schema(value, "verify")
    assert value["exit_code"] == 1
    finding = value["findings"][0]
    assert finding["target"] == WRONG
    assert finding["reasons"] == ["hole-lost"]
    assert finding["witness"]["in_truth"] is False
    assert finding["P"]["set"]["polygons"]
    code, out, _ = minkref(*finding["reproduce"].split()[2:], "--json", *UNSHRUNK)
    assert code == 1
    assert json.loads(out)["findings"][0]["witness"] == finding["witness"]


def test_table_shows_verdicts_witness_and_the_line_that_reproduces(minkref: Any) -> None:
    code, out, err = minkref("minkref:paper", WRONG, *FEW)
    assert (code, err) == (1, "")
    for text in (
        COUNT,
        "shrunk to",
        "wrong: hole-lost",
        "witness (",
        "is outside the sum",
        "--case '{",
    ):
        assert text in out
    assert re.search(rf"minkref:paper[^\n]* {COUNT} ", out)


def test_all_well_exits_0(minkref: Any) -> None:
    code, out, _ = minkref("minkref:paper", "minkref:winding", "--pairs", "20", *PLAIN)
    assert code == 0
    assert "40 pass" in out


def test_crash_exits_3_and_with_a_wrong_1(minkref: Any) -> None:
    dies = "py:faulty_sums:dies"
    few = ("--pairs", "2", *PLAIN)
    assert minkref("minkref:paper", dies, *few)[0] == 3
    assert minkref("py:faulty_sums:nothing", dies, *few)[0] == 1


def test_baseline_file_makes_a_fault_known(minkref: Any, tmp_path: Path) -> None:
    path = tmp_path / "baseline.json"
    entry = {"target": WRONG, "version": "*", "kind": "hole-lost", "reason": "a fault that we made"}
    path.write_text(json.dumps({"baseline": "baseline-v1", "entries": [entry]}), encoding="utf-8")
    code, out, _ = minkref("minkref:paper", WRONG, *HOLES, "--baseline", path, *UNSHRUNK)
    assert code == 0
    assert "known (was wrong): hole-lost" in out
    assert "a fault that we made" in out
    assert "witness (" in out


def test_report_is_one_self_contained_page(minkref: Any, tmp_path: Path) -> None:
    code, out, _ = minkref("minkref:paper", WRONG, *FEW, "--report", tmp_path / "report", "--json")
    assert code == 1
    page = Path(json.loads(out)["report"])
    html = page.read_text(encoding="utf-8")
    assert not re.search(r'(src|href)="(https?:)?//', html)
    assert re.findall(r"<script[^>]*>", html) == ["<script>"]  # that of the copy buttons
    assert html.count("<svg") >= 5
    finding = json.loads(out)["findings"][0]
    for text in (WRONG, "hole-lost", finding["reproduce"].split("--case")[0], 'class="extra"'):
        assert text in html
    assert "glyph1204 + glyph275" in html or "monkey + bird" in html


def test_junit_counts_failures_errors_and_skips(minkref: Any, tmp_path: Path) -> None:
    path = tmp_path / "junit.xml"
    minkref(
        "minkref:paper",
        "py:faulty_sums:nothing",
        "py:faulty_sums:raises",
        "py:faulty_sums:declines",
        "--pairs",
        "3",
        *PLAIN,
        "--junit",
        path,
    )
    suites = {suite.get("name"): suite for suite in ElementTree.parse(path).getroot()}
    found = {
        name: tuple(suite.get(key) for key in ("tests", "failures", "errors", "skipped"))
        for name, suite in suites.items()
    }
    assert found == {
        "minkref:paper": ("1", "0", "0", "0"),
        "py:faulty_sums:nothing": ("1", "1", "0", "0"),
        "py:faulty_sums:raises": ("1", "0", "1", "0"),
        "py:faulty_sums:declines": ("1", "0", "0", "1"),
    }


def test_nothing_run_is_one_document(minkref: Any) -> None:
    code, out, err = minkref("py:faulty_sums:declines", "--case", "random:1:0", *ALWAYS, "--json")
    assert (code, json.loads(out)["exit_code"]) == (2, 2)
    assert "nothing was run" in err


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("py:exits_on_import:f", "SystemExit"),
        ("py:faulty_sums:not_callable", "is not a function"),
        ("py:faulty_sums:absent", "AttributeError"),
    ],
)
def test_function_that_cannot_be_loaded_is_refused(minkref: Any, target: str, message: str) -> None:
    code, _, err = minkref(target, "--pairs", "1", "--no-models")
    assert code == 2
    assert message in err


def test_what_a_target_prints_is_not_in_the_document(
    faulty_sums: None, capfd: pytest.CaptureFixture[str]
) -> None:
    code = run(["verify", "py:faulty_sums:prints", "--pairs", "2", *PLAIN, "--json"])
    captured = capfd.readouterr()
    assert (code, json.loads(captured.out)["exit_code"]) == (0, 0)
    assert captured.err == ""


def test_messages_are_cut_and_legal_in_xml(minkref: Any, tmp_path: Path) -> None:
    target, path = "py:faulty_sums:raises_control_characters", tmp_path / "junit.xml"
    code, out, _ = minkref(target, "--pairs", "1", *PLAIN, "--json", "--junit", path)
    assert code == 3
    assert len(json.loads(out)["findings"][0]["message"]) <= 2000
    ElementTree.parse(path)
    assert path.stat().st_size < 5000


def test_run_ends_in_its_time(minkref: Any) -> None:
    import time

    start = time.monotonic()
    code, out, _ = minkref(
        "minkref:paper", "--seconds", "3", "--no-models", "--jobs", "1", "--json"
    )
    assert code == 0
    assert 3 <= time.monotonic() - start < 20
    assert sum(group["cases"] for group in json.loads(out)["groups"]) > 10


def test_slow_target_skips_large_cases_and_says_so(minkref: Any) -> None:
    code, out, _ = minkref(
        "minkref:definition", "--case", "g1+g2@1", "--size-limit", "100", *ALWAYS
    )
    assert code == 2
    code, out, _ = minkref(
        "minkref:definition",
        "minkref:paper",
        "--case",
        "g1+g2@1",
        "--size-limit",
        "100",
        "--json",
        *ALWAYS,
    )
    assert code == 0
    (row,) = (row for row in json.loads(out)["matrix"] if row["target"] == "minkref:definition")
    assert row["verdicts"] == {"skipped": 1}
    assert "--size-limit" in next(iter(row["skips"]))


def test_real_pairs_run_at_five_scales_or_name_the_look_alike(
    minkref: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from minkref.fuzz.run.case_list import CaseList

    monkeypatch.delenv("MINKREF_MODELS", raising=False)
    cases = CaseList(pairs=0)
    names = [case.text for case in cases]
    for pair in ("disc1+cells1815", "disc5+cells1815", "glyph1204+glyph275"):
        assert [name.split("@")[1] for name in names if name.startswith(f"{pair}@")] == [
            "1/3",
            "1",
            "7/5",
            "541/186",
            "9",
        ]
    assert len(cases.notes) == 3
    assert all("is used instead" in note for note in cases.notes)
