"""A foreign program, started within its walls, and ended with all its descendants."""

from __future__ import annotations

import os
import resource
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress

from minkref.fuzz.isolation import sandbox, supervisor
from minkref.fuzz.isolation.control_group import MEMORY, PIDS, ControlGroup
from minkref.fuzz.isolation.environment import environment_of
from minkref.fuzz.isolation.isolation import OF_A_SPACE, OF_A_USER, SANDBOX, Isolation
from minkref.fuzz.isolation.leftovers import end_marked
from minkref.fuzz.isolation.other_user import a_user, become, forbid_new_privileges
from minkref.fuzz.isolation.process_tree import children_of, resident_bytes, tree_bytes

END_SECONDS = 5.0
WATCH_SECONDS = 0.2  # between two measurements of memory
SANDBOX_PROCESSES = 2  # bubblewrap's own
SHELL_SIGNAL = 128  # bubblewrap's exit code is this plus the signal that killed the program


class SupervisedProgram:
    """Runs from construction until `end`. Standard streams are pipes. Raises OSError or
    SubprocessError if the program cannot start."""

    def __init__(
        self,
        command: list[str],
        memory: int,
        processes: int,
        isolation: Isolation,
        more: dict[str, str],
    ) -> None:
        self._isolation, self._memory, self._processes = isolation, memory, processes
        self._mark = f"{isolation.mark}-{secrets.token_hex(4)}"
        self._folder = ""
        self._groups: list[ControlGroup] = []
        self._looked = time.monotonic()
        try:
            within = processes + SANDBOX_PROCESSES * (isolation.kind == SANDBOX)
            for room in isolation.rooms:
                self._groups.append(ControlGroup(room, memory, within))
            self.process = self._started(command, more)
        except BaseException:
            self._clear()
            raise

    def exit_of(self, code: int) -> tuple[int, str | None]:
        """Returns the exit code and the fatal signal's name."""
        if self._isolation.kind == SANDBOX and code > SHELL_SIGNAL:
            code = SHELL_SIGNAL - code
        if code >= 0:
            return code, None
        try:
            return code, signal.Signals(-code).name
        except ValueError:
            return code, f"signal {-code}"

    def exceeded(self) -> bool:
        """Whether the program, with its descendants, took more memory than allowed. Measurements,
        if needed, happen a few times a second."""
        if any(MEMORY in group.room.controllers for group in self._groups):
            return self._reached(MEMORY)
        if time.monotonic() - self._looked < WATCH_SECONDS:
            return False
        self._looked = time.monotonic()
        root = self.process.pid
        return resident_bytes(root) > self._memory and tree_bytes(root) > self._memory

    def crowded(self) -> bool:
        """Whether the program wanted more processes than allowed, if they are counted."""
        return self._reached(PIDS)

    def _reached(self, controller: str) -> bool:
        return any(group.reached(controller) > 0 for group in self._groups)

    def end(self) -> None:
        """Ends the program with its descendants, and removes files in its own folder."""
        if self._isolation.kind == SANDBOX:
            self._end_sandbox()
        else:
            supervisor.end(self.process)
            if sys.platform == "linux":
                end_marked(self._mark)
        self._clear()

    def _started(self, command: list[str], more: dict[str, str]) -> subprocess.Popen[bytes]:
        passed, hidden = self._isolation.passed, self._isolation.hidden
        if self._isolation.kind == SANDBOX:
            folder, home = sandbox.FOLDER, sandbox.HOME
            environment = environment_of(passed, more, folder, home, self._mark)
            if self._isolation.processes == OF_A_SPACE:
                command = sandbox.with_fewer_processes(command, self._processes)
            command = sandbox.sandboxed(command, environment, hidden, self._memory)
            setting: Callable[[], None] = self._set
        else:
            self._folder = tempfile.mkdtemp(prefix="minkref-")
            user = a_user() if self._isolation.own_user else None
            if user is not None:
                os.chown(self._folder, user, user)
            environment = environment_of(passed, more, self._folder, self._folder, self._mark)
            setting = _kept_setting(os.getpid(), self._folder, user, self._set)
        return subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            bufsize=0,
            env=environment,
            preexec_fn=setting,
        )

    def _set(self) -> None:
        """In the new process."""
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        for group in self._groups:
            group.join()
        _lower(resource.RLIMIT_AS, self._memory)
        if self._isolation.processes == OF_A_USER:
            _lower(resource.RLIMIT_NPROC, self._processes)
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    def _end_sandbox(self) -> None:
        """Kills the first process within, and all others with it; then bubblewrap ends."""
        deadline = time.monotonic() + END_SECONDS
        while self.process.poll() is None and time.monotonic() < deadline:
            for first in children_of(self.process.pid):
                with suppress(ProcessLookupError):
                    os.kill(first, signal.SIGKILL)
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(0.05)
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()

    def _clear(self) -> None:
        while self._groups:
            self._groups.pop().remove()
        if self._folder:
            shutil.rmtree(self._folder, ignore_errors=True)


def _lower(what: int, most: int) -> None:
    """Lowers a limit of this process."""
    _, hard = resource.getrlimit(what)
    if hard == resource.RLIM_INFINITY or most < hard:
        resource.setrlimit(what, (most, most))


def _kept_setting(
    parent: int, folder: str, user: int | None, setting: Callable[[], None]
) -> Callable[[], None]:
    def begin() -> None:
        setting()
        if user is not None:
            become(user)
        forbid_new_privileges()

    return lambda: supervisor.supervise(parent, folder, begin)
