"""A judge that answers each JSON line by a JSON line: a child process, restarted after taking too
long or ending."""

from __future__ import annotations

import json
import selectors
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Self


class LineProcess:
    """For one thread. `seconds` limit each answer, on the clock. Close it, or use `with`."""

    def __init__(self, executable: Path, seconds: float) -> None:
        self._executable, self._seconds = executable, seconds
        self._process: subprocess.Popen[str] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is None:
            return
        self._process.kill()
        self._process.communicate()
        self._process = None

    def ask(self, request: dict[str, Any]) -> dict[str, Any]:
        """Returns the answer; {"error": why} if none comes."""
        if self._process is None:
            self._process = subprocess.Popen(
                [self._executable],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
                cwd=tempfile.gettempdir(),  # CGAL writes a diary into its folder
            )
        assert self._process.stdin is not None and self._process.stdout is not None
        try:
            self._process.stdin.write(json.dumps(request) + "\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            return self._lost("the process has ended")
        with selectors.DefaultSelector() as selector:
            selector.register(self._process.stdout, selectors.EVENT_READ)
            if not selector.select(self._seconds):
                return self._lost(f"no answer in {self._seconds:g} s")
        line = self._process.stdout.readline()
        if not line:
            return self._lost("the process has ended")
        answer: dict[str, Any] = json.loads(line)
        return answer

    def _lost(self, why: str) -> dict[str, Any]:
        self.close()
        return {"error": why}
