"""The set-up: missing Debian packages, the choice of the interpreter, the links of the checkout."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def command(folder: Path, name: str, text: str) -> None:
    path = folder / name
    path.write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
    path.chmod(0o755)


def require(folder: Path, *packages: str, uid: int) -> subprocess.CompletedProcess[str]:
    """require_packages.sh where dpkg-query knows `g++` alone and apt-get only keeps a log."""
    command(folder, "dpkg-query", '[[ ${@: -1} == "g++" ]] && echo -n installed')
    command(folder, "id", f"echo {uid}")
    command(folder, "apt-get", f'echo "$@" >>"{folder}/apt.log"')
    command(folder, "sudo", f'touch "{folder}/sudo_was_called"')
    return subprocess.run(
        [str(ROOT / "tools" / "scripts" / "require_packages.sh"), *packages],
        env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )


def test_root_installs_what_is_missing_and_names_each(tmp_path: Path) -> None:
    done = require(tmp_path, "g++", "libgmp-dev", "libmpfr-dev", uid=0)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        "minkref: installing the Debian package libgmp-dev",
        "minkref: installing the Debian package libmpfr-dev",
    ]
    log = (tmp_path / "apt.log").read_text(encoding="utf-8")
    assert log.split()[-2:] == ["libgmp-dev", "libmpfr-dev"]
    assert "g++" not in log


def test_others_get_one_line_to_run_and_exit_code_2(tmp_path: Path) -> None:
    done = require(tmp_path, "g++", "libgmp-dev", "libmpfr-dev", uid=1000)
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1] == "apt-get install libgmp-dev libmpfr-dev"
    assert not (tmp_path / "apt.log").exists()
    assert not (tmp_path / "sudo_was_called").exists()


def test_nothing_is_done_where_nothing_is_missing(tmp_path: Path) -> None:
    done = require(tmp_path, "g++", uid=1000)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_an_interpreter_that_is_too_old_is_passed_over(tmp_path: Path) -> None:
    command(tmp_path, "python3", "exit 1")
    done = subprocess.run(
        [str(ROOT / "tools" / "scripts" / "find_python.sh")],
        env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", "PYTHON": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0
    assert Path(done.stdout.strip()).is_file()
    assert Path(done.stdout.strip()).parent != tmp_path


def ninja_plan(target: str) -> str:
    build = ROOT / "build" / "release"
    done = subprocess.run(
        ["ninja", "-C", str(build), "-t", "commands", target], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_main_job_waits_for_no_test_and_no_program_that_it_does_not_call() -> None:
    plan = ninja_plan("minkref_run")
    assert "bindings/core_sum.cpp" in plan
    assert "oracle/cgal/reduced.cpp" in plan and "oracle/cgal/space_nef.cpp" in plan
    for other in ("tests/", "oracle/cgal/swept", "oracle/checker/", "oracle/sampled/"):
        assert f"{ROOT}/{other}" not in plan
