"""`isolated_adapter.py WHAT [ARGUMENT]`: an adapter that tries WHAT at `hello`, and tells the
outcome as its version. Everything else is right."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "bad_adapters"))
from adapter import Adapter, Set

FOREVER = 600


def child(seconds: float = FOREVER) -> None:
    """A grandchild in a separate session, without our pipes."""
    if os.fork() == 0:
        os.setsid()
        if os.fork():
            os._exit(0)
        for number in (0, 1, 2):
            os.dup2(os.open(os.devnull, os.O_RDWR), number)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(seconds)
        os._exit(0)


def environment(_: str) -> str:
    return " ".join(sorted(os.environ))


def variable(name: str) -> str:
    return os.environ.get(name, "")


def network(port: str) -> str:
    with socket.create_connection(("127.0.0.1", int(port)), timeout=5):
        return "reached"


def unix_socket(path: str) -> str:
    with socket.socket(socket.AF_UNIX) as one:
        one.connect(path.removeprefix("at:"))  # what is named as a path it may see
        return "reached"


def write(path: str) -> str:
    Path(path).write_text("written by an adapter", encoding="utf-8")
    return "written"


def read(path: str) -> str:
    return f"read {len(Path(path.removeprefix('at:')).read_bytes())} bytes"


def own_folders(_: str) -> str:
    for name in ("HOME", "TMPDIR"):
        (Path(os.environ[name]) / "mine").write_text("x", encoding="utf-8")
    return os.environ["TMPDIR"]


def forty(_: str) -> str:
    """Starts forty processes by double forks, then kills the parent that would end them."""
    for _ in range(40):
        child()
    os.kill(os.getppid(), signal.SIGKILL)
    return "killed"


def see_processes(_: str) -> str:
    return " ".join(name for name in os.listdir("/proc") if name.isdecimal())


def tree(megabytes: str) -> str:
    """Four children that take a fourth each, and stay."""
    for _ in range(4):
        if os.fork() == 0:
            held = b"x" * (int(megabytes) << 18)
            time.sleep(FOREVER)
            os._exit(len(held) & 1)
    time.sleep(5)
    return "taken"


def privileges(_: str) -> str:
    lines = Path("/proc/self/status").read_text().splitlines()
    found = dict(line.split(":\t", 1) for line in lines if ":\t" in line)
    mounts = subprocess.run(["mount", "-o", "remount,rw", "/"], capture_output=True, check=False)
    return f"{found['CapEff']} {found['NoNewPrivs']} {mounts.returncode}"


def bomb(most: str) -> str:
    """At most so many children, none of which forks; how many began, and whether one could not."""
    for count in range(int(most)):
        try:
            child = os.fork()
        except BlockingIOError:
            return f"{count} True"
        if child == 0:
            time.sleep(FOREVER)
            os._exit(0)
    return f"{most} False"


def bomb_and_fail(most: str) -> str:
    sys.exit(bomb(most))


TRIES = {
    one.__name__.replace("_", "-"): one
    for one in (environment, variable, network, unix_socket, write, read, own_folders, forty)
}
TRIES |= {"bomb": bomb, "bomb-and-fail": bomb_and_fail}
TRIES |= {"see-processes": see_processes, "tree": tree, "privileges": privileges}


class Isolated(Adapter):
    def hello(self) -> Set:
        argument = sys.argv[2] if len(sys.argv) > 2 else ""
        try:
            said = TRIES[sys.argv[1]](argument)
        except OSError as error:
            said = f"not: {error.strerror or error}"
        return {**super().hello(), "version": said}


if __name__ == "__main__":
    Isolated().serve()
