"""A run ended by a signal or by our own fault writes all its judgements, whole."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import time
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.run import runner
from minkref.fuzz.run.pool import InternalError
from minkref.fuzz.shrink import groups as shrinking
from processes import program, started
from thoroughness import draws

FOLDER = Path(__file__).parent
MOMENTS = draws(2, 4)
JOBS = str(draws(1, 2))
SEED = 23
WORDS = ["py:faulty_sums:loses_holes", "minkref:winding", "--pairs", "100000", "--jobs", JOBS]
WORDS += ["--no-models", "--shrink-calls", "5"]


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": f"{FOLDER}{os.pathsep}{os.environ.get('PYTHONPATH', '')}"}


def ended(folder: Path, number: int, seconds: float) -> tuple[int, Any, str]:
    """Ends a run a given time after its first result in the ledger."""
    folder.mkdir()
    files = ["--ledger", "run.jsonl", "--report", "report", "--junit", "junit.xml"]
    files += ["--sarif", "verify.sarif", "--markdown", "verify.md", "--lines", "lines.jsonl"]
    with started(
        program("verify", *WORDS, *files, "--json"),
        cwd=folder,
        env=environment(),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        deadline = time.monotonic() + 60
        ledger = folder / "run.jsonl"
        while time.monotonic() < deadline and len(lines_of(ledger)) < 1:
            time.sleep(0.02)
        time.sleep(seconds)
        process.send_signal(number)
        output, errors = process.communicate(timeout=120)
    assert "Traceback" not in errors
    return process.returncode, json.loads(output), errors


def lines_of(ledger: Path) -> list[Any]:
    """The ledger's results, without lines that only say that a case does not exist, and without an
    unfinished last line."""
    if not ledger.is_file():
        return []
    rows = [json.loads(line) for line in ledger.read_text().split("\n")[1:-1]]
    return [row for row in rows if "absent" not in row and "untaken" not in row]


def same_as_the_ledger(folder: Path, value: Any) -> None:
    """Checks that every output holds exactly the judged cases."""
    rows = lines_of(folder / "run.jsonl")
    assert sum(group["cases"] for group in value["groups"]) == len(rows)
    judged: Counter[tuple[str, str]] = Counter()
    for row in rows:
        judged.update((outcome["target"], outcome["verdict"]) for outcome in row["outcomes"])
    shown: Counter[tuple[str, str]] = Counter()
    for cell in value["matrix"]:
        shown.update({(cell["target"], v): n for v, n in cell["verdicts"].items()})
    assert shown == judged
    wrong = sum(n for (_, verdict), n in judged.items() if verdict == "wrong")
    assert len(value["findings"]) == wrong
    assert len((folder / "lines.jsonl").read_text().splitlines()) >= wrong
    suites = ElementTree.parse(folder / "junit.xml").getroot()
    assert {suite.get("name") for suite in suites} == {cell["target"] for cell in value["matrix"]}
    assert bool(json.loads((folder / "verify.sarif").read_text())["runs"][0]["results"]) == bool(
        wrong
    )
    assert (folder / "report" / "index.html").is_file() and (folder / "verify.md").is_file()


def test_a_run_that_is_interrupted_writes_all_that_it_has_judged_and_goes_on(
    tmp_path: Path, follows_schema: Callable[[Any, str], None]
) -> None:
    print("seed", SEED)
    dice = random.Random(SEED)
    for k in range(MOMENTS):
        number = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGINT)[k % 4]
        folder = tmp_path / str(k)
        code, value, _ = ended(folder, number, dice.uniform(0, draws(2, 15) / 10))
        follows_schema(value, "verify")
        assert (code, value["exit_code"]) == (128 + number,) * 2, (SEED, k)
        assert value["ended_by"] == signal.Signals(number).name
        assert any("continues from run.jsonl" in note for note in value["notes"])
        same_as_the_ledger(folder, value)
    goes_on(tmp_path / "0")


def goes_on(folder: Path) -> None:
    """Continues the ledger of an interrupted run, and interrupts the second run too."""
    ledger = folder / "run.jsonl"
    before = ledger.read_text().splitlines()
    words = program("verify", *WORDS, "--ledger", "run.jsonl", "--json")
    with started(words, cwd=ledger.parent, env=environment(), stdout=subprocess.DEVNULL) as process:
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and len(ledger.read_text().splitlines()) <= len(before):
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        assert process.wait(60) == 130
    assert ledger.read_text().splitlines()[: len(before)] == before


def verify_here(*words: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, Any, str]:
    from minkref.cli.cli import run

    more = ("--pairs", "40", "--jobs", "1", "--no-models", "--family", "holes", "--json")
    code = run(["verify", "py:faulty_sums:loses_holes", *more, *words])
    said = capsys.readouterr()
    return code, json.loads(said.out), said.err


def test_a_shrinker_that_fails_costs_no_finding(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(*_: object) -> None:
        raise KeyError("a fault of the shrinker")

    monkeypatch.syspath_prepend(str(FOLDER))
    monkeypatch.setenv("PYTHONPATH", str(FOLDER))
    monkeypatch.setattr(shrinking, "shrink_finding", fails)
    code, value, _ = verify_here(capsys=capsys)
    assert code == 1 and value["findings"] and not value["shrunk"]
    assert any("a fault of the shrinker" in note for note in value["notes"])


def test_a_fault_of_ours_costs_no_finding(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    follows_schema: Callable[[Any, str], None],
) -> None:
    real = runner.run_cases

    def fails(*words: Any) -> Any:
        for number, result in enumerate(real(*words)):
            if number == 30:
                raise InternalError("a fault of the suite")
            yield result

    monkeypatch.syspath_prepend(str(FOLDER))
    monkeypatch.setenv("PYTHONPATH", str(FOLDER))
    monkeypatch.setattr(runner, "run_cases", fails)
    code, value, errors = verify_here("--report", str(tmp_path / "report"), capsys=capsys)
    assert code == 70 and "a fault of the suite" in errors
    follows_schema(value, "verify")
    assert value["exit_code"] == 70 and value["findings"]
    assert sum(group["cases"] for group in value["groups"]) <= 30
    assert (tmp_path / "report" / "index.html").is_file()
