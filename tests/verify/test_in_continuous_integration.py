"""`minkref verify` where nobody watches: a limit on the whole run, accepted faults, annotations,
lines of progress."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from minkref.cli import progress_lines
from minkref.cli.cli import run
from minkref.cli.progress import progress

WRONG = "py:faulty_sums:nothing"
QUICK = ("--family", "random", "--no-models", "--jobs", "1", "--shrink-calls", "0")


@pytest.fixture
def minkref(faulty_sums: None, capsys: pytest.CaptureFixture[str]) -> Any:
    def call(*arguments: str | Path) -> tuple[int, str, str]:
        code = run(["verify", *(str(argument) for argument in arguments)])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return call


def test_time_limit_ends_the_whole_run_and_keeps_its_verdicts(minkref: Any) -> None:
    began = time.monotonic()
    code, out, _ = minkref(
        "minkref:paper", "--seconds", "600", *QUICK, "--time-limit", "4", "--json"
    )
    assert time.monotonic() - began < 60
    value = json.loads(out)
    assert code in (0, 2) and value["exit_code"] == code, "2 where the machine judged no case"
    assert value["ended_by"] == "time-limit"
    assert any("--time-limit 4" in note for note in value["notes"])


def test_time_limit_that_is_not_reached_changes_nothing(minkref: Any) -> None:
    two = ("minkref:paper", "--pairs", "2", *QUICK, "--json")
    assert json.loads(minkref(*two, "--time-limit", "500")[1])["ended_by"] is None


def test_a_written_baseline_accepts_what_the_run_found(minkref: Any, tmp_path: Path) -> None:
    known = tmp_path / "known.json"
    run_of_four = (WRONG, "--pairs", "4", "--no-derived", *QUICK)
    assert minkref(*run_of_four)[0] == 1
    assert minkref(*run_of_four, "--write-baseline", known)[0] == 0
    entries = json.loads(known.read_text(encoding="utf-8"))["entries"]
    assert [(e["target"], e["version"], e["kind"]) for e in entries] == [(WRONG, "*", "component")]
    code, out, _ = minkref(*run_of_four, "--baseline", known, "--json")
    assert code == 0
    assert {finding["verdict"] for finding in json.loads(out)["findings"]} == {"known"}
    again = tmp_path / "again.json"
    minkref(*run_of_four, "--baseline", known, "--write-baseline", again)
    assert again.read_text(encoding="utf-8") == known.read_text(encoding="utf-8")


def test_findings_are_annotations_on_github_only(
    minkref: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    two = (WRONG, "--pairs", "2", "--no-derived", *QUICK, "--quiet")
    assert minkref(*two) == (1, "", "")
    code, out, err = minkref(*two, "--annotations", "github")
    assert (code, out) == (1, "")
    (line,) = err.splitlines()
    assert line.startswith(f"::error title={WRONG.replace(':', '%3A')} wrong%3A component")
    assert "witness (" in line.partition("::error ")[2].partition("::")[2]
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    assert minkref(*two) == (code, out, err)
    assert minkref(*two, "--annotations", "none") == (1, "", "")


def test_other_annotations_are_refused(minkref: Any) -> None:
    code, _, err = minkref(WRONG, "--annotations", "gitlab")
    assert code == 2 and "github" in err


def test_long_work_without_a_terminal_writes_lines(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress_lines, "SECONDS", 0.05)
    assert not sys.stderr.isatty()
    with progress(8) as steps:
        steps.now("the third part")
        steps.done(3)
        time.sleep(0.3)
    first, *_ = capsys.readouterr().err.splitlines()
    assert first.startswith("minkref: the third part, 3 of 8, 0:0")
    with progress(8):
        pass
    assert capsys.readouterr().err == ""


def test_every_command_takes_a_short_request_for_help(capsys: pytest.CaptureFixture[str]) -> None:
    for words in ([], ["sum"], ["adapter", "new"]):
        assert run([*words, "-h"]) == 0
        short = capsys.readouterr().out
        assert run([*words, "--help"]) == 0
        assert capsys.readouterr().out == short
