"""Two runs into one report folder: the second is refused before any work, and the first run's
report stays."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.output.output_folder import held_folder
from processes import started


def test_a_folder_is_held_until_the_end_and_leaves_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "report"
    with held_folder(folder):
        with pytest.raises(Refusal, match="another run"), held_folder(folder):
            pass
        with held_folder(tmp_path / "other"):
            pass
    with held_folder(folder), held_folder(tmp_path / "new"):
        assert os.listdir(folder) == []


def test_a_process_that_is_killed_holds_no_folder(tmp_path: Path) -> None:
    code = "import sys, pathlib, minkref.output.output_folder as o\n"
    code += (
        "with o.held_folder(pathlib.Path(sys.argv[1])):\n print(1, flush=True); sys.stdin.read()"
    )
    streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with started([sys.executable, "-c", code, str(tmp_path)], **streams) as process:
        assert process.stdout is not None and process.stdout.readline()
        with pytest.raises(Refusal, match="another run"), held_folder(tmp_path):
            pass
        process.send_signal(signal.SIGKILL)
        process.wait()
    with held_folder(tmp_path):
        pass


def test_the_second_run_is_refused(tmp_path: Path) -> None:
    words = [sys.executable, "-m", "minkref", "verify", "minkref:paper", "--pairs", "1"]
    with held_folder(tmp_path / "report"):
        ran = subprocess.run(
            [*words, "--report", "report", "--junit", "junit.xml"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=100,
        )
    assert ran.returncode == 2 and "another run writes to this folder" in ran.stderr
    assert sorted(os.listdir(tmp_path)) == ["report"] and os.listdir(tmp_path / "report") == []
