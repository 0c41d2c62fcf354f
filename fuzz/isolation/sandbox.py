"""The command line of bubblewrap around a foreign program.

Own PID, network, IPC and UTS spaces; the whole system readable and nothing writable; no
capabilities and no new privileges; own folders for temporary files. Folders with sockets of the
system are hidden, as are places with secrets, and the run's own output.
"""

from __future__ import annotations

import functools
import os
import re
import resource
import shutil
import stat
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from minkref.fuzz.isolation.own_folders import adapters_folder

PROGRAM = "bwrap"
LIMITER = "prlimit"  # from util-linux
COUNTING_LINUX = (5, 14)  # first version that counts processes per user space
FOLDER, HOME = "/tmp", "/tmp/home"  # within
EMPTIED = ("/tmp", "/run")  # the program's own, empty at its start
DEVICES = ("null", "zero", "random", "urandom")  # fewer than bubblewrap's --dev: each costs a mount
SECRETS = (".ssh", ".gnupg", ".aws", ".azure", ".kube", ".docker", ".config/gcloud", ".config/gh")
SECRET_FILES = (".netrc", ".git-credentials", ".npmrc", ".pypirc")
SPACES = ("--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts")
MOST_FILES = 200  # shown one by one
TRY_SECONDS = 20.0
LIBRARY_VARIABLES = ("PATH", "LD_LIBRARY_PATH", "PYTHONPATH", "NODE_PATH", "CLASSPATH")


def sandboxed(
    command: list[str], environment: dict[str, str], hidden: Iterable[str], memory: int
) -> list[str]:
    """Returns the command within the sandbox. `hidden`: our files and folders to hide from it.
    `memory`: bytes for its temporary files, for each of three places."""
    words = [PROGRAM, *SPACES, "--die-with-parent", "--new-session", "--cap-drop", "ALL"]
    words += ["--ro-bind", "/", "/", "--proc", "/proc"]
    for folder in ("/dev", *filter(os.path.isdir, EMPTIED)):
        words += ["--size", str(memory), "--tmpfs", folder]
    for name in DEVICES:
        words += ["--dev-bind", f"/dev/{name}", f"/dev/{name}"]
    for name, place in (("fd", ""), ("stdin", "/0"), ("stdout", "/1"), ("stderr", "/2")):
        words += ["--symlink", f"/proc/self/fd{place}", f"/dev/{name}"]
    words += ["--dir", "/dev/shm", "--dir", HOME]
    here = os.getcwd()
    named = tuple(environment.get(name, "") for name in LIBRARY_VARIABLES)
    needed = readable(tuple(command), named, here)
    for path in _shown(needed):
        words += ["--ro-bind", path, path]
    words += _covered([*_secrets(), *hidden], keep=needed)
    return [*words, "--chdir", here, "--", *command]


@functools.lru_cache
def readable(command: tuple[str, ...], named: tuple[str, ...], here: str) -> tuple[Path, ...]:
    """Folders that the program needs: for each path in its command, for libraries that the
    environment names, ours, and the current folder, `here`."""
    found = [Path(here), Path(sys.prefix), Path(sys.base_prefix), *_ours()]
    for word in command:
        path = Path(shutil.which(word) or word) if word == command[0] else Path(word)
        if os.path.lexists(path):
            for each in (path.absolute(), path.resolve()):
                found.append(_home_of(each))
    paths = [os.path.join(here, path) for text in named for path in text.split(os.pathsep) if path]
    found += [
        _home_of(Path(each, "x")) for path in paths for each in (path, os.path.realpath(path))
    ]
    return tuple(dict.fromkeys(found))


def _ours() -> list[Path]:
    """This package with its link targets, and the folder for installed adapters."""
    import minkref

    here = Path(__file__).resolve()
    rooms = [here.parents[2], *(Path(place) for place in minkref.__path__), adapters_folder()]
    return [place.absolute() for place in rooms]


def _home_of(path: Path) -> Path:
    """A program's folder; for a program in bin/, as in a virtual environment, the folder above
    bin/."""
    if os.path.isdir(path):  # false also if we may not look
        return path
    return path.parent.parent if path.parent.name == "bin" else path.parent


def _shown(wanted: Iterable[Path]) -> list[str]:
    """Returns paths from `wanted` that lie in an emptied folder, but in no other path shown. For an
    emptied folder itself, returns its files."""
    found: set[str] = set()
    for folder in wanted:
        place = str(folder)
        if place in EMPTIED:
            files = (entry.path for entry in os.scandir(place) if entry.is_file())
            found.update(sorted(files)[:MOST_FILES])
        elif place.startswith(tuple(f"{one}/" for one in EMPTIED)) and os.path.exists(place):
            found.add(place)
    shown: list[str] = []
    for place in sorted(found):  # outer paths come before inner paths
        if not any(place.startswith(f"{outer}/") for outer in shown):
            shown.append(place)
    return shown


def _secrets() -> list[str]:
    home = Path.home()
    return [str(home / name) for name in (*SECRETS, *SECRET_FILES)]


def _covered(paths: Iterable[str], keep: Iterable[Path]) -> list[str]:
    """Words that cover existing `paths`, except folders that hold something needed."""
    kept = [str(path) for path in keep]
    words: list[str] = []
    for path in sorted({os.path.realpath(path) for path in paths}):
        if os.path.isfile(path):
            words += ["--ro-bind", "/dev/null", path]
        elif os.path.isdir(path) and not any(f"{one}/".startswith(f"{path}/") for one in kept):
            words += ["--size", "65536", "--tmpfs", path]
    return words


@functools.cache
def has_own_user_space() -> bool:
    """Whether a sandboxed program's processes are counted apart from its user's other processes: in
    an own user space, which bubblewrap makes unless it has root's rights."""
    path, limiter = shutil.which(PROGRAM), shutil.which(LIMITER)
    if path is None or limiter is None or os.geteuid() == 0 or os.stat(path).st_mode & stat.S_ISUID:
        return False
    release = re.match(r"(\d+)\.(\d+)", os.uname().release)
    return release is not None and tuple(map(int, release.groups())) >= COUNTING_LINUX


def with_fewer_processes(command: list[str], most: int) -> list[str]:
    """Returns the command, limited to so many processes in the sandbox, apart from the first."""
    _, hard = resource.getrlimit(resource.RLIMIT_NPROC)
    most = most + 1 if hard == resource.RLIM_INFINITY else min(most + 1, hard)
    return [LIMITER, f"--nproc={most}", "--", *command]


@functools.cache
def absence() -> str | None:
    """Says why no sandbox works here; None if a test sandbox ran."""
    if sys.platform != "linux":
        return "bubblewrap runs on Linux only"
    if shutil.which(PROGRAM) is None:
        return "bubblewrap is not installed (Debian: apt-get install bubblewrap)"
    words = sandboxed(["true"], dict(os.environ), (), 1 << 20)
    try:
        done = subprocess.run(
            words,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=TRY_SECONDS,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"bubblewrap does not work here: {error}"
    if done.returncode:
        return f"bubblewrap does not work here: {done.stderr.strip()[-200:]}"
    return None


@functools.cache
def sandbox_version() -> str:
    """Returns the version, as `bubblewrap 0.8.0`."""
    done = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=False)
    return done.stdout.strip() or PROGRAM
