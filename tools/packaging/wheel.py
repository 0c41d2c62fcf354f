"""Makes the distributions of minkref: `make wheel` and `make sdist`.

wheel.py [--python PYTHON] [--project FOLDER] [--out FOLDER] [--sdist]: builds a wheel for PYTHON
(that of .venv), puts the shared libraries that it needs inside (auditwheel), and leaves it in
dist/; with --sdist the source distribution instead. Prints the path of the file. What is compiled
stays in build/wheel-*, so that a second call compiles what has changed only. docs/packages.md says
why GMP and MPFR are shared libraries in the wheel.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from pathlib import Path

import licence

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
TOOLS = Path(sysconfig.get_path("scripts"))
BUILDERS = ("nanobind", "scikit-build-core")


def call(*command: str | Path) -> str:
    """Runs a command and returns its output; on failure prints the output and exits."""
    environment = os.environ | {"PATH": f"{TOOLS}{os.pathsep}{os.environ['PATH']}"}
    environment.setdefault("SOURCE_DATE_EPOCH", last_change())
    environment.setdefault("CXX", "c++")  # the name that CMake finds and the compiler cache knows
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        print(done.stdout, file=sys.stderr)
        sys.exit(f"minkref: {command[0]} ended with {done.returncode}")
    return done.stdout


def last_change() -> str:
    """The last commit's time, so that equal sources give equal archives; without git, as in a
    source distribution, the time of pyproject.toml."""
    command = ["git", "-C", str(ROOT), "log", "-1", "--format=%ct"]
    said = subprocess.run(command, capture_output=True, text=True).stdout.strip()
    return said or str(int((ROOT / "pyproject.toml").stat().st_mtime))


def environment_for(python: str | None) -> Path:
    """An interpreter with the build tools: without `python` .venv's own, else a new environment's,
    with the tools at the versions of requirements.txt."""
    if python is None:
        return Path(sys.executable)
    asked = "import sys; print(sys.implementation.cache_tag)"
    folder = BUILD / f"environment-{call(python, '-c', asked).strip()}"
    uv = TOOLS / "uv"
    if not (folder / "bin" / "python").exists():
        call(uv, "venv", "--quiet", "--python", python, folder)
    pinned = ("--constraint", ROOT / "requirements.txt")
    call(uv, "pip", "install", "--quiet", "--python", folder, *pinned, *BUILDERS)
    return folder / "bin" / "python"


def name_of(project: Path) -> str:
    text = (project / "pyproject.toml").read_text(encoding="utf-8")
    return str(tomllib.loads(text)["project"]["name"])


def build(project: Path, python: Path, out: Path, *kind: str) -> Path:
    """Builds the wheel or the source distribution with the project's own back end."""
    with tempfile.TemporaryDirectory() as folder:
        # With the warnings of the checkout's own build the compiler cache can answer.
        settings: tuple[str, ...] = (
            ("-C", "cmake.define.MINKREF_WERROR=ON") if kind[0] == "--wheel" else ()
        )
        # The cache also needs a folder beside build/release, since it relates paths to the build
        # folder.
        settings += ("-C", f"build-dir={BUILD}/wheel-{name_of(project)}-{{wheel_tag}}")
        options = ("--no-build-isolation", "--python", python, "--out-dir", folder)
        call(TOOLS / "uv", "build", "--quiet", *kind, *options, *settings, project)
        (made,) = (path for path in Path(folder).iterdir() if path.suffix in (".whl", ".gz"))
        return Path(shutil.copy2(made, out))


def repaired(wheel: Path, out: Path) -> Path:
    """The wheel, with every shared library that systems may lack inside."""
    with tempfile.TemporaryDirectory() as folder:
        call(sys.executable, "-m", "auditwheel", "repair", "--wheel-dir", folder, wheel)
        (made,) = Path(folder).iterdir()
        licence.state(made)
        return Path(shutil.copy2(made, out))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", help="the interpreter that the wheel is for")
    parser.add_argument("--project", type=Path, default=ROOT, help="the folder of pyproject.toml")
    parser.add_argument("--out", type=Path, default=ROOT / "dist")
    parser.add_argument("--sdist", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    BUILD.mkdir(exist_ok=True)
    python = environment_for(options.python)
    project = options.project.resolve()
    if options.sdist:
        print(build(project, python, options.out, "--sdist"))
    else:
        with tempfile.TemporaryDirectory() as folder:
            print(repaired(build(project, python, Path(folder), "--wheel"), options.out))


if __name__ == "__main__":
    main()
