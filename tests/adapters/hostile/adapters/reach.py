"""Things outside an adapter: environment, network, parents, the terminal. The adapter's version
names the things that it reached, in words that begin with `got`."""

from __future__ import annotations

import ctypes
import fcntl
import os
import resource
import socket
import termios
from collections.abc import Callable, Iterable
from pathlib import Path

from bounds import of_this_run
from honest import Adapter, Request

LIBC = ctypes.CDLL(None, use_errno=True)
ATTACH, DETACH, SEIZE = 16, 17, 0x4206
LOOPBACK = "127.0.0.1"


def got(tries: Iterable[tuple[str, Callable[[], object]]]) -> str:
    """The names of tries that worked."""
    worked = []
    for name, attempt in tries:
        try:
            if attempt():
                worked.append(name)
        except (OSError, ValueError):
            continue
    return " ".join(f"got:{name}" for name in worked)


class ReadsTheEnvironment(Adapter):
    """Looks for a secret in the environments of itself and its parents."""

    def mischief(self, request: Request) -> str:
        secret = self.told["secret"][::-1].encode()  # told backwards: not to find itself
        parents = [
            (f"environment-{'own' if pid == os.getpid() else 'other'}", pid)
            for pid in [os.getpid(), *of_this_run(self.run)]
        ]
        return got(
            (name, lambda pid=pid: secret in Path(f"/proc/{pid}/environ").read_bytes())
            for name, pid in parents
        )


class ReachesTheNetwork(Adapter):
    """Reaches a server on the loopback address by every protocol."""

    def mischief(self, request: Request) -> str:
        port = int(self.told["port"])

        def tcp() -> bool:
            with socket.create_connection((LOOPBACK, port), timeout=2) as stream:
                stream.sendall(b"minkref-hostile")
            return True

        def udp() -> bool:
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stream:
                stream.connect((LOOPBACK, port))
                stream.send(b"minkref-hostile")
                stream.settimeout(1)
                return bool(stream.recv(8))

        def abstract() -> bool:
            with socket.socket(socket.AF_UNIX) as stream:
                stream.connect(f"\0minkref-hostile-{self.run}")
            return True

        def netlink() -> bool:
            names = [name for _, name in socket.if_nameindex() if name != "lo"]
            return bool(names)

        return got([("tcp", tcp), ("udp", udp), ("unix", abstract), ("interfaces", netlink)])


class Listens(Adapter):
    """Waits for connections on a port and under an abstract name, and stays there."""

    def mischief(self, request: Request) -> None:
        self.streams = [socket.socket(), socket.socket(socket.AF_UNIX)]
        for stream, address in zip(
            self.streams,
            ((LOOPBACK, int(self.told["free"])), f"\0minkref-hostile-listens-{self.run}"),
            strict=True,
        ):
            try:
                stream.bind(address)
                stream.listen()
            except OSError:
                continue


class TracesItsParents(Adapter):
    """Attaches to every process of the run as a debugger does, and lets go."""

    def mischief(self, request: Request) -> str:
        def seize(pid: int) -> bool:
            if LIBC.ptrace(SEIZE, pid, None, None) != 0:
                return False
            LIBC.ptrace(0x4207, pid, None, None)  # interrupt, to detach
            os.waitpid(pid, 0x40000000)
            LIBC.ptrace(DETACH, pid, None, None)
            return True

        def memory(pid: int) -> bool:
            with open(f"/proc/{pid}/mem", "rb"):
                return True

        pids = of_this_run(self.run)
        tries = [("trace", lambda pid=pid: seize(pid)) for pid in pids]
        tries += [("memory", lambda pid=pid: memory(pid)) for pid in pids]
        return got(tries)


class TakesItsParentsFiles(Adapter):
    """Lowers the limits of every process of the run: no more files, no more memory."""

    def mischief(self, request: Request) -> None:
        for pid in of_this_run(self.run):
            for what, most in ((resource.RLIMIT_NOFILE, 3), (resource.RLIMIT_FSIZE, 0)):
                try:
                    resource.prlimit(pid, what, (most, most))
                except (OSError, ValueError):
                    continue


class Privileges(Adapter):
    """Privileges that other processes lack."""

    def mischief(self, request: Request) -> str:
        status = Path("/proc/self/status").read_text()
        fields = dict(line.split(":\t", 1) for line in status.splitlines() if ":\t" in line)
        folder = Path(self.told["work"])

        def device() -> bool:
            path = folder / "minkref-hostile-device"
            os.mknod(path, 0o020666, os.makedev(1, 3))
            path.unlink()
            return True

        def mount() -> bool:
            place = b"/tmp"
            if LIBC.mount(b"minkref-hostile", place, b"tmpfs", 0, None) != 0:
                return False
            return LIBC.umount2(place, 2) == 0

        return got(
            [
                ("capabilities", lambda: int(fields["CapEff"], 16) != 0),
                ("new-privileges", lambda: fields.get("NoNewPrivs", "0") == "0"),
                ("device", device),
                ("mount", lambda: self.told.get("mount") and mount()),
                ("kernel-log", lambda: open("/dev/kmsg", "rb").close() is None),
            ]
        )


class ChangesTheTerminal(Adapter):
    """Turns off the echo of the terminal, and types a command into it."""

    def mischief(self, request: Request) -> str:
        def terminal() -> int:
            return os.open("/dev/tty", os.O_RDWR | os.O_NOCTTY)

        def echo() -> bool:
            stream = terminal()
            mode = termios.tcgetattr(stream)
            mode[3] &= ~termios.ECHO
            termios.tcsetattr(stream, termios.TCSANOW, mode)
            return True

        def types() -> bool:
            stream = terminal()
            for letter in b"minkref-hostile\n":
                fcntl.ioctl(stream, termios.TIOCSTI, bytes([letter]))
            return True

        def writes() -> bool:
            return os.write(terminal(), b"\x1b]0;minkref-hostile\x07") > 0

        return got([("echo", echo), ("typing", types), ("writing", writes)])


class SharesMemory(Adapter):
    """Shared memory, semaphores and message queues that outlive the adapter."""

    def mischief(self, request: Request) -> str:
        def left(number: int) -> bool:
            return number >= 0

        create, mode = 0o1000, 0o600
        key = int(self.run[:7], 16)  # by which the evidence finds what is left
        queue = f"/minkref-hostile-{self.run}".encode()
        return got(
            [
                ("shared-memory", lambda: left(LIBC.shmget(key, 4096, create | mode))),
                ("messages", lambda: left(LIBC.msgget(key, create | mode))),
                ("semaphores", lambda: left(LIBC.semget(key, 1, create | mode))),
                ("queue", lambda: left(LIBC.mq_open(queue, 0o102, mode, None))),
                ("posix-memory", lambda: left(LIBC.shm_open(queue, 0o102, mode))),
            ]
        )
