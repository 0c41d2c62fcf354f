"""Installing: once, again after an accident, by one process at a time, and with clear refusals."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.fuzz.isolation import own_folders
from minkref.fuzz.libraries import catalogue, installation

PROGRAM = "toy.cpp"
HOLD = """
import fcntl, sys, time
file = open(sys.argv[1], "w")
fcntl.flock(file, fcntl.LOCK_EX)
print("held", flush=True)
time.sleep(60)
"""


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of libraries with one small program."""
    folder = tmp_path / "package" / "fuzz" / "libraries"
    folder.mkdir(parents=True)
    (folder / PROGRAM).write_text("int main() { return 7; }\n", encoding="utf-8")
    monkeypatch.setattr(installation, "HERE", folder)
    monkeypatch.delenv("CXX", raising=False)
    return folder


def install(home: Path) -> None:
    installation.install_home(home, "c++", PROGRAM)


def state(home: Path) -> str:
    return installation.state_of(home, "c++", PROGRAM)


def test_an_installation_is_made_once(sources: Path, tmp_path: Path) -> None:
    home = tmp_path / "adapters" / "toy"
    assert state(home) == "not installed"
    install(home)
    assert state(home) == ""
    assert subprocess.run([str(installation.binary(home))], check=False).returncode == 7
    before = installation.binary(home).stat().st_mtime_ns
    install(home)
    assert installation.binary(home).stat().st_mtime_ns == before


def test_another_source_is_another_installation(sources: Path, tmp_path: Path) -> None:
    home = tmp_path / "toy"
    install(home)
    (sources / PROGRAM).write_text("int main() { return 8; }\n", encoding="utf-8")
    assert state(home) == "out of date"
    install(home)
    assert subprocess.run([str(installation.binary(home))], check=False).returncode == 8


def test_what_was_left_half_done_is_made_anew(sources: Path, tmp_path: Path) -> None:
    home = tmp_path / "toy"
    install(home)
    (home / installation.STAMP).unlink()
    (home / "rubbish").write_text("left over", encoding="utf-8")
    assert state(home) == "not installed"
    install(home)
    assert state(home) == ""
    assert not (home / "rubbish").exists()


def test_two_at_once_install_once(sources: Path, tmp_path: Path) -> None:
    home = tmp_path / "toy"
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(install, [home, home]))
    assert state(home) == ""


def test_a_process_waits_for_another(sources: Path, tmp_path: Path) -> None:
    """The lock is between processes, and ends with its holder."""
    lock = str(tmp_path / ".toy.lock")
    holder = subprocess.Popen([sys.executable, "-c", HOLD, lock], stdout=subprocess.PIPE, text=True)
    assert holder.stdout is not None
    assert holder.stdout.readline() == "held\n"
    with ThreadPoolExecutor(1) as pool:
        waiting = pool.submit(install, tmp_path / "toy")
        time.sleep(0.5)
        assert not waiting.done()
        holder.kill()
        holder.wait()
        waiting.result(60)
    assert state(tmp_path / "toy") == ""


def test_a_compiler_that_fails_is_quoted(sources: Path, tmp_path: Path) -> None:
    (sources / PROGRAM).write_text("int main() { no_such_name(); }\n", encoding="utf-8")
    with pytest.raises(Refusal, match="no_such_name"):
        install(tmp_path / "toy")
    assert state(tmp_path / "toy") == "not installed"


def test_no_compiler(sources: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "COMPILERS", ())
    with pytest.raises(Refusal, match="no C\\+\\+ compiler") as refused:
        install(tmp_path / "toy")
    assert "apt-get install" in refused.value.mend


def test_a_folder_that_cannot_be_made(sources: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(Refusal) as refused:
        install(tmp_path / "file" / "toy")
    assert "MINKREF_ADAPTERS" in refused.value.mend


def test_a_package_of_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    missing = installation.missing_package("no-such-program", "no-such-package")
    assert missing is not None
    assert "apt-get install -y --no-install-recommends no-such-package" in missing
    assert installation.missing_package("sh", "dash") is None
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    with pytest.raises(Refusal) as refused:
        installation.install_package("no-such-program", "no-such-package")
    assert "as root" in refused.value.mend


def test_every_adapter_has_its_files(tmp_path: Path) -> None:
    for name, adapter in catalogue.ADAPTERS.items():
        assert adapter.name == name
        if adapter.kind == "cgal":
            continue
        program = catalogue.HERE / adapter.program
        assert program.is_file()
        if adapter.kind == "python":
            pins = program.with_name("requirements.txt")
            assert f"{adapter.home}==" in pins.read_text(encoding="utf-8")
        if adapter.kind in ("python", "c++"):
            said = catalogue.absence(name, tmp_path)
            assert said == f"{name} is not installed: minkref adapter install {name}"
            assert catalogue.command(name, tmp_path) is None


def test_another_version_has_a_folder_of_its_own(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The other packages stay at their pinned versions, and the pinned folder is left alone."""
    asked: list[tuple[str, ...]] = []
    monkeypatch.setattr(installation, "_make_empty_environment", lambda folder: folder.mkdir())
    monkeypatch.setattr(installation, "_pip", lambda *words: asked.append(words[1:]))
    catalogue.install("manifold3d-offset@3.0.1", tmp_path)
    assert asked == [("install", "--only-binary", ":all:", "manifold3d==3.0.1", "numpy==2.4.6")]
    assert sorted(path.name for path in tmp_path.glob("[!.]*")) == ["manifold3d@3.0.1"]
    assert (
        catalogue.is_named("geos@2.0.7") and "2.0.7" in catalogue.adapter_named("geos@2.0.7").title
    )
    for name in ("geos@", "geos@../x", "geos@2;x", "clipper2@1.0", "no-such@1.0"):
        with pytest.raises(Refusal, match="no adapter"):
            catalogue.install(name, tmp_path)


def test_an_unknown_name_is_refused() -> None:
    for function in (catalogue.install, catalogue.command, catalogue.absence):
        with pytest.raises(Refusal, match="no adapter 'no-such'"):
            function("no-such")


def test_the_default_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("MINKREF_ADAPTERS", str(tmp_path))
    assert own_folders.adapters_folder() == tmp_path
    monkeypatch.delenv("MINKREF_ADAPTERS")
    root = Path(__file__).resolve().parents[2]
    assert own_folders.adapters_folder() == root / "build" / "adapters"
    monkeypatch.setattr(own_folders, "HERE", tmp_path / "site" / "minkref" / "fuzz" / "isolation")
    assert own_folders.adapters_folder() == Path.home() / ".cache" / "minkref" / "adapters"
