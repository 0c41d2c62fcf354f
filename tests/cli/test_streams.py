"""Standard streams that are closed, full, or differently encoded; signals."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from processes import program, started
from thoroughness import some

MINKREF = f"{sys.executable} -m minkref"
SIGNALS = [
    (ending, number)
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
    for ending in ("json", "parquet")
]


def shell(line: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["bash", "-c", line], capture_output=True, text=True, env={**os.environ, **environment}
    )


@pytest.mark.parametrize(
    "command", ["sum g1 g3", "models", "--help", "verify minkref:paper --pairs 1 --no-models"]
)
def test_closed_pipe_exits_141_as_by_sigpipe(command: str) -> None:
    ran = shell(f"{MINKREF} {command} | true; exit ${{PIPESTATUS[0]}}")
    assert (ran.returncode, ran.stderr) == (141, "")


@pytest.mark.parametrize("to", [">&-", ">/dev/full"])
def test_output_that_takes_nothing_exits_2_and_says_so(to: str) -> None:
    ran = shell(f"{MINKREF} sum g1 g3 {to}")
    assert ran.returncode == 2
    assert "cannot write to standard output" in ran.stderr


@pytest.mark.parametrize(
    ("stream", "why"), [("<&-", "it is closed"), ("0>/dev/null", "Bad file descriptor")]
)
def test_input_that_cannot_be_read_exits_2_and_says_so(stream: str, why: str) -> None:
    ran = shell(f"{MINKREF} sum - g2 {stream}")
    assert ran.returncode == 2
    assert f"standard input cannot be read: {why}" in ran.stderr


def test_streams_that_a_command_does_not_need_may_be_closed(tmp_path: Path) -> None:
    command = f"{MINKREF} sum g1 g2 -o {tmp_path / 'sum.json'} --scale 7/5"
    assert shell(f"{command} <&- 2>&-").returncode == 0
    assert json.loads((tmp_path / "sum.json").read_text())["polygons"]


@pytest.mark.parametrize("to", ["2>&-", "2>/dev/full"])
def test_refusal_that_nobody_can_read_still_exits_2(to: str) -> None:
    assert shell(f"{MINKREF} sum absent.wkt g3 {to}").returncode == 2


@pytest.mark.parametrize("encoding", ["ascii:strict", "utf-8:strict"])
def test_names_that_the_stream_cannot_say_are_escaped(encoding: str) -> None:
    ran = shell(f"{MINKREF} sum $'\\xff\\u00f1.wkt' g3 --json", PYTHONIOENCODING=encoding)
    assert ran.returncode == 2
    assert json.loads(ran.stdout)["error"]["code"] == "no-such-file"


def seconds_of(process: subprocess.Popen[bytes]) -> float:
    """A process's processor seconds. The start takes less than one second, the rest is
    computation."""
    words = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def test_interrupt_ends_a_sum_that_computes() -> None:
    with started(program("sum", "glyph1204", "cells1815", "--route", "definition")) as process:
        until = time.monotonic() + 60
        while seconds_of(process) < 1 and time.monotonic() < until:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 130


@pytest.mark.parametrize(("ending", "number"), some(SIGNALS, 3))
def test_a_signal_leaves_no_file_that_is_half_written(
    tmp_path: Path, ending: str, number: signal.Signals
) -> None:
    command = program("events", "glyph275", "glyph275", "-o", tmp_path / f"events.{ending}")
    with started(command) as process:
        until = time.monotonic() + 60
        while not any(tmp_path.iterdir()) and time.monotonic() < until:
            time.sleep(0.005)
        assert process.poll() is None
        process.send_signal(number)
        assert process.wait(30) == 128 + number
    assert not list(tmp_path.iterdir())
