"""Test fixtures for the CGAL oracle. Without its executables the tests are reported skipped."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.cgal.oracle import CgalOracle, OracleNotFoundError, find_executable

OracleFactory = Callable[..., CgalOracle]
Corners = list[tuple[Any, Any]]


class RawServer:
    """A server spoken to in bare lines."""

    def __init__(self, executable: Path) -> None:
        self.process = subprocess.Popen(
            [executable],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )

    def send(self, line: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def say(self, line: str) -> dict[str, Any]:
        self.send(line)
        assert self.process.stdout is not None
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer

    def ask(self, **request: Any) -> dict[str, Any]:
        return self.say(json.dumps(request))

    def close(self) -> None:
        self.process.kill()
        self.process.communicate()


@pytest.fixture
def executable() -> Callable[[str], Path]:
    def find(method: str) -> Path:
        try:
            return find_executable(method)
        except OracleNotFoundError as error:
            pytest.skip(str(error))

    return find


@pytest.fixture
def server(executable: Callable[[str], Path]) -> Iterator[RawServer]:
    raw = RawServer(executable("reduced"))
    yield raw
    raw.close()


@pytest.fixture
def oracle(executable: Callable[[str], Path]) -> Iterator[OracleFactory]:
    started: list[CgalOracle] = []

    def start(method: str, **options: Any) -> CgalOracle:
        executable(method)
        options.setdefault("seconds", 60)
        started.append(CgalOracle(method, **options))
        return started[-1]

    yield start
    for each in started:
        each.close()


@pytest.fixture
def polygon() -> Callable[..., dict[str, Any]]:
    """One polygon from its corners: the outer ring counter-clockwise, holes clockwise."""

    def ring(corners: Corners) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in corners]

    def build(outer: Corners, *holes: Corners) -> dict[str, Any]:
        return {"polygons": [{"outer": ring(outer), "holes": [ring(hole) for hole in holes]}]}

    return build


@pytest.fixture
def lost_hole(polygon: Callable[..., dict[str, Any]]) -> tuple[dict[str, Any], dict[str, Any]]:
    """CGAL issue 5830, fixed by CGAL 5.6: the reduced convolution loses this sum's hole. The point
    x = (37/5, 14) lies in the hole, because x - Q = (32/5,13)(37/5,13)(37/5,14) lies in P's
    hole."""
    P = polygon(
        [(0, 0), (20, 0), (20, 20), (0, 20)],
        [(6, 12), (7, 16), (11, 16), (9, 14), (8, 14), (7, 12)],
    )
    return P, polygon([(1, 1), (0, 1), (0, 0)])
