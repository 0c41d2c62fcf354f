"""How an adapter gets into its folder: a Python environment, a compiled program, a package.

A folder counts as installed if its stamp exists and matches the current requirements. The stamp is
written last; a folder without stamp, as after an interrupted installation, is made anew. One
process at a time works on a folder.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from minkref.errors import Refusal
from minkref.fuzz.libraries import other_languages

HERE = Path(__file__).parent
STAMP = "installed"
COMPILERS = ("c++", "g++", "clang++")
FLAGS = ("-std=c++20", "-O2", "-DNDEBUG")
PROTOCOL = HERE.parent / "adapters"
HEADERS = ("adapter_protocol.hpp", "integer_grid.hpp")
CLIPPER2 = "external/clipper2/CPP/Clipper2Lib"
CLIPPER2_UNITS = ("engine", "offset", "rectclip")
DEBIAN_NEEDS = "apt-get install -y g++ nlohmann-json3-dev libboost-dev"
SECONDS = 900.0  # for each command
SHOWN = 1500  # characters of a failed command's output


def interpreter(home: Path) -> Path:
    return home / "venv" / "bin" / "python"


def binary(home: Path) -> Path:
    return home / "adapter"


def state_of(home: Path, kind: str, program: str) -> str:
    """Returns an empty text if `home` is up to date, else `not installed` or `out of date`."""
    stamp = home / STAMP
    if kind in other_languages.LANGUAGES:
        there = (home / other_languages.LANGUAGES[kind].start).is_file()
    else:
        there = os.access(interpreter(home) if kind == "python" else binary(home), os.X_OK)
    if not (stamp.is_file() and there):
        return "not installed"
    return "" if stamp.read_text(encoding="utf-8") == _wanted(kind, program) else "out of date"


def install_home(home: Path, kind: str, program: str) -> None:
    """Makes `home` anew, unless up to date."""
    try:
        home.parent.mkdir(parents=True, exist_ok=True)
        with _alone(home.parent / f".{home.name}.lock"):
            if not state_of(home, kind, program):
                return
            shutil.rmtree(home, ignore_errors=True)
            home.mkdir()
            if kind == "python":
                _make_environment(home, program)
            elif kind in other_languages.LANGUAGES:
                other_languages.make(kind, home, HERE / program, PROTOCOL, _run)
            else:
                _compile(home, program)
            part = home / f"{STAMP}.part"
            part.write_text(_wanted(kind, program), encoding="utf-8")
            part.replace(home / STAMP)
    except OSError as error:
        mend = "choose a folder that can be written in MINKREF_ADAPTERS"
        raise Refusal(str(error), str(home), mend, "not-installed") from error


def missing_package(executable: str, package: str) -> str | None:
    """A sentence with the command that installs the package, None if the program exists."""
    if shutil.which(executable):
        return None
    return f"{executable} is not installed: {' '.join(_package_command(package))} (as root)"


def install_package(executable: str, package: str) -> None:
    """Installs a package by Debian's package manager, as root only."""
    if shutil.which(executable):
        return
    if os.geteuid() != 0 or not shutil.which("apt-get"):
        mend = f"{' '.join(_package_command(package))} (as root)"
        raise Refusal(f"{executable} is not installed", package, mend, "not-installed")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    _run(_package_command(package), "run apt-get update, then again", environment)


def _package_command(package: str) -> list[str]:
    return ["apt-get", "install", "-y", "--no-install-recommends", package]


def _requirements(program: str) -> Path:
    """The requirements file of a program, in its library's folder."""
    return (HERE / program).with_name("requirements.txt")


def _wanted(kind: str, program: str) -> str:
    """The digest that an installation depends on: of pinned requirements, and a compiled program's
    sources. A Python program runs from its own place."""
    paths = [_requirements(program)]
    words = [kind]
    if kind == "python":
        words.append(sys.version)
    elif kind in other_languages.LANGUAGES:
        paths = other_languages.sources(kind, HERE / program, PROTOCOL)
    else:
        paths += [HERE / program, *(PROTOCOL / name for name in HEADERS)]
        words += FLAGS
    texts = [path.read_bytes() for path in paths if path.is_file()]
    return hashlib.sha256(b"\0".join([" ".join(words).encode(), *texts])).hexdigest() + "\n"


@contextmanager
def _alone(lock: Path) -> Iterator[None]:
    """Waits until no other process runs the same section."""
    with lock.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _make_environment(home: Path, program: str) -> None:
    _make_empty_environment(home / "venv")
    package, at, number = home.name.partition("@")
    if at:
        lines = _requirements(program).with_suffix(".in").read_text(encoding="utf-8").split()
        others = [line for line in lines if line.partition("==")[0] != package]
        _pip(home / "venv", "install", "--only-binary", ":all:", f"{package}=={number}", *others)
        return
    requirements = str(_requirements(program))
    _pip(home / "venv", "install", "--require-hashes", "-r", requirements)


def _make_empty_environment(folder: Path) -> None:
    mend = "install the module venv (Debian: apt-get install python3-venv)"
    _run([sys.executable, "-m", "venv", str(folder)], mend)


def _pip(environment: Path, verb: str, *arguments: str, **variables: str) -> None:
    pip = [str(environment / "bin" / "python"), "-m", "pip", verb, "--no-input", "--quiet"]
    mend = "see what pip says; it needs a package index that it can reach"
    _run([*pip, "--disable-pip-version-check", *arguments], mend, {**os.environ, **variables})


def _compile(home: Path, program: str) -> None:
    given = os.environ.get("CXX")
    compiler = given or next((name for name in COMPILERS if shutil.which(name)), None)
    if compiler is None:
        raise Refusal("there is no C++ compiler", home.name, DEBIAN_NEEDS, "not-installed")
    words = [*compiler.split(), *FLAGS, f"-I{HERE.parents[1]}", str(HERE / program)]
    if home.name == "clipper2":
        library = _clipper2_sources(home, program)
        words.append(f"-I{library / 'include'}")
        words += [str(library / "src" / f"clipper.{unit}.cpp") for unit in CLIPPER2_UNITS]
    _run([*words, "-o", str(binary(home))], f"see what the compiler says; {DEBIAN_NEEDS}")


def _clipper2_sources(home: Path, program: str) -> Path:
    """Unpacks the library from the source distribution that its requirements name, with a
    digest."""
    environment, downloads = home / "venv", home / "download"
    _make_empty_environment(environment)
    requirements = str(_requirements(program))
    wanted = ["--require-hashes", "--no-deps", "--no-binary", "pyclipr", "--dest", str(downloads)]
    wanted += ["-r", requirements]
    # Without its hooks the package is not compiled to find metadata: only sources are wanted.
    _pip(environment, "download", *wanted, HATCH_BUILD_NO_HOOKS="true")
    (archive,) = downloads.glob("pyclipr-*.tar.gz")
    library = home / "source" / archive.name.removesuffix(".tar.gz") / CLIPPER2
    with tarfile.open(archive) as tar:
        for folder in ("include/clipper2", "src"):
            (library / folder).mkdir(parents=True)
            for member in tar.getmembers():
                path, _, name = member.name.rpartition("/")
                if path.endswith(f"/{CLIPPER2}/{folder}") and member.isfile():
                    content = tar.extractfile(member)
                    assert content is not None
                    (library / folder / name).write_bytes(content.read())
    shutil.rmtree(environment)
    shutil.rmtree(downloads)
    return library


def _run(words: list[str], mend: str, environment: dict[str, str] | None = None) -> None:
    """Runs a command. Raises Refusal with the end of its output if the command fails."""
    where = " ".join(words[:4])
    try:
        done = subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            timeout=SECONDS,
            check=False,
            env=environment,
        )
    except subprocess.TimeoutExpired as error:
        raise Refusal(f"no end in {SECONDS:g} s", where, mend, "not-installed") from error
    except FileNotFoundError as error:
        raise Refusal(f"{words[0]} was not found", where, mend, "not-installed") from error
    if done.returncode:
        what = f"exit code {done.returncode}: {done.stdout.strip()[-SHOWN:]}"
        raise Refusal(what, where, mend, "not-installed")
