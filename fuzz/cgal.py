"""Client of the CGAL oracle: sums by CGAL's methods, each computed in a child process of a server.

The servers are the executables of oracle/cgal (GPL-3.0-or-later), spoken to in JSON lines as its
README.md says. Nothing that CGAL does to its own process reaches this one.
"""

from __future__ import annotations

import itertools
import json
import os
import selectors
import signal as signals
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from minkref.fuzz.cgal_executables import (
    ABOUT,
    BUILD_COMMAND,
    METHOD_GROUPS,
    METHODS_WITH_HOLES,
    OracleNotFoundError,
    available_targets,
    cgal_version,
    find_executable,
    method_of_target,
    target_names,
)

__all__ = [
    "ABOUT",
    "BUILD_COMMAND",
    "METHODS_WITH_HOLES",
    "METHOD_GROUPS",
    "CgalOracle",
    "OracleAnswer",
    "OracleNotFoundError",
    "available_targets",
    "cgal_version",
    "find_executable",
    "method_of_target",
    "target_names",
]

# What a server may take beyond the time limit of a call, to end its child and to answer.
GRACE_SECONDS = 20.0
STATUSES = ("result", "skipped", "crashed", "timed-out", "out-of-memory", "errored")


@dataclass(frozen=True)
class OracleAnswer:
    """What became of one call. `seconds` is the time of the CGAL call alone where there is a
    result, else the time until it ended; `total_seconds` is that of the child process. `rings_json`
    is the result as CGAL gave it, `{"polygons":[...]}`, not canonical. `signal` is a name, as
    SIGSEGV; a crash without one is a std::bad_alloc that no limit of ours explains."""

    status: str
    reason: str | None = None
    rings_json: str | None = None
    seconds: float | None = None
    signal: str | None = None
    total_seconds: float | None = None
    peak_bytes: int | None = None
    removed_holes: int = 0


class CgalOracle:
    """Sums by one method of CGAL. Holds a server, starts it at the first call, and starts it anew
    where it has died. For one thread. `seconds` (on the clock) and `bytes` (of address space) limit
    each call; `raw` hands every hole to CGAL, also those that cannot survive and over which CGAL
    5.5.1 may corrupt its memory."""

    _server: subprocess.Popen[bytes] | None = None

    def __init__(
        self,
        method: str,
        executable: str | os.PathLike[str] | None = None,
        raw: bool = False,
        seconds: float = 60.0,
        bytes: int = 4 << 30,
    ) -> None:
        if method not in METHOD_GROUPS and not method.startswith("self-test:"):
            raise ValueError(f"no method {method!r}; there are {', '.join(METHOD_GROUPS)}")
        self.method = method
        self.raw = raw
        self._limits = {"seconds": seconds, "bytes": bytes}
        known = method if method in METHOD_GROUPS else "reduced"
        self.executable = Path(executable) if executable else find_executable(known)
        self._ids = itertools.count(1)

    def sum(self, P_json: str | dict[str, Any], Q_json: str | dict[str, Any]) -> OracleAnswer:
        """The sum of two polygon sets {"polygons":[{"outer":[["x","y"],...],"holes":[...]}]}.
        Every failure of CGAL or of the server is an answer; OSError where no server starts."""
        number = next(self._ids)
        request = self._request(number, P_json, Q_json)
        try:
            self._send(request)
        except BrokenPipeError:  # it died since the last call
            self.close()
            self._send(request)
        line = self._receive()
        if line is None:
            return self._lost("the server gave no answer in time")
        if not line.endswith(b"\n"):
            return self._lost("the server ended without an answer")
        return self._read(line, number)

    def close(self) -> None:
        """Ends the server. The next call starts another."""
        server, self._server = self._server, None
        if server is None:
            return
        if server.poll() is None:
            server.kill()
        for stream in (server.stdin, server.stdout):
            try:
                if stream:
                    stream.close()
            except BrokenPipeError:
                pass
        server.wait()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _request(self, number: int, P: str | dict[str, Any], Q: str | dict[str, Any]) -> bytes:
        head = json.dumps({"id": number, "method": self.method, "raw": self.raw, **self._limits})
        return f'{head[:-1]}, "P": {_one_line(P)}, "Q": {_one_line(Q)}}}\n'.encode()

    def _start(self) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [str(self.executable)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            bufsize=0,
        )

    def _send(self, request: bytes) -> None:
        if self._server is not None and self._server.poll() is not None:
            self.close()
        if self._server is None:
            self._server = self._start()
        assert self._server.stdin is not None
        view = memoryview(request)
        while view:
            view = view[self._server.stdin.write(view) :]

    def _receive(self) -> bytes | None:
        """A line; what there is of it where the server ended; None where it took too long."""
        assert self._server is not None and self._server.stdout is not None
        deadline = time.monotonic() + self._limits["seconds"] + GRACE_SECONDS
        pieces: list[bytes] = []
        with selectors.DefaultSelector() as selector:
            selector.register(self._server.stdout, selectors.EVENT_READ)
            while not pieces or not pieces[-1].endswith(b"\n"):
                if not selector.select(max(0.0, deadline - time.monotonic())):
                    return None
                piece = os.read(self._server.stdout.fileno(), 1 << 20)
                if not piece:
                    break
                pieces.append(piece)
        return b"".join(pieces)

    def _read(self, line: bytes, number: int) -> OracleAnswer:
        try:
            value = json.loads(line)
            if value["id"] != number or value["status"] not in STATUSES:
                return self._lost("the server's answer is not that of the protocol")
            signal = value.get("signal")
            result = value.get("result")
            return OracleAnswer(
                status=value["status"],
                reason=value.get("reason"),
                rings_json=json.dumps(result, separators=(",", ":")) if result else None,
                seconds=value.get("seconds"),
                signal=signals.Signals(signal).name if signal else None,
                total_seconds=value.get("total_seconds"),
                peak_bytes=value.get("peak_bytes"),
                removed_holes=value.get("removed_holes", 0),
            )
        except (ValueError, KeyError, TypeError) as error:
            return self._lost(f"the server's answer is not that of the protocol: {error}")

    def _lost(self, reason: str) -> OracleAnswer:
        self.close()
        return OracleAnswer(status="errored", reason=f"{self.executable.name}: {reason}")


def _one_line(operand: str | dict[str, Any]) -> str:
    return " ".join(operand.splitlines()) if isinstance(operand, str) else json.dumps(operand)
