"""`pip install .` in a clean virtual environment gives a package that computes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import venv
from pathlib import Path

import minkref

ROOT = Path(__file__).resolve().parents[2]
IMPORTS = "import minkref.fuzz, minkref.reports, minkref._core as core; print(core.__file__)"


def test_pip_install_gives_a_working_command(tmp_path: Path) -> None:
    venv.create(tmp_path / "clean", with_pip=True)
    binary = tmp_path / "clean" / "bin"
    # The flags of the checkout's own build, so that ccache can answer.
    # (Spelt out: the pip of Debian 12 does not know -C.)
    values = ["cmake.define.MINKREF_WERROR=ON", f"build-dir={tmp_path / 'build'}"]
    settings = [f"--config-settings={value}" for value in values]
    subprocess.run(
        [str(binary / "python"), "-m", "pip", "install", "--quiet", *settings, str(ROOT)],
        check=True,
        cwd=tmp_path,
    )
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}

    def minkref_command(*arguments: str) -> str:
        done = subprocess.run(
            [str(binary / "minkref"), *arguments],
            check=True,
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env=clean,
        )
        return done.stdout

    assert minkref.__version__ in minkref_command("--version")
    summed = json.loads(minkref_command("sum", "g1", "g2", "--json"))
    assert "\u286a" in minkref_command("sum", "g1", "g2", "--plot", "-o", "sum.svg")
    assert (tmp_path / "sum.svg").is_file()
    where = subprocess.run(
        [str(binary / "python"), "-c", IMPORTS],
        check=True,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=clean,
    )
    assert Path(where.stdout.strip()).is_relative_to(tmp_path / "clean")
    lacking = subprocess.run(
        [str(binary / "minkref"), "report", "audit"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=clean,
    )
    assert lacking.returncode == 2 and "pip install 'minkref[reports]'" in lacking.stderr
    assert "view.html" in minkref_command("view", "g1", "g2")
    assert (tmp_path / "view.html").stat().st_size > 10_000
    here = subprocess.run(
        [str(Path(sys.executable).parent / "minkref"), "sum", "g1", "g2", "--json"],
        check=True,
        capture_output=True,
        text=True,
    )
    assert summed["digest"] == json.loads(here.stdout)["digest"]
