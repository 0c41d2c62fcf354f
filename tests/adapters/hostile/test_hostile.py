"""A few of the hostile adapters, functions and files; the part `hostile` of the evidence runs
all."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
from thoroughness import some

FOLDER = Path(__file__).parent
WORDS = ("--no-models", "--shrink-calls", "0", "--jobs", "1", "--no-settings")
FILES = (
    *("an underscore, json", "PLY, two billion vertices", "an exponent of twenty digits, wkt"),
    *("index, a column of 2^64 - 1 elements", "certificate, a case that is a device"),
    *("settings, lists in lists", "a bomb in gzip"),
)
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


@pytest.fixture
def room(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lets the room's modules import each other."""
    for folder in (FOLDER, FOLDER / "files"):
        monkeypatch.syspath_prepend(str(folder))


@pytest.mark.parametrize(
    ("kind", "name"),
    some(
        [
            ("", "Daemon"),
            ("", "ForgesTheLedger"),
            ("py:mischief:", "Daemon"),
            ("py:mischief:", "ForgesTheLedger"),
        ],
        few=2,
    ),
)
def test_an_attack_is_judged_and_leaves_nothing(kind: str, name: str, room: None) -> None:
    from attack import attack
    from attacks import ATTACKS
    from judging import faults_of

    (chosen,) = [one for one in ATTACKS if one.title == kind + name]
    seen = attack(kind + name, *chosen.words, *WORDS)
    sandboxed = (seen.document or {}).get("isolation", {}).get("kind") == "sandbox"
    assert faults_of(chosen, seen, sandboxed) == []


@pytest.mark.parametrize("title", some(FILES, 5))
def test_a_file_is_refused(title: str, room: None) -> None:
    from file_catalogue import FILES
    from reading import read

    (chosen,) = [file for file in FILES if file.title == title]
    seen: Any = read(chosen)
    assert seen.faults == [], seen
