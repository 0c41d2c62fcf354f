"""The wheel, as people get it: every command works on an otherwise empty machine."""

from __future__ import annotations

import base64
import hashlib
import importlib
import json
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Iterable
from pathlib import Path

import pytest
from minkref.cli.command_group import COMMANDS

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "tools" / "packaging"


def made(out: Path, *options: str) -> Path:
    command = [sys.executable, PACKAGING / "wheel.py", "--out", out, *options]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return Path(done.stdout.split()[-1])


def spoken(texts: Iterable[bytes]) -> set[str]:
    """The licences that files name at their head; the project's own files need none."""
    found = (re.match(rb"\W+SPDX-License-Identifier: (\S+)", text) for text in texts)
    return {one[1].decode() for one in found if one}


def test_the_installed_tree_is_the_package_and_works_alone(tmp_path: Path) -> None:
    """Tests the installed component that makes a wheel, without compiling; a thorough run tries the
    wheels themselves."""
    command = ["cmake", "--install", ROOT / "build" / "release", "--component", "python"]
    subprocess.run([*command, "--prefix", tmp_path], check=True, capture_output=True)
    (package,) = (path.parent for path in tmp_path.rglob("minkref/api.py"))
    names = {str(path.relative_to(package)) for path in package.rglob("*") if path.is_file()}
    table = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    for name, room in table["tool"]["scikit-build"]["wheel"]["packages"].items():
        below = name.removeprefix("minkref").strip("/")
        modules = {str(p.relative_to(ROOT / room)) for p in (ROOT / room).rglob("*.py")}
        assert {str(Path(below, module)) for module in modules} <= names, room
    assert any(name.startswith("_core.") for name in names) and "_core.pyi" in names
    words = ["-c", "import minkref; print(minkref.__file__, minkref.minkowski_sum)"]
    said = subprocess.run(
        [sys.executable, *words], cwd=tmp_path, env={"PYTHONPATH": str(package.parent)},
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    assert said.startswith(str(package))


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Compiled beside build/release, so that the compiler cache answers."""
    return made(tmp_path_factory.mktemp("dist"))


@pytest.mark.thorough
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


@pytest.mark.thorough
def test_the_licence_of_the_wheel_is_that_of_all_that_is_inside(wheel: Path) -> None:
    table = (ROOT / "LICENSES" / "THIRD_PARTY.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| .* \| .*`minkref.* \| ([A-Z][\w.-]+)", table, re.MULTILINE)
    assert len(rows) == 7
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (one for one in archive.namelist() if one.endswith(".dist-info/METADATA"))
        metadata = archive.read(name)
        record = archive.read(name.replace("METADATA", "RECORD")).decode()
        named = spoken(archive.read(one) for one in archive.namelist())
    (said,) = re.findall(r"^License-Expression: (.*)$", metadata.decode(), re.MULTILINE)
    assert said.split(" AND ") == sorted({"Apache-2.0", *rows}) and named <= set(rows)
    digest = base64.urlsafe_b64encode(hashlib.sha256(metadata).digest()).rstrip(b"=").decode()
    assert f"{name},sha256={digest},{len(metadata)}" in record.splitlines()


def test_every_command_is_tried_on_a_bare_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """Runs even without bubblewrap, which a bare machine needs."""
    monkeypatch.syspath_prepend(str(PACKAGING))
    steps = importlib.import_module("bare_commands").STEPS
    assert {step.words[0] for step in steps} >= set(COMMANDS)


@pytest.mark.thorough
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
        file.extractall(tmp_path)  # our own; Debian's Python 3.11.2 knows no filter
    sources = tmp_path / archive.name.removesuffix(".tar.gz")
    held = {str(path.relative_to(sources)) for path in sources.rglob("*") if path.is_file()}
    assert {"CMakeLists.txt", "LICENSE", "LICENSES/THIRD_PARTY.md", "bindings/core.cpp"} <= held
    assert {"reference/plane/sum.cpp", "tools/packaging/wheel.py", "tests/CMakeLists.txt"} <= held
    first = {name.split("/")[0] for name in held}
    assert not first & {"build", "dist", ".venv", ".ci", ".github", ".devcontainer"}
    # Nothing under the GPL, which has a different expression; CMake does without GPL code.
    assert "License-Expression: Apache-2.0\n" in (sources / "PKG-INFO").read_text(encoding="utf-8")
    assert spoken((sources / name).read_bytes() for name in held) <= {"Apache-2.0"}
    assert not any("oracle/cgal/" in name or "minkref-cgal/" in name for name in held)
    parts = ("CHECKER", "SAMPLED", "BOOST", "TESTS", "FORMATS")
    options = [f"-DMINKREF_{part}=OFF" for part in parts]
    command = ["cmake", "-S", sources, "-B", tmp_path / "build", *options]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    assert "MINKREF_CGAL is off: oracle/cgal (GPL-3.0-or-later)" in ran.stdout
