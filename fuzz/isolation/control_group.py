"""A control group of Linux that holds the memory of a program and of all that it starts to a limit.

Both versions, where we may make a group: of version 1 below our own, of version 2 below the next
that hands the controller on. A group that a process of ours left behind when it was killed is
removed by the next.
"""

from __future__ import annotations

import functools
import itertools
import os
import time
from dataclasses import dataclass
from pathlib import Path

_LIMITS = {1: "memory.limit_in_bytes", 2: "memory.max"}
_SWAP = {1: ("memory.memsw.limit_in_bytes", None), 2: ("memory.swap.max", 0)}
_EVENTS = {1: "memory.oom_control", 2: "memory.events"}
_NAME = "minkref"
REMOVE_SECONDS = 2.0
_numbers = itertools.count()


@dataclass(frozen=True)
class Room:
    """Where groups can be made."""

    version: int
    folder: Path


@dataclass
class ControlGroup:
    """For one program. Its limit counts files in memory (tmpfs) too."""

    room: Room
    limit: int

    def __post_init__(self) -> None:
        name = f"{_NAME}-{os.getpid()}-{next(_numbers)}"
        self.path = self.room.folder / name
        self.path.mkdir()
        swap, most = _SWAP[self.room.version]
        (self.path / _LIMITS[self.room.version]).write_text(str(self.limit))
        if (self.path / swap).exists():
            (self.path / swap).write_text(str(self.limit if most is None else most))
        self._events = os.open(self.path / _EVENTS[self.room.version], os.O_RDONLY | os.O_CLOEXEC)

    def join(self) -> None:
        """Puts the process that calls this into the group, with all that it starts from now on."""
        (self.path / "cgroup.procs").write_text(str(os.getpid()))

    def kills(self) -> int:
        """How many processes were ended because the limit was reached."""
        words = os.pread(self._events, 4096, 0).split()
        return int(words[words.index(b"oom_kill") + 1]) if b"oom_kill" in words else 0

    def remove(self) -> None:
        """After all its processes have ended."""
        os.close(self._events)
        deadline = time.monotonic() + REMOVE_SECONDS
        while True:
            try:
                self.path.rmdir()
                return
            except FileNotFoundError:
                return
            except OSError:  # the last process is not quite gone
                if time.monotonic() > deadline:
                    return
                time.sleep(0.001)


@functools.cache
def find_room() -> Room | None:
    """Where a group can be made and joined; tried out."""
    for room in _rooms():
        try:
            remove_stale(room)
            group = ControlGroup(room, 1 << 30)
        except OSError:
            continue
        try:
            if _can_join(group):
                return room
        finally:
            group.remove()
    return None


def _can_join(group: ControlGroup) -> bool:
    child = os.fork()
    if child == 0:
        try:
            group.join()
            os._exit(0)
        finally:
            os._exit(1)
    return os.waitpid(child, 0)[1] == 0


def _rooms() -> list[Room]:
    """Where groups may be made, the likeliest first."""
    found = []
    try:
        lines = Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except OSError:
        return []
    for line in lines:
        _, controllers, path = line.split(":", 2)
        version = 1 if "memory" in controllers.split(",") else 2 if not controllers else None
        folder = _folder(version, path) if version else None
        if version == 1 and folder is not None:
            found.append(Room(1, folder))
        elif version == 2 and folder is not None:
            found += [Room(2, one) for one in (folder, folder.parent) if _hands_on(one)]
    return found


def _hands_on(folder: Path) -> bool:
    try:
        return "memory" in (folder / "cgroup.subtree_control").read_text().split()
    except OSError:
        return False


def _folder(version: int, path: str) -> Path | None:
    """Of the group `path`, below the place where its file system is mounted."""
    for line in Path("/proc/self/mountinfo").read_text(encoding="utf-8").splitlines():
        before, _, after = line.partition(" - ")
        kind, _, options = after.split(" ", 2)
        root, place = before.split(" ")[3:5]
        right = kind == "cgroup2" if version == 2 else kind == "cgroup" and "memory" in options
        if right and (path == root or path.startswith(root.rstrip("/") + "/")):
            return Path(place, os.path.relpath(path, root))
    return None


def remove_stale(room: Room) -> None:
    """Removes the empty groups of processes that are no more."""
    for folder in room.folder.glob(f"{_NAME}-*-*"):
        owner = folder.name.split("-")[1]
        if owner.isdecimal() and not Path("/proc", owner).exists():
            try:
                folder.rmdir()
            except OSError:
                continue
