"""Following a hint leads to no other question: for all commands, in each setting, with every
option, right or misspelt, the recommendations of refusals are tried."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hint_steps import Words, steps
from minkref import errors as minkref_errors
from minkref.cli.command_group import load
from minkref.cli.command_options import options_of

Minkref = Callable[..., Any]

SQUARE = "POLYGON((0 0,2 0,2 2,0 2,0 0))"
NOTCH = "POLYGON((0 0,3 0,3 3,2 3,2 1,1 1,1 3,0 3,0 0))"
ROOM = "POLYGON((-9 -9,9 -9,9 9,-9 9,-9 -9),(-5 -5,-5 5,5 5,5 -5,-5 -5))"
WAY = "LINESTRING (-9 9, 9 9)"
CUBE = """OFF
8 6 0
0 0 0
1 0 0
0 1 0
1 1 0
0 0 1
1 0 1
0 1 1
1 1 1
4 0 2 3 1
4 4 5 7 6
4 0 1 5 4
4 2 6 7 3
4 0 4 6 2
4 1 3 7 5
"""
#: Refusals that depend on the numbers, or on a program that is not built, not on an option.
OF_THE_NUMBERS = ("undecided-sign", "no-proof", "not-star-shaped", "not-built")
CUBES = ["cube.off", "cube.off"]
SCENE = (
    '{"schema":"scene-v1","robot":"POINT (0 0)",'
    '"shapes":{"box":"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"},"copies":[]}'
)
DRAWING = """<svg xmlns:i="http://www.inkscape.org/namespaces/inkscape">
<g i:groupmode="layer" id="cut"><rect width="2" height="2"/></g></svg>"""
WINDOW = ["--from", "1", "--to", "2"]
#: Arguments that each command takes in each setting.
TAKEN: dict[str, dict[str, Words]] = {
    "sum": {
        "plane": [SQUARE, NOTCH], "disc": [SQUARE, "disc:1"], "space": CUBES,
        "ball": ["cube.off", "ball:1", "--tolerance", "1"],
    },
    "convolution": {"plane": [SQUARE, NOTCH], "space": CUBES},
    "index": {
        "plane": [SQUARE, NOTCH, "-o", "kept.index"], "disc": [SQUARE, "disc", "-o", "kept.json"],
    },
    "sweep": {
        "plane": [SQUARE, NOTCH, *WINDOW, "--steps", "2"],
        "disc": [SQUARE, "disc", *WINDOW, "--steps", "2"],
        "space": [*CUBES, "--scales", "scales.txt"],
    },
    "events": {
        "plane": [SQUARE, NOTCH], "disc": [NOTCH, "disc"],
        "space": [*CUBES, *WINDOW],
    },
    "features": {"plane": [NOTCH]},
    "erode": {
        "plane": [NOTCH, SQUARE], "disc": [NOTCH, "disc:1/9"], "space": CUBES,
        "ball": ["cube.off", "ball:1/9", "--tolerance", "1/9"],
    },
    "opening": {"plane": [NOTCH, SQUARE], "disc": [NOTCH, "disc:1/9"]},
    "closing": {"plane": [NOTCH, SQUARE], "disc": [NOTCH, "disc:1/9"]},
    "nofit": {"plane": [NOTCH, SQUARE], "space": CUBES},
    "innerfit": {"plane": [NOTCH, SQUARE], "space": CUBES},
    "path": {
        "plane": [SQUARE, NOTCH, WAY], "disc": ["disc", NOTCH, WAY],
        "space": [*CUBES, "0,0,9\n9,0,9"],
    },
    "fit": {
        "plane": [SQUARE, ROOM, "--at", "6,6"], "disc": ["disc", ROOM, "--at", "6,6"],
        "space": [*CUBES, "--at", "0,0,0"],
    },
    "trap": {
        "plane": [SQUARE, ROOM, "--at", "0,0"], "disc": ["disc", ROOM, "--at", "0,0"],
        "space": [*CUBES, "--at", "0,0,0"],
    },
    "hold": {"plane": [SQUARE, NOTCH, WAY], "space": [*CUBES, "0,0,9\n9,0,9"]},
    "view": {
        "plane": [SQUARE, NOTCH, "-o", "v.html"], "disc": [NOTCH, "disc", "-o", "v.html"],
        "path": [SQUARE, NOTCH, "--path", WAY, "-o", "v.html"],
        "space": [*CUBES, "-o", "v.html"], "scene": [SCENE, "-o", "v.html"],
    },
    "decompose": {"plane": [NOTCH]},
    "repair": {"plane": [NOTCH], "space": ["cube.off"], "drawing": ["square.svg"]},
    "scene": {"plane": [SCENE]},
    "certify": {
        "plane": [SQUARE, SQUARE, "-o", "c.cert.json"],
        "space": [*CUBES, "-o", "s.cert.json"],
    },
}  # fmt: skip
#: Values of options, for which there is an answer somewhere.
VALUES: dict[str, list[str]] = {
    "--route": ["paper", "index", "edges", "pieces", "paper-update"],
    "--arithmetic": ["double"],
    "--form": ["printed"],
    "--reading": ["observation=corrected"],
    "-o": ["made.png", "made.svg", "made.wkt"],
    "--format": ["json", "wkt"],
    "--kind": ["pair", "topology", "triple"],
    "--where": ["s > 1"],
    "--limit": ["3"],
    "--compatible": ["closed"],
    "--contact": ["forbidden"],
    "--clearance": ["1/4"],
    "--repair": ["literal"],
    "--tolerance": ["1/10"],
    "--scale": ["2", "1,2,3"],
    "--scales": ["scales.txt"],
    "--steps": ["3"],
    "--from": ["1"],
    "--to": ["2"],
    "--alpha": ["1"],
    "--persistence": ["1"],
    "--event": ["1"],
    "--degeneracy": ["1"],
    "--point": ["1,1", "1,1,1"],
    "--certify": ["made.cert.json", "made.json"],
    "--path": [WAY],
    "--check": ["1"],
    "--threads": ["1"],
    "--at": ["0,0"],
    "--way": [WAY],
    "--copies": ["copies.csv"],
    "--layer": ["cut"],
    "--rule": ["positive"],
    "--weld": ["1/1000"],
}
#: Options that refuse a misspelt value.
WORDS = (
    "--route", "--arithmetic", "--form", "--reading", "--format", "--kind", "--compatible",
    "--contact", "--repair", "--rule",
)  # fmt: skip
NOT_WALKED = ("--json", "--schema", "--memory", "--index", "--theorem", "--between")


def lines(command: str, setting: str) -> list[tuple[str, Words]]:
    """The command with each option in turn."""
    base = [command, *TAKEN[command][setting]]
    found = []
    for option in options_of(load(command).callback):
        if not option.yes or option.yes in NOT_WALKED:
            continue
        for value in [[]] if option.kind is bool else [[value] for value in VALUES[option.yes]]:
            kept = list(base)
            if option.yes in kept:
                del kept[kept.index(option.yes) : kept.index(option.yes) + 2]
            beside = ["-o", "made"] if option.yes == "--format" else []
            found.append((option.yes, [*kept, option.yes, *value, *beside]))
    return found


def misspelt(line: Words, option: str) -> list[Words]:
    """With the last two letters of the value exchanged; a reading also in its name, or without a
    value."""
    at = line.index(option) + 1
    wrong = [line[at][:-2] + line[at][:-3:-1]]
    if option == "--reading":
        name, value = line[at].split("=")
        wrong += [name, f"{name[:-2]}{name[:-3:-1]}={value}"]
    return [[*line[:at], word, *line[at + 1 :]] for word in wrong]


@pytest.mark.parametrize("command", TAKEN)
def test_what_a_hint_recommends_is_accepted(
    minkref: Minkref, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, command: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "cube.off").write_text(CUBE, encoding="utf-8")
    (tmp_path / "square.svg").write_text(DRAWING, encoding="utf-8")
    (tmp_path / "scales.txt").write_text("1\n2\n", encoding="utf-8")
    (tmp_path / "copies.csv").write_text("shape,scale,x,y\nbox,1,0,0\n", encoding="utf-8")
    refusals: list[dict[str, str]] = []
    told = minkref_errors.refusal_text

    def keep(error: dict[str, str]) -> str:
        refusals.append(error)
        return told(error)

    monkeypatch.setattr(minkref_errors, "refusal_text", keep)
    followed = 0

    @cache
    def error_of(*words: str) -> dict[str, str] | None:
        """The refusal of a line; None if the line is accepted."""
        refused = minkref(*words).code == 2 and refusals[-1]["code"] not in OF_THE_NUMBERS
        return refusals[-1] if refused else None

    def after(line: Words) -> list[Words]:
        """Returns an accepted line, otherwise all lines to which the hint leads."""
        nonlocal followed
        error = error_of(*line)
        if error is None:
            return [line]
        others = list(steps(line, error["where"], error["mend"]))
        for other in others:
            assert other != line, f"{line}: {error}"
            assert not error_of(*other), f"{line}\n{error}\nleads to {other}\n{refusals[-1]}"
        followed += len(others)
        return others

    for setting in TAKEN[command]:
        for option, line in lines(command, setting):
            right = [taken for taken in after(line) if option in taken]
            for wrong in misspelt(right[0], option) if right and option in WORDS else ():
                assert error_of(*wrong), wrong
                assert after(wrong), wrong
    assert followed or command == "certify", "hints are read"
