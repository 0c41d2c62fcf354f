"""A server of the oracle: JSON lines to and from an executable in oracle/cgal or oracle/sampled.

The server starts at the first request, and anew after dying; servers in oracle/cgal answer each
request by a child process. Damage to their own process never reaches this process.
"""

from __future__ import annotations

import itertools
import json
import os
import selectors
import subprocess
import time
from pathlib import Path
from typing import Any, Self

# Time for a server beyond the limit of a call, to end its child and to answer.
GRACE_SECONDS = 20.0
STATUSES = ("result", "skipped", "crashed", "timed-out", "out-of-memory", "errored")


class OracleServer:
    """Holds a server. For one thread. `seconds` (on the clock) and `bytes` (of address space) limit
    each request."""

    _server: subprocess.Popen[bytes] | None = None

    def __init__(self, executable: Path, seconds: float = 60.0, bytes: int = 4 << 30) -> None:
        self.executable = executable
        self._limits = {"seconds": seconds, "bytes": bytes}
        self._ids = itertools.count(1)

    def ask(
        self, method: str, operands: dict[str, str | dict[str, Any]], **members: Any
    ) -> dict[str, Any]:
        """The answer, with members as the room's README lists them. Operands are JSON texts or
        objects {"polygons":[{"outer":[["x","y"],...],"holes":[...]}]}. Every failure of the server
        becomes an answer with a `status` and a `reason`; OSError if no server starts."""
        number = next(self._ids)
        head = json.dumps({"id": number, "method": method, **members, **self._limits})
        tail = "".join(f', "{name}": {_one_line(value)}' for name, value in operands.items())
        request = f"{head[:-1]}{tail}}}\n".encode()
        try:
            self._send(request)
        except BrokenPipeError:  # it died since the last call
            self.close()
            self._send(request)
        line = self._receive()
        if line is None:
            return self.lost("the server gave no answer in time")
        if not line.endswith(b"\n"):
            return self.lost("the server ended without an answer")
        try:
            value: dict[str, Any] = json.loads(line)
            if value["id"] == number and value["status"] in STATUSES:
                return value
            return self.lost("the server's answer is not that of the protocol")
        except (ValueError, KeyError, TypeError) as error:
            return self.lost(f"the server's answer is not that of the protocol: {error}")

    def lost(self, reason: str) -> dict[str, Any]:
        """Ends the server, and returns the answer for a missing or unusable answer."""
        self.close()
        return {"status": "errored", "reason": f"{self.executable.name}: {reason}"}

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

    def __exit__(self, *_: object) -> None:
        self.close()

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
        """Reads a line; a partial line if the server ended; None if the server took too long."""
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


def _one_line(operand: str | dict[str, Any]) -> str:
    return " ".join(operand.splitlines()) if isinstance(operand, str) else json.dumps(operand)
