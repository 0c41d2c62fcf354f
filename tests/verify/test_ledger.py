"""`--ledger`: a run that is killed goes on; what is no ledger of the run is refused, and kept."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from minkref.errors import Refusal
from minkref.fuzz.run.ledger import Ledger

KILLS = 20
FAULTY = "py:faulty_sums:loses_holes"
COMMAND = [sys.executable, "-m", "minkref", "verify", FAULTY, "py:faulty_sums:shifted"]
FEW = ["--pairs", "30", "--seed", "3", "--no-models", "--shrink-calls", "0", "--jobs", "1"]
MANY = ["--pairs", "300", "--seed", "3", "--no-models", "--shrink-calls", "0", "--jobs", "2"]


@pytest.fixture
def environment() -> dict[str, str]:
    paths = [str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}


def verify(environment: dict[str, str], *options: str | Path, code: int = 1) -> Any:
    words = [*COMMAND, *map(str, options), "--json"]
    ran = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=300)
    assert ran.returncode == code, ran.stderr
    assert "Traceback" not in ran.stderr
    return json.loads(ran.stdout)


def facts(value: Any) -> Any:
    """All but times: findings, and how many verdicts of each kind."""
    cells = {(c["target"], c["group"]): (c["verdicts"], c["skips"]) for c in value["matrix"]}
    return value["findings"], cells


def test_run_that_is_killed_again_and_again_loses_nothing(
    environment: dict[str, str], tmp_path: Path
) -> None:
    dice = random.Random(19)
    undisturbed = verify(environment, *MANY)
    ledger = tmp_path / "run.jsonl"
    words = [*COMMAND, *MANY, "--ledger", str(ledger), "--json"]
    quiet: Any = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    kept: list[str] = []
    interrupted = 0
    for _ in range(KILLS):
        with subprocess.Popen(words, env=environment, start_new_session=True, **quiet) as process:
            time.sleep(dice.uniform(0.3, 2.5))
            interrupted += process.poll() is None
            os.killpg(process.pid, signal.SIGKILL) if process.poll() is None else None
        lines = ledger.read_text(encoding="utf-8").splitlines() if ledger.exists() else []
        assert lines[: len(kept)] == kept, "a line that was written is gone"
        kept = lines if not lines or lines[-1].endswith("}") else lines[:-1]
    assert interrupted >= 2
    assert facts(verify(environment, *MANY, "--ledger", ledger)) == facts(undisturbed)
    numbers = [json.loads(line)["number"] for line in ledger.read_text().splitlines()[1:]]
    assert len(numbers) == len(set(numbers))


def test_half_a_line_is_run_again(environment: dict[str, str], tmp_path: Path) -> None:
    ledger = tmp_path / "run.jsonl"
    first = verify(environment, *FEW, "--ledger", ledger)
    data = ledger.read_bytes()
    for cut in (1, len(data) // 2, len(data) - 5):
        ledger.write_bytes(data[: len(data) - cut])
        assert facts(verify(environment, *FEW, "--ledger", ledger)) == facts(first)


@pytest.mark.parametrize(
    "line",
    [b"{", b"", b"[1, 2]", b"7", b"null", b"\xff\xfe", b"[" * 100_000, b"{}", b'{"number": 1}'],
)
def test_damaged_line_is_refused_and_kept(
    environment: dict[str, str], tmp_path: Path, line: bytes
) -> None:
    ledger = tmp_path / "run.jsonl"
    options = ("--pairs", "2", *FEW[2:], "--ledger", ledger)
    verify(environment, *options)
    with ledger.open("ab") as file:
        file.write(line + b"\n")
    before = ledger.read_bytes()
    assert verify(environment, *options, code=2)["error"]["where"].startswith(str(ledger))
    assert ledger.read_bytes() == before


@pytest.mark.parametrize("content", [b"notes", b"notes\n", b"notes\nmore", b'{"P": 1}', b"\n"])
def test_file_that_is_no_ledger_is_refused_and_kept(
    environment: dict[str, str], tmp_path: Path, content: bytes
) -> None:
    file = tmp_path / "precious"
    file.write_bytes(content)
    assert verify(environment, *FEW, "--ledger", file, code=2)["error"]["what"]
    assert file.read_bytes() == content


@pytest.mark.parametrize("options", [["--seed", "4"], ["--pairs", "31"], ["--call-seconds", "9"]])
def test_ledger_of_another_run_is_refused_and_kept(
    environment: dict[str, str], tmp_path: Path, options: list[str]
) -> None:
    ledger = tmp_path / "run.jsonl"
    few = ("--pairs", "2", *FEW[2:])
    verify(environment, *few, "--ledger", ledger)
    before = ledger.read_bytes()
    error = verify(environment, *few, *options, "--ledger", ledger, code=2)["error"]
    assert error["code"] == "other-ledger"
    assert ledger.read_bytes() == before


def test_place_that_cannot_be_written_is_refused(
    environment: dict[str, str], tmp_path: Path
) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for place in (tmp_path, tmp_path / "no" / "file", pipe, Path("/dev/full")):
        assert verify(environment, *FEW, "--ledger", place, code=2)["error"]["what"]


def test_second_run_on_a_ledger_is_refused_and_the_first_goes_on(
    environment: dict[str, str], tmp_path: Path
) -> None:
    ledger = tmp_path / "run.jsonl"
    long = [*MANY, "--pairs", "1000000", "--ledger", str(ledger)]
    quiet: Any = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with subprocess.Popen([*COMMAND, *long], env=environment, **quiet) as first:
        deadline = time.monotonic() + 30
        while (not ledger.exists() or not ledger.stat().st_size) and time.monotonic() < deadline:
            time.sleep(0.05)
        error = verify(environment, *long, code=2)["error"]
        before = ledger.stat().st_size
        time.sleep(2)
        assert first.poll() is None
        assert ledger.stat().st_size > before
        first.terminate()
    assert "another run" in error["what"]


def test_a_file_of_any_length_and_memory_itself_are_no_ledgers(tmp_path: Path) -> None:
    sparse, memory = tmp_path / "sparse.jsonl", tmp_path / "memory.jsonl"
    with sparse.open("wb") as stream:
        stream.truncate(1 << 33)
    memory.symlink_to("/proc/self/mem")
    for path, word in ((sparse, "first line"), (memory, "cannot be")):
        with pytest.raises(Refusal, match=word):
            Ledger(path, {"targets": []})
