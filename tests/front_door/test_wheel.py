"""The wheel, as people get it: every command of it works where nothing else is installed."""

from __future__ import annotations

import importlib
import json
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest
from minkref.commands.line.command_group import COMMANDS

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "packaging"


def made(out: Path, *options: str) -> Path:
    command = [sys.executable, PACKAGING / "wheel.py", "--out", out, *options]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return Path(done.stdout.split()[-1])


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Compiled beside build/release, so that the compiler cache answers."""
    return made(tmp_path_factory.mktemp("dist"))


def test_wheel_brings_gmp_and_mpfr_and_the_licences(wheel: Path) -> None:
    assert "manylinux" in wheel.name
    names = [name for name in zipfile.ZipFile(wheel).namelist() if not name.endswith("/")]
    inside = [name.split("/")[1].split("-")[0] for name in names if "minkref.libs/" in name]
    assert sorted(inside) == ["libgmp", "libmpfr"]
    licences = {name.split("licenses/")[1] for name in names if ".dist-info/licenses/" in name}
    kept = {str(file.relative_to(ROOT)) for file in ROOT.glob("LICENSES/*")} | {"LICENSE"}
    assert licences == kept
    assert not [name for name in names if name.endswith((".cpp", ".hpp", "CMakeLists.txt"))
                and "adapters/" not in name and "libraries/" not in name]  # fmt: skip


def test_every_command_is_tried_on_a_bare_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where there is no bubblewrap, and so no bare machine."""
    monkeypatch.syspath_prepend(str(PACKAGING))
    steps = importlib.import_module("bare_commands").STEPS
    assert {step.words[0] for step in steps} >= set(COMMANDS)


@pytest.mark.skipif(not shutil.which("bwrap"), reason="no bubblewrap: no bare machine")
def test_every_command_works_on_a_bare_machine(wheel: Path, tmp_path: Path) -> None:
    figures = tmp_path / "figures.json"
    command = [sys.executable, PACKAGING / "bare.py", wheel, "--quick", "--figures", figures]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert all(not row["faults"] for row in json.loads(figures.read_text(encoding="utf-8")))


def test_source_distribution_holds_what_is_tracked_but_for_the_workplace(tmp_path: Path) -> None:
    archive = made(tmp_path, "--sdist")
    with tarfile.open(archive) as file:
        held = {name.split("/", 1)[1] for name in file.getnames() if "/" in name}
    assert {"CMakeLists.txt", "LICENSE", "LICENSES/THIRD_PARTY.md", "python/core.cpp"} <= held
    assert {"reference/plane/sum.cpp", "packaging/wheel.py", "tests/CMakeLists.txt"} <= held
    first = {name.split("/")[0] for name in held}
    assert not first & {"build", "dist", ".venv", ".ci", ".github", ".devcontainer"}
