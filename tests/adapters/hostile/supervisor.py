"""`python supervisor.py OUT SECONDS [tty] [memory] -- COMMAND...`: runs a command, tells what it
left.

The kernel gives all orphans below the supervisor to it, so that no process escapes by forking.
Processes alive two seconds after the command's end were left behind; the supervisor ends them
before itself. With `tty` the command has a separate terminal; with `memory` each process may have
six gigabytes at most.
"""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import json
import os
import pty
import resource
import signal
import subprocess
import sys
import termios
import threading
import time
from pathlib import Path
from typing import Any

SET_SUBREAPER = 36
MOST_MEMORY = 6 << 30
PATIENCE = 2.0  # seconds in which what was sent SIGKILL may still end


def children() -> list[int]:
    """The children that the kernel lists for this process."""
    found = Path(f"/proc/self/task/{os.getpid()}/children")
    return [int(word) for word in found.read_text().split()]


def descendants() -> list[int]:
    found, open_ = [], children()
    while open_:
        pid = open_.pop()
        found.append(pid)
        with contextlib.suppress(OSError):
            for task in Path(f"/proc/{pid}/task").iterdir():
                open_ += [int(word) for word in (task / "children").read_text().split()]
    return found


def alive(pid: int) -> bool:
    try:
        status = Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return False
    return status.rpartition(")")[2].split()[0] != "Z"


def reap() -> None:
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass


def left_behind() -> list[str]:
    """Processes alive after some patience, each with its command."""
    end = time.monotonic() + PATIENCE
    while True:
        reap()
        found = [pid for pid in descendants() if alive(pid)]
        if not found or time.monotonic() > end:
            break
        time.sleep(0.02)
    shown = []
    for pid in found:
        with contextlib.suppress(OSError):
            words = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ")
            name = Path(f"/proc/{pid}/comm").read_text().strip()
            shown.append(f"{pid} {name}: {words[-200:].decode(errors='replace')}")
    return shown


def end_all() -> None:
    while found := descendants():
        for pid in found:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        reap()
        time.sleep(0.01)


def begin(terminal: int, bounded: bool) -> None:
    os.setsid()
    if terminal >= 0:
        fcntl.ioctl(terminal, termios.TIOCSCTTY, 0)
    if bounded:
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main() -> None:
    out, seconds = Path(sys.argv[1]), float(sys.argv[2])
    at = sys.argv.index("--")
    ctypes.CDLL(None).prctl(SET_SUBREAPER, 1, 0, 0, 0)
    terminal: tuple[int, int] | None = pty.openpty() if "tty" in sys.argv[3:at] else None
    before = termios.tcgetattr(terminal[1]) if terminal else None
    seen = bytearray()
    if terminal:
        threading.Thread(target=watch, args=(terminal[0], seen), daemon=True).start()
    slave = terminal[1] if terminal else -1
    began = time.monotonic()
    with open(f"{out}.stdout", "wb") as stdout, open(f"{out}.stderr", "wb") as stderr:
        process = subprocess.Popen(
            sys.argv[at + 1 :],
            stdin=slave if terminal else subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            preexec_fn=lambda: begin(slave, "memory" in sys.argv[3:at]),
        )
        code, used = waited(process.pid, began + seconds)
    told: dict[str, Any] = {
        "code": code,
        "seconds": time.monotonic() - began,
        "cpu_seconds": used.ru_utime + used.ru_stime if used else seconds,
        "peak_bytes": used.ru_maxrss * 1024 if used else 0,
        "left": left_behind(),
    }
    end_all()
    if terminal:
        told["terminal_changed"] = termios.tcgetattr(slave) != before
        told["typed"] = waiting(slave)
        told["shown"] = bytes(seen).decode(errors="replace")
    out.write_text(json.dumps(told))


def waited(pid: int, end: float) -> tuple[int | None, resource.struct_rusage | None]:
    """The child's exit code, or minus its signal, and its resource usage; None for a child that did
    not end in time."""
    while time.monotonic() < end:
        done, status, usage = os.wait4(pid, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status), usage
        time.sleep(0.01)
    return None, None


def watch(master: int, seen: bytearray) -> None:
    with contextlib.suppress(OSError):
        while data := os.read(master, 4096):
            seen += data


def waiting(slave: int) -> bool:
    """Whether anything was typed into the terminal that nobody has read."""
    mode = termios.tcgetattr(slave)
    mode[3] &= ~termios.ICANON
    termios.tcsetattr(slave, termios.TCSANOW, mode)
    count = bytearray(4)
    fcntl.ioctl(slave, termios.FIONREAD, count)
    return int.from_bytes(count, sys.byteorder) > 0


if __name__ == "__main__":
    main()
