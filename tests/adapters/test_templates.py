"""Each template works as written, without dependencies."""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.fuzz.adapters.template import HEADER
from thoroughness import some

TEMPLATES = HEADER.parent / "templates"
COMPILERS = {
    "cpp": ["c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-O1"],
    "rs": ["rustc", "-D", "warnings"],
}
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def started(ending: str, folder: Path) -> list[str]:
    """The command that starts the template, after compilation if the language needs it."""
    source = str(TEMPLATES / f"template.{ending}")
    if ending == "py":
        return [sys.executable, source]
    tool = {"js": "node", "cpp": "c++", "rs": "rustc"}[ending]
    if ending != "cpp" and not shutil.which(tool):  # what built minkref has a C++ compiler
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


def rings(answer: dict[str, Any]) -> list[list[list[float]]]:
    """All rings of an answer without holes."""
    if "rings" in answer:
        found: list[list[list[float]]] = answer["rings"]
        return found
    assert all(polygon["holes"] == [] for polygon in answer["polygons"])
    return [polygon["outer"] for polygon in answer["polygons"]]


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
    (ring,) = rings(answer)
    assert corners(ring) == {(0, 0), (2, 0), (2, 2), (0, 2)}
    assert adapter.ask("at", scale="3", sP=region([[0, 0], [3, 0], [0, 3]]))["status"] == "result"
    assert adapter.stop() == 0


def test_offsets_of_convex_polygons(
    command: list[str], converse: Callable[[list[str]], Any]
) -> None:
    """Declared or not: without `load`, and between sums."""
    adapter = converse(command)
    for radius in (0.5, 3, 1e-3):
        answer = adapter.ask("offset", dimension=2, P=region(SQUARE), radius=radius)
        (ring,) = rings(answer)
        pairs = zip(ring, ring[1:] + ring[:1], strict=True)
        area = abs(sum(a * d - b * c for (a, b), (c, d) in pairs)) / 2
        exact = 1 + 4 * radius + math.pi * radius**2
        assert 0 <= exact - area <= 0.0005 * math.pi * radius**2 + 1e-12
        assert adapter.sum(region(SQUARE), region(SQUARE))["status"] == "result"
    assert adapter.stop() == 0


@pytest.mark.parametrize("shift", range(4))
def test_sums_of_convex_polygons(
    command: list[str], converse: Callable[[list[str]], Any], shift: int
) -> None:
    adapter = converse(command)
    turned = SQUARE[shift:] + SQUARE[:shift]
    (ring,) = rings(adapter.sum(region(turned), region([[-1.5, 0.25], [1e-3, -2], [4e2, 7]])))
    sums = {(x + u, y + v) for x, y in SQUARE for u, v in [(-1.5, 0.25), (1e-3, -2), (4e2, 7)]}
    assert corners(ring) <= sums
    assert len(corners(ring)) == 7
    (split,) = rings(adapter.sum(region([*turned, [0.5, 0.5]][:4]), region(SQUARE)))
    assert corners(split) == {(0, 0), (2, 0), (2, 2), (0, 2)}


@pytest.mark.parametrize("line", ["garbage", "{}", '{"seq":5}', "[1, 2]"])
def test_lines_that_are_no_requests(
    command: list[str], converse: Callable[[list[str]], Any], line: str
) -> None:
    adapter = converse(command)
    assert adapter.line(line)["status"] in ("errored", "skipped")
    assert adapter.ask("at", scale="1", sP=region(SQUARE))["status"] == "errored"
    assert adapter.hello()["status"] == "result"


def test_a_set_without_polygons_is_told_and_ends_nothing(
    command: list[str], converse: Callable[[list[str]], Any]
) -> None:
    adapter = converse(command)
    answer = adapter.sum({"polygons": []}, region(SQUARE))
    assert answer["status"] == "errored"
    assert rings(adapter.sum(region(SQUARE), region(SQUARE)))


def test_sets_of_several_polygons_with_holes_in_the_template_in_cpp(
    tmp_path: Path, converse: Callable[[list[str]], Any]
) -> None:
    """Whatever `minkowski_sum` is given and gives goes through whole."""
    text = (TEMPLATES / "template.cpp").read_text(encoding="utf-8")
    begin = text.index("{", text.index("bool minkowski_sum"))
    end = text.index("\n}", begin)
    source = tmp_path / "echo.cpp"
    source.write_text(f"{text[:begin]}{{\n  (void)Q, sum = sP;\n  return true;{text[end:]}")
    program = str(tmp_path / "echo")
    unused = "-Wno-unused-function"  # convex_sum
    subprocess.run([*COMPILERS["cpp"], unused, str(source), "-o", program], check=True, timeout=300)
    frame = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
    holes = [[[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]], [[3.0, 2.5], [2.5, 3.0], [3.0, 3.0]]]
    island = {"outer": [[9.0, 9.0], [1e300, 9.0], [9.0, 10.5]], "holes": []}
    sP = {"polygons": [{"outer": frame, "holes": holes}, island]}
    answer = converse([program]).sum(sP, region(SQUARE))
    assert answer["polygons"] == sP["polygons"]


LANGUAGES = {"c": "cc", "c++": "c++", "python": "python3", "javascript": "node", "rust": "rustc"}


@pytest.mark.parametrize("language", some(LANGUAGES, 3))
def test_the_commands_that_are_printed_work_as_printed(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    language: str,
) -> None:
    if language in ("javascript", "rust") and not shutil.which(LANGUAGES[language]):
        pytest.skip(f"{LANGUAGES[language]} is not installed")
    environment = {
        **os.environ,
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
    }

    def shell(line: str) -> None:
        ran = subprocess.run(
            line, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr

    monkeypatch.chdir(tmp_path)
    assert run(["adapter", "new", "my-lib", "--language", language]) == 0
    first, *commands = capsys.readouterr().out.splitlines()
    assert (tmp_path / first).is_file() and commands
    for line in commands:
        short = line.strip().replace("--seconds 30", "--pairs 2 --no-models --jobs 1")
        shell(short)
