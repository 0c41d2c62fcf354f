"""Work that would take more memory than it may have ends with a refusal, and writes nothing."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.cli import cli
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import Refusal

Minkref = Callable[..., Any]
LARGE = ("glyph1204", "cells1815")
COMMANDS = {
    "sum": ("sum", *LARGE, "-o", "out.json"),
    "sum by definition": ("sum", *LARGE, "--route", "definition", "-o", "out.json"),
    "sum by dynamic update": ("sum", *LARGE, "--route", "dynamic", "-o", "out.json"),
    "convolution": ("convolution", *LARGE, "--full", "-o", "out.json"),
    "sweep": ("sweep", *LARGE, "--from", "1/2", "--to", "2", "--steps", "3", "-o", "out"),
    "events": ("events", *LARGE, "-o", "out.json"),
    "boundary events": ("events", *LARGE, "--kind", "boundary", "-o", "out.json"),
    "view": ("view", *LARGE, "-o", "out.html"),
    "certify": ("certify", *LARGE, "-o", "out.cert.json"),
    "index": ("index", *LARGE, "-o", "out.index"),
    "erode": ("erode", *LARGE, "--scale", "900", "-o", "out.json"),
    "opening": ("opening", *LARGE, "--scale", "900", "-o", "out.json"),
    "closing": ("closing", *LARGE, "-o", "out.json"),
    "nofit": ("nofit", *LARGE, "-o", "out.json"),
    "index of an erosion": ("index", *LARGE, "--erode", "-o", "out.index"),
    "path by its index": ("path", *LARGE, "POINT (0 0)", "--route", "index", "-o", "out.json"),
    "fit": ("fit", *LARGE, "--anywhere"),
    "trap": ("trap", *LARGE, "--at", "0,0"),
    "hold by its index": ("hold", *LARGE, "POINT (0 0)", "--route", "index", "-o", "out.json"),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_that_needs_more_than_it_may_have_is_refused(
    name: str, minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    answer = minkref(*COMMANDS[name], "--memory", "30", "--json")
    error = answer.json["error"]
    assert (answer.code, error["code"]) == (2, "memory-limit")
    assert "--memory" in error["mend"]
    assert all(operand in error["where"] for operand in LARGE)
    assert list(tmp_path.iterdir()) == []


PAPERS = {
    "with a disc": ("sum", "cells1815", "disc:2"),
    "with a disc, from radius to radius": ("sweep", "cells1815", "disc:2", "--scales", "two.txt"),
    "in space": ("sum", "gs3", "gs4"),
    "in space, from scale to scale": ("sweep", "gs3", "gs4", "--scales", "two.txt"),
}


@pytest.mark.parametrize("name", PAPERS)
def test_the_papers_update_that_needs_more_than_it_may_have_is_refused(
    name: str, minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "two.txt").write_text("1\n2\n", encoding="utf-8")
    route = ("--route", "paper-update", "--form", "corrected", "--arithmetic", "double")
    answer = minkref(*PAPERS[name], *route, "--memory", "30", "--json")
    error = answer.json["error"]
    assert (answer.code, error["code"]) == (2, "memory-limit")
    assert "--memory" in error["mend"] and PAPERS[name][1] in error["where"]


@pytest.mark.parametrize("number", ["-1", "99999999999"])
def test_a_limit_that_is_none_is_refused(number: str, minkref: Minkref) -> None:
    answer = minkref("sum", "g1", "g2", "--memory", number)
    assert answer.code == 2
    assert f"--memory {number}" in answer.err


def test_memory_that_ends_between_two_looks_is_a_refusal_too() -> None:
    with pytest.raises(Refusal) as refused, memory_wall(None, "the work", "P and Q", SIMPLER):
        raise MemoryError
    assert refused.value.code == "memory-limit"


def test_other_refusals_pass_the_wall_unchanged() -> None:
    with pytest.raises(_core.BadInput) as refused, memory_wall(None, "work", "P", SIMPLER):
        _core.read_text("POLYGON", "wkt")
    assert refused.value.code != "memory-limit"


@pytest.mark.parametrize(
    "error",
    [MemoryError(), _core.LimitExceeded],
    ids=["the system has no more", "the work has too much"],
)
def test_no_command_calls_a_lack_of_memory_a_fault_of_ours(
    error: Any, minkref: Minkref, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Those without --memory too."""

    def raises(*_: object, **__: object) -> None:
        if isinstance(error, MemoryError):
            raise error
        _core.set_memory_limit(1 << 20)
        try:
            _core.minkowski_sum(many_edges(), many_edges(), "1")
        finally:
            _core.set_memory_limit(0)

    monkeypatch.setattr(cli, "_built", lambda: raises)
    answer = minkref("report", "audit", "--json")
    assert answer.code == 2
    assert answer.json["error"]["code"] == "memory-limit"
    assert "internal" not in answer.err


def many_edges() -> _core.PolygonSet:
    ring = [f"{x} {x * x}" for x in range(2000)]
    return _core.read_text(f"POLYGON(({', '.join([*ring, ring[0]])}))", "wkt")


def test_peak_bytes_are_of_the_command_and_not_of_who_starts_it() -> None:
    """getrusage begins at the size of the process that started this one."""
    started = f"""
import subprocess, sys
held = b"x" * {400 << 20}
subprocess.run([sys.executable, "-m", "minkref", "models", "--json"], check=True)
"""
    ran = subprocess.run([sys.executable, "-c", started], capture_output=True, check=True)
    assert json.loads(ran.stdout)["peak_bytes"] < 300 << 20
