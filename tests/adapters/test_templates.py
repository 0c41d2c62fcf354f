"""Each template works as it is written, without dependencies."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.adapters import catalogue

TEMPLATES = catalogue.HERE / "templates"
COMPILERS = {
    "cpp": ["g++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-O1"],
    "rs": ["rustc", "-D", "warnings"],
}
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def started(ending: str, folder: Path) -> list[str]:
    """The words that start the template; compiled where its language is."""
    source = str(TEMPLATES / f"template.{ending}")
    if ending == "py":
        return [sys.executable, source]
    tool = {"js": "node", "cpp": "g++", "rs": "rustc"}[ending]
    if not shutil.which(tool):
        pytest.skip(f"{tool} is not installed")
    if ending == "js":
        return ["node", source]
    program = str(folder / "template")
    subprocess.run([*COMPILERS[ending], source, "-o", program], check=True, timeout=300)
    return [program]


@pytest.fixture(scope="module", params=["py", "js", "cpp", "rs"])
def command(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    return started(request.param, tmp_path_factory.mktemp("template"))


def region(ring: list[list[float]]) -> dict[str, Any]:
    return {"polygons": [{"outer": ring, "holes": []}]}


def corners(ring: list[list[float]]) -> set[tuple[float, float]]:
    """The vertices at which the ring turns."""
    turning = set()
    for k, (x, y) in enumerate(ring):
        (a, b), (c, d) = ring[k - 1], ring[(k + 1) % len(ring)]
        if (x - a) * (d - y) != (y - b) * (c - x):
            turning.add((float(x), float(y)))
    return turning


def test_a_conversation(command: list[str], converse: Callable[[list[str]], Any]) -> None:
    adapter = converse(command)
    hello = adapter.hello()
    assert hello["status"] == "result"
    assert (hello["protocol"], hello["numbers"]) == ("adapter-v1", "double")
    assert hello["capabilities"] == ["plane"]
    assert hello["tolerance"] == {"absolute": "0", "relative": "1e-9"}
    answer = adapter.sum(region(SQUARE), region(SQUARE))
    (ring,) = answer["rings"]
    assert corners(ring) == {(0, 0), (2, 0), (2, 2), (0, 2)}
    assert adapter.ask("at", scale="3", sP=region([[0, 0], [3, 0], [0, 3]]))["status"] == "result"
    assert adapter.stop() == 0


@pytest.mark.parametrize("shift", range(4))
def test_sums_of_convex_polygons(
    command: list[str], converse: Callable[[list[str]], Any], shift: int
) -> None:
    adapter = converse(command)
    turned = SQUARE[shift:] + SQUARE[:shift]
    (ring,) = adapter.sum(region(turned), region([[-1.5, 0.25], [1e-3, -2], [4e2, 7]]))["rings"]
    sums = {(x + u, y + v) for x, y in SQUARE for u, v in [(-1.5, 0.25), (1e-3, -2), (4e2, 7)]}
    assert corners(ring) <= sums
    assert len(corners(ring)) == 7
    (split,) = adapter.sum(region([*turned, [0.5, 0.5]][:4]), region(SQUARE))["rings"]
    assert corners(split) == {(0, 0), (2, 0), (2, 2), (0, 2)}


@pytest.mark.parametrize("line", ["garbage", "{}", '{"seq":5}', "[1, 2]"])
def test_lines_that_are_no_requests(
    command: list[str], converse: Callable[[list[str]], Any], line: str
) -> None:
    adapter = converse(command)
    assert adapter.line(line)["status"] in ("errored", "skipped")
    assert adapter.ask("at", scale="1", sP=region(SQUARE))["status"] == "errored"
    assert adapter.hello()["status"] == "result"
