"""The packages besides the wheel: their files are whole, and agree with the project."""

from __future__ import annotations

import ast
import importlib
import json
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "tools" / "packaging"


def project(folder: Path) -> dict[str, Any]:
    return tomllib.loads((folder / "pyproject.toml").read_text(encoding="utf-8"))


VERSION = project(ROOT)["project"]["version"]
# Options of CMakeLists.txt that only a top-level project turns on: packages do without them.
OPTIONS = set(
    re.findall(
        r"^option\(MINKREF_(\w+) .* \$\{PROJECT_IS_TOP_LEVEL\}\)$",
        (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
) - {"INSTALL", "UNITY"}


def test_vcpkg_port_builds_the_library_alone() -> None:
    port = json.loads((PACKAGING / "vcpkg/minkref/vcpkg.json").read_text(encoding="utf-8"))
    manifest = json.loads((ROOT / "vcpkg.json").read_text(encoding="utf-8"))
    assert port["version"] == VERSION
    names = [entry for entry in port["dependencies"] if isinstance(entry, str)]
    assert names == manifest["dependencies"]
    recipe = (PACKAGING / "vcpkg/minkref/portfile.cmake").read_text(encoding="utf-8")
    off = re.findall(r"-DMINKREF_(\w+)=OFF", recipe)
    assert sorted(off) == sorted(OPTIONS)


@pytest.mark.skipif(not shutil.which("cmake"), reason="no CMake")
def test_conan_recipe_configures_the_library_alone(tmp_path: Path) -> None:
    source = (PACKAGING / "conan/conanfile.py").read_text(encoding="utf-8")
    assigned = {
        node.targets[0].id: node.value
        for node in ast.parse(source).body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    off = ast.literal_eval(assigned["PARTS"])
    assert sorted(off) == sorted(OPTIONS)
    ast.parse((PACKAGING / "conan/test_package/conanfile.py").read_text(encoding="utf-8"))
    for pattern in ast.literal_eval(assigned["SOURCES"]):
        for path in ROOT.glob(pattern):
            copied = tmp_path / "source" / path.relative_to(ROOT)
            copied.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if path.is_dir() else shutil.copy)(path, copied)
    options = [f"-DMINKREF_{part}=OFF" for part in off]
    command = ["cmake", "-S", tmp_path / "source", "-B", tmp_path / "build", *options]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr


def test_container_installs_what_it_has_built() -> None:
    text = (ROOT / "Containerfile").read_text(encoding="utf-8")
    stages = text.split("FROM ")[1:]
    assert [stage.split()[0] for stage in stages] == ["debian:12", "debian:12-slim"]
    assert not re.search(r"g\+\+|-dev\b|cmake", stages[1]), "no compiler in the second stage"
    assert "USER minkref" in stages[1]
    extras = set(re.search(r"\[([a-z,]+)\]", stages[1])[1].split(","))  # type: ignore[index]
    assert extras <= set(project(ROOT)["project"]["optional-dependencies"])


def test_devcontainer_calls_what_there_is() -> None:
    text = (ROOT / ".devcontainer" / "devcontainer.json").read_text(encoding="utf-8")
    settings = json.loads(text)
    assert settings["onCreateCommand"].split()[1:] == ["tools/scripts/set_up.sh", "packages"]
    assert settings["postCreateCommand"] == "make setup"


def test_programs_of_cgal_are_a_package_under_the_gpl() -> None:
    ours = project(PACKAGING / "minkref-cgal")["project"]
    assert (ours["version"], ours["license"]) == (VERSION, "Apache-2.0 AND GPL-3.0-or-later")
    wheel = project(ROOT)["tool"]["scikit-build"]
    assert "cgal" not in json.dumps(wheel["wheel"]["packages"])
    assert wheel["install"]["components"] == ["python"]


@pytest.fixture(scope="module")
def sources_of_cgal(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("cgal")
    command = [sys.executable, PACKAGING / "wheel.py", "--sdist", "--out", folder]
    subprocess.run([*command, "--project", PACKAGING / "minkref-cgal"], check=True)
    (archive,) = folder.glob("minkref_cgal-*.tar.gz")
    with tarfile.open(archive) as file:
        file.extractall(folder)  # our own; Debian's Python 3.11.2 knows no filter
    (sources,) = (path for path in folder.iterdir() if path.is_dir())
    return sources


def test_programs_of_cgal_bring_the_licences_of_all_that_is_in_them(
    sources_of_cgal: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also tries a wheel built from the source distribution alone."""
    monkeypatch.syspath_prepend(str(PACKAGING))
    stated = importlib.import_module("licence").IN_WHEELS["minkref_cgal"].split(" AND ")
    for file in sources_of_cgal.rglob("*.?pp"):
        assert file.read_text(encoding="utf-8").startswith("// SPDX-License-Identifier: GPL-3.0-")
    for number, folder in enumerate((PACKAGING / "minkref-cgal", sources_of_cgal)):
        made = tmp_path / str(number)
        code = f"import scikit_build_core.build as b; b.prepare_metadata_for_build_wheel('{made}')"
        subprocess.run([sys.executable, "-c", code], cwd=folder, check=True, capture_output=True)
        texts = [path.name for path in made.glob("*.dist-info/licenses/*")]
        assert sorted(one for one in stated for text in texts if text.startswith(one)) == stated


@pytest.mark.skipif(not shutil.which("cmake"), reason="no CMake")
def test_programs_of_cgal_configure_from_their_source_distribution(
    sources_of_cgal: Path, tmp_path: Path
) -> None:
    words = ["cmake", "-S", sources_of_cgal, "-B", tmp_path / "build", "-G", "Ninja"]
    done = subprocess.run(words, capture_output=True, text=True)
    if "CGAL was not found" in done.stderr:
        pytest.skip("no CGAL")
    assert done.returncode == 0, done.stderr
