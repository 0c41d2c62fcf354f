"""A Linux control group that limits the memory and processes of a program and its descendants.

Both versions, if we may make a group: for version 1 below our own group, in each controller's own
place; for version 2 below the next group that hands the controllers on. The next process removes a
group left behind by a killed process of ours.
"""

from __future__ import annotations

import functools
import itertools
import os
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

MEMORY, PIDS = "memory", "pids"  # controllers
_LIMITS = {(MEMORY, 1): "memory.limit_in_bytes", (MEMORY, 2): "memory.max"}
_LIMITS |= {(PIDS, 1): "pids.max", (PIDS, 2): "pids.max"}
_SWAP = {1: ("memory.memsw.limit_in_bytes", None), 2: ("memory.swap.max", 0)}
_EVENTS = {(MEMORY, 1): "memory.oom_control", (MEMORY, 2): "memory.events"}
_EVENTS |= {(PIDS, 1): "pids.events", (PIDS, 2): "pids.events"}
_COUNTED = {MEMORY: b"oom_kill", PIDS: b"max"}
_NAME = "minkref"
REMOVE_SECONDS = 2.0
_numbers = itertools.count()


@dataclass(frozen=True)
class Room:
    """A place for groups, and the resources that they limit."""

    version: int
    folder: Path
    controllers: tuple[str, ...]


@dataclass
class ControlGroup:
    """A group for one program. `memory`: bytes, including files in memory (tmpfs). `processes`:
    including threads."""

    room: Room
    memory: int
    processes: int
    _events: dict[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        name = f"{_NAME}-{os.getpid()}-{next(_numbers)}"
        self.path = self.room.folder / name
        self.path.mkdir()
        version = self.room.version
        swap, most = _SWAP[version]
        for controller in self.room.controllers:
            limit = self.memory if controller == MEMORY else self.processes
            (self.path / _LIMITS[controller, version]).write_text(str(limit))
            if controller == MEMORY and (self.path / swap).exists():
                (self.path / swap).write_text(str(limit if most is None else most))
            events = self.path / _EVENTS[controller, version]
            if events.exists():
                self._events[controller] = os.open(events, os.O_RDONLY | os.O_CLOEXEC)

    def join(self) -> None:
        """Puts the calling process into the group, and processes that it starts from now on."""
        (self.path / "cgroup.procs").write_text(str(os.getpid()))

    def reached(self, controller: str) -> int:
        """How often its limit stood in the way: processes ended for memory, or not begun."""
        if controller not in self._events:
            return 0
        words = os.pread(self._events[controller], 4096, 0).split()
        counted = _COUNTED[controller]
        return int(words[words.index(counted) + 1]) if counted in words else 0

    def remove(self) -> None:
        """After all its processes have ended."""
        while self._events:
            os.close(self._events.popitem()[1])
        _remove(self.path, time.monotonic() + REMOVE_SECONDS)


@functools.cache
def find_rooms() -> tuple[Room, ...]:
    """Where groups can be made and joined, tried out; at most one for each controller."""
    found: list[Room] = []
    for room in _rooms():
        held = {controller for one in found for controller in one.controllers}
        left = tuple(controller for controller in room.controllers if controller not in held)
        second = room.version == 2 and any(one.version == 2 for one in found)
        if left and not second and _is_usable(replace(room, controllers=left)):
            found.append(replace(room, controllers=left))
    return tuple(found)


def _is_usable(room: Room) -> bool:
    try:
        remove_stale(room)
        group = ControlGroup(room, 1 << 30, 1 << 10)
    except OSError:
        return False
    try:
        return _can_join(group)
    finally:
        group.remove()


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
    """Places where groups may be made, the likeliest first. A process has only one version 2
    group."""
    first, second = [], []
    try:
        lines = Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except OSError:
        return []
    for line in lines:
        _, listed, path = line.split(":", 2)
        held = tuple(each for each in (MEMORY, PIDS) if each in listed.split(","))
        folder = _folder(held, path) if held or not listed else None
        if folder is not None and held:
            first.append(Room(1, folder, held))
        elif folder is not None:
            second += [Room(2, one, _handed_on(one)) for one in (folder, folder.parent)]
    return [*first, *sorted(second, key=lambda room: -len(room.controllers))]


def _handed_on(folder: Path) -> tuple[str, ...]:
    try:
        words = (folder / "cgroup.subtree_control").read_text().split()
    except OSError:
        return ()
    return tuple(each for each in (MEMORY, PIDS) if each in words)


def _folder(held: tuple[str, ...], path: str) -> Path | None:
    """Returns the folder of the group `path`, below its file system's mount point (version 1: the
    file system of the controllers `held`)."""
    for line in Path("/proc/self/mountinfo").read_text(encoding="utf-8").splitlines():
        before, _, after = line.partition(" - ")
        kind, _, options = after.split(" ", 2)
        root, place = before.split(" ")[3:5]
        right = kind == "cgroup" and held[0] in options.split(",") if held else kind == "cgroup2"
        if right and (path == root or path.startswith(root.rstrip("/") + "/")):
            return Path(place, os.path.relpath(path, root))
    return None


def remove_stale(room: Room) -> None:
    """Removes groups of vanished processes, once the groups' own processes have ended too."""
    deadline = time.monotonic() + REMOVE_SECONDS
    for folder in room.folder.glob(f"{_NAME}-*-*"):
        owner = folder.name.split("-")[1]
        if owner.isdecimal() and not _runs(owner):
            _remove(folder, deadline)


def _runs(process: str) -> bool:
    """Whether the process has not ended; an ended process stays listed until its parent waits for
    it."""
    try:
        status = Path("/proc", process, "stat").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return False
    return status.rpartition(")")[2].split()[0] not in "ZX"


def _remove(group: Path, deadline: float) -> None:
    """Removes the group, unless it still has processes at the deadline."""
    while True:
        try:
            group.rmdir()
            return
        except FileNotFoundError:
            return
        except OSError:  # the last process is not quite gone
            if time.monotonic() > deadline:
                return
            time.sleep(0.001)
