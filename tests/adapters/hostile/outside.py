"""Things outside of a run, before and after it: files, sockets, shared memory, mounts."""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import subprocess
from pathlib import Path

MARK = "minkref-hostile"
CHECKOUT = Path(__file__).resolve().parents[3]
# Places where a hostile adapter could write a marker.
PLACES = [CHECKOUT, *map(Path, ("/etc", "/usr/local/bin", "/var/tmp", "/", "/tmp", "/dev/shm"))]
PLACES += [Path("/run"), Path("/dev/mqueue")]


def ipc_key(run: str) -> int:
    """The key of the shared memory that a run's adapters take."""
    return int(run[:7], 16)


def listing(folder: Path) -> dict[str, str]:
    """Kind, mode and content of all files below a folder; follows no links."""
    found = {}
    for path in sorted(folder.rglob("*")):
        status = path.lstat()
        what = oct(status.st_mode)
        if path.is_symlink():
            what += f" to {path.readlink()}"
        elif path.is_file():
            what += " " + hashlib.sha256(path.read_bytes()).hexdigest()
        found[str(path.relative_to(folder))] = what
    return found


def markers(run: str) -> list[str]:
    """Files in system folders with the hostile adapters' mark and this run's name."""
    found = []
    for place in PLACES:
        with contextlib.suppress(OSError):
            found += [str(path) for path in place.glob(f"*{MARK}*{run}*")]
    return sorted(found)


def sockets(run: str, port: int) -> list[str]:
    """Sockets that listen on the port or have a name of this run."""
    found = []
    for table in ("tcp", "tcp6"):
        for line in Path("/proc/net", table).read_text().splitlines()[1:]:
            words = line.split()
            if words[3] == "0A" and int(words[1].rpartition(":")[2], 16) == port:
                found.append(f"{table} {port}")
    names = Path("/proc/net/unix").read_text().splitlines()
    return found + [line.split()[-1] for line in names if f"{MARK}-listens-{run}" in line]


def shared(run: str) -> list[str]:
    """Shared memory, semaphores and queues under the run's key."""
    found = []
    for kind in ("shm", "sem", "msg"):
        for line in Path("/proc/sysvipc", kind).read_text().splitlines()[1:]:
            key, number = line.split()[:2]
            if int(key) == ipc_key(run):
                found.append(f"{kind} {number}")
    return found


def mounts() -> list[str]:
    return [line for line in Path("/proc/mounts").read_text().splitlines() if MARK in line]


def left(run: str, port: int) -> list[str]:
    """All existing traces of the run."""
    return [*markers(run), *sockets(run, port), *shared(run), *mounts()]


def remove(run: str) -> None:
    """Removes the traces found, so that the next run begins like this one."""
    for name in markers(run):
        path = Path(name)
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink()
    for what in shared(run):
        kind, number = what.split()
        option = {"shm": "-m", "sem": "-s", "msg": "-q"}[kind]
        subprocess.run(["ipcrm", option, number], check=False, capture_output=True)


def remove_folder(folder: Path) -> None:
    """Removes a folder, even if it holds closed folders or exceeds the length of a path."""
    for path, names, _ in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):
                if not Path(path, name).is_symlink():
                    Path(path, name).chmod(0o700)
    subprocess.run(["rm", "-rf", "--one-file-system", str(folder)], check=False)
