"""`--ledger`: a killed run goes on; a file that is no ledger of the run is refused, and kept."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import time
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.errors import Refusal
from minkref.fuzz.run.ledger import Ledger
from processes import program, started
from thoroughness import draws

Verify = Callable[..., Any]
SEED = 19
KILLS = draws(3, 20)
FAULTY = ["py:faulty_sums:loses_holes", "py:faulty_sums:shifted"]
ALWAYS = ["--seed", "3", "--no-models", "--shrink-calls", "0", "--jobs"]
FEW = ["--pairs", "4", *ALWAYS, "1"]
MANY = ["--pairs", str(draws(40, 300)), *ALWAYS, "2"]


@pytest.fixture
def verify(faulty_sums: None, capsys: pytest.CaptureFixture[str]) -> Verify:
    def call(*words: str | Path, code: int = 1) -> Any:
        found = run(["verify", *map(str, words), "--json"])
        said = capsys.readouterr()
        assert found == code, said.err
        assert "Traceback" not in said.err
        return json.loads(said.out)

    return call


def begun(*words: str | Path) -> AbstractContextManager[subprocess.Popen[Any]]:
    """Begins the run as a separate process, which tests can kill."""
    quiet: Any = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    return started(program("verify", *words, "--json"), start_new_session=True, **quiet)


def lines_of(ledger: Path) -> list[str]:
    return ledger.read_text(encoding="utf-8").splitlines() if ledger.exists() else []


def wait_for_lines(process: subprocess.Popen[bytes], ledger: Path, count: int) -> bool:
    """Whether the process still runs when the ledger has `count` lines."""
    end = time.monotonic() + 300
    while process.poll() is None and len(lines_of(ledger)) < count:
        assert time.monotonic() < end, f"no {count} lines in five minutes"
        time.sleep(0.05)
    return process.poll() is None


def facts(value: Any) -> Any:
    """All but times: findings, and how many verdicts of each kind."""
    cells = {(c["target"], c["group"]): (c["verdicts"], c["skips"]) for c in value["matrix"]}
    return value["findings"], cells


def test_run_that_is_killed_again_and_again_loses_nothing(verify: Verify, tmp_path: Path) -> None:
    dice = random.Random(SEED)
    undisturbed = verify(*FAULTY, *MANY)
    ledger = tmp_path / "run.jsonl"
    kept: list[str] = []
    interrupted = 0
    for _ in range(KILLS):
        with begun(*FAULTY, *MANY, "--ledger", ledger) as process:
            wait_for_lines(process, ledger, len(kept) + dice.randint(0, 8))
            time.sleep(dice.uniform(0, 0.05))
            interrupted += process.poll() is None
            os.killpg(process.pid, signal.SIGKILL) if process.poll() is None else None
        lines = lines_of(ledger)
        assert lines[: len(kept)] == kept, f"a line that was written is gone, seed {SEED}"
        kept = lines if not lines or lines[-1].endswith("}") else lines[:-1]
    assert interrupted >= 2
    assert facts(verify(*FAULTY, *MANY, "--ledger", ledger)) == facts(undisturbed)
    numbers = [json.loads(line)["number"] for line in lines_of(ledger)[1:]]
    assert len(numbers) == len(set(numbers))


def test_half_a_line_is_run_again(verify: Verify, tmp_path: Path) -> None:
    options = (*FAULTY, *FEW, "--ledger", tmp_path / "run.jsonl")
    first = verify(*options)
    data = (tmp_path / "run.jsonl").read_bytes()
    for cut in (1, len(data) // 2, len(data) - 5):
        (tmp_path / "run.jsonl").write_bytes(data[: len(data) - cut])
        assert facts(verify(*options)) == facts(first)


def test_damaged_line_is_refused_and_kept(verify: Verify, tmp_path: Path) -> None:
    ledger = tmp_path / "run.jsonl"
    options = ("minkref:paper", *FEW, "--ledger", ledger)
    verify(*options, code=0)
    whole = ledger.read_bytes()
    for line in (
        b"{",
        b"",
        b"[1, 2]",
        b"7",
        b"null",
        b"\xff\xfe",
        b"[" * 100_000,
        b"{}",
        b'{"number": 1}',
    ):
        ledger.write_bytes(whole + line + b"\n")
        assert verify(*options, code=2)["error"]["where"].startswith(str(ledger)), line
        assert ledger.read_bytes() == whole + line + b"\n"


@pytest.mark.parametrize("content", [b"notes", b"notes\n", b"notes\nmore", b'{"P": 1}', b"\n"])
def test_file_that_is_no_ledger_is_refused_and_kept(
    verify: Verify, tmp_path: Path, content: bytes
) -> None:
    file = tmp_path / "precious"
    file.write_bytes(content)
    assert verify("minkref:paper", *FEW, "--ledger", file, code=2)["error"]["what"]
    assert file.read_bytes() == content


def test_ledger_of_another_run_is_refused_and_kept(verify: Verify, tmp_path: Path) -> None:
    ledger = tmp_path / "run.jsonl"
    verify("minkref:paper", *FEW, "--ledger", ledger, code=0)
    before = ledger.read_bytes()
    for other in (["--seed", "4"], ["--pairs", "31"], ["--call-seconds", "9"]):
        options = dict(zip(*[iter([*FEW[:4], *FEW[5:], *other])] * 2, strict=True))  # the last one
        words = [word for pair in options.items() for word in pair]
        value = verify("minkref:paper", "--no-models", *words, "--ledger", ledger, code=2)
        assert value["error"]["code"] == "other-ledger", other
        assert ledger.read_bytes() == before


def test_place_that_cannot_be_written_is_refused(verify: Verify, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for place in (tmp_path, tmp_path / "no" / "file", pipe, Path("/dev/full")):
        assert verify("minkref:paper", *FEW, "--ledger", place, code=2)["error"]["what"], place


def test_second_run_on_a_ledger_is_refused_and_the_first_goes_on(
    verify: Verify, tmp_path: Path
) -> None:
    ledger = tmp_path / "run.jsonl"
    long = ("minkref:paper", "--pairs", "1000000", *ALWAYS, "1", "--ledger", ledger)
    with begun(*long) as first:
        assert wait_for_lines(first, ledger, 1)
        error = verify(*long, code=2)["error"]
        assert wait_for_lines(first, ledger, len(lines_of(ledger)) + 2)
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
