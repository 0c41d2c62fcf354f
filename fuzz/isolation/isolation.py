"""The walls that a run has around foreign programs, chosen once and announced."""

from __future__ import annotations

import functools
import os
import secrets
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, choice
from minkref.fuzz.isolation import control_group, leftovers, other_user, sandbox
from minkref.fuzz.isolation.own_folders import state_folder

AUTO, SANDBOX, NONE = "auto", "sandbox", "none"
KINDS = (AUTO, SANDBOX, NONE)
OF_A_USER, OF_A_SPACE = "limit of its user", "limit of its user space"


@dataclass(frozen=True)
class Isolation:
    """`kind` is `sandbox` or `none`; `why` says why no sandbox exists. `passed`: variables handed
    on in addition to the list. `hidden`: the run's files and folders. `rooms`: places for control
    groups, without which memory is measured. `own_user`: as root without a sandbox. `mark`
    identifies processes that this run starts."""

    kind: str
    why: str = ""
    passed: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()
    rooms: tuple[control_group.Room, ...] = ()
    own_user: bool = False
    mark: str = field(default_factory=lambda: secrets.token_hex(8), compare=False)

    @property
    def memory(self) -> str:
        """How the memory limit of a whole process tree is enforced."""
        return self._group_of(control_group.MEMORY) or "measured"

    @property
    def processes(self) -> str:
        """How their number is."""
        group = self._group_of(control_group.PIDS)
        if group is None and self.own_user:
            return OF_A_USER
        if group is None and self.kind == SANDBOX and sandbox.has_own_user_space():
            return OF_A_SPACE
        return group or "not held"

    def _group_of(self, controller: str) -> str | None:
        found = (room for room in self.rooms if controller in room.controllers)
        return next((f"control group of version {room.version}" for room in found), None)

    def clear(self) -> None:
        """Ends and removes remnants of programs whose worker was killed."""
        if self.kind == NONE and sys.platform == "linux":
            leftovers.end_marked(self.mark)
        for room in self.rooms:
            control_group.remove_stale(room)

    def document(self) -> dict[str, Any]:
        return {
            "kind": self.kind,
            "tool": sandbox.sandbox_version() if self.kind == SANDBOX else None,
            "why_none": self.why or None,
            "memory": self.memory,
            "processes": self.processes,
            "own_user": self.own_user,
            "passed": list(self.passed),
        }

    def sentence(self) -> str:
        """For people."""
        passed = f"; variables passed: {', '.join(self.passed)}" if self.passed else ""
        if self.kind == SANDBOX:
            how = f"sandbox ({sandbox.sandbox_version()}), without network"
        else:
            user = "as a user of its own" if self.own_user else "with all rights of ours"
            how = f"NONE: {self.why}. Each program runs {user}, with network"
        held = f"memory of all its processes: {self.memory}; their number: {self.processes}"
        return f"isolation: {how}; {held}{passed}"


def choose(
    wanted: str = AUTO, passed: tuple[str, ...] = (), hidden: tuple[str | Path, ...] = ()
) -> Isolation:
    """Returns the available walls. Refuses unknown kinds, and `sandbox` if unavailable."""
    if wanted not in KINDS:
        what = f"there is no isolation {wanted[:40]!r}"
        raise Refusal(what, "--isolation", choice(wanted, KINDS))
    for name in passed:
        if not name or "=" in name or "\0" in name:
            raise Refusal(
                "this is not the name of a variable", f"--pass-env {name[:40]!r}", "give its name"
            )
    why = sandbox.absence() if wanted != NONE else "asked for by --isolation none"
    if why is not None and wanted == SANDBOX:
        raise Refusal(f"there is no sandbox: {why}", "--isolation sandbox", "give auto or none")
    kind = SANDBOX if why is None else NONE
    places = tuple(os.path.abspath(path) for path in (state_folder(), *hidden))
    own_user = kind == NONE and _can_change_user()
    return Isolation(kind, why or "", passed, places, control_group.find_rooms(), own_user)


@functools.cache
def usual() -> Isolation:
    """The isolation for a run that makes no choice."""
    return choose()


@functools.cache
def _can_change_user() -> bool:
    return other_user.can_change()
