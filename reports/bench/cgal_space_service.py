"""CGAL's sums in space, timed, with exact kernels: the hull of all vertex sums, or Nef
polyhedra."""

from __future__ import annotations

import json
import subprocess
from typing import Any

from minkref import _core
from minkref.fuzz.libraries.catalogue import absence, command

HULL, NEF = "cgal-hull", "cgal-nef"


class NoSumError(Exception):
    """Raised when the program is absent or gives no answer."""


class CgalSpaceService:
    """A process for many sums; close it, or use a `with`."""

    def __init__(self, name: str = HULL) -> None:
        line = command(name)
        if line is None:
            raise NoSumError(absence(name) or "there is no such adapter")
        self._process = subprocess.Popen(
            line, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self._ask({"verb": "hello", "protocols": ["adapter-v1"]})

    def __enter__(self) -> CgalSpaceService:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def load(self, Q: _core.Polyhedron) -> None:
        self._ask({"verb": "load", "dimension": 3, "Q": _document(Q)})

    def sum(self, sP: _core.Polyhedron) -> tuple[float, dict[str, Any]]:
        """CGAL's own seconds (for the hull, including the sums of all vertex pairs), and the sum as
        triangles."""
        answer = self._ask({"verb": "at", "sP": _document(sP), "timed": True})
        return answer["cgal_seconds"], answer

    def close(self) -> None:
        self._process.terminate()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                stream.close()

    def _ask(self, request: dict[str, Any]) -> dict[str, Any]:
        if self._process.stdin is None or self._process.stdout is None:
            raise NoSumError("the process has no streams")
        self._process.stdin.write(json.dumps(request) + "\n")
        self._process.stdin.flush()
        answer: dict[str, Any] = json.loads(self._process.stdout.readline() or "{}")
        if answer.get("status") != "result":
            raise NoSumError(str(answer.get("reason", "no answer")))
        return answer


def _document(polyhedron: _core.Polyhedron) -> dict[str, Any]:
    return {"vertices": polyhedron.written_points(), "faces": polyhedron.rings()}
