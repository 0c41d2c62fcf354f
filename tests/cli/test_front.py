"""The program as a whole: version, help, schemas, internal errors, pipes."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import minkref as package
import pytest
from minkref.cli.command_group import HEADING_OF, HEADINGS, load
from minkref.schemas import result_schema, schema
from rich.text import Text

Minkref = Callable[..., Any]
COMMANDS = (
    "sum",
    "point",
    "convolution",
    "repair",
    "union",
    "intersection",
    "difference",
    "sweep",
    "events",
    "index",
    "features",
    "erode",
    "opening",
    "closing",
    "nofit",
    "innerfit",
    "path",
    "fit",
    "trap",
    "hold",
    "decompose",
    "scene",
    "view",
    "verify",
    "certify",
    "check",
    "generate",
    "shrink",
    "bench",
    "report",
    "models",
    "targets",
    "families",
)
GROUPS = ("adapter", "campaign")  # of commands


def program(*arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "minkref", *arguments], capture_output=True, text=True, **options
    )


def test_version_is_that_of_the_package(minkref: Minkref) -> None:
    ran = minkref("--version")
    assert (ran.code, ran.out) == (0, f"minkref {package.__version__}\n")


# Packages that `pip install minkref` omits; only arrays need NumPy.
OPTIONAL = (
    "gmpy2", "hypothesis", "matplotlib", "numpy", "plotly", "pyarrow", "rfc3987_syntax", "sympy",
)  # fmt: skip
WITHOUT_OPTIONAL = f"""
import sys
sys.modules.update(dict.fromkeys({OPTIONAL!r}))  # to import one of them raises
from minkref.cli.cli import run
sys.exit(any(run(words) for words in {[["--version"], *([name, "--help"] for name in COMMANDS)]}))
"""


def test_optional_packages_are_not_needed_to_start() -> None:
    ran = subprocess.run([sys.executable, "-c", WITHOUT_OPTIONAL], capture_output=True, text=True)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.count("Examples") == len(COMMANDS)


def test_no_command_shows_the_help_and_exits_2(minkref: Minkref) -> None:
    ran = minkref()
    assert ran.code == 2
    assert all(command in ran.out + ran.err for command in COMMANDS)
    assert "Examples" in minkref("--help").out


def test_the_help_has_the_commands_under_headings(minkref: Minkref) -> None:
    first = [line.strip("╭─│ ").split(" ")[0] for line in minkref("--help").out.splitlines()]
    words = [word for word in first if word in HEADINGS or word in HEADING_OF]
    assert words == [word for heading, lines in HEADINGS.items() for word in (heading, *lines)]
    assert sorted(HEADING_OF) == sorted([*COMMANDS, *GROUPS])


@pytest.mark.parametrize("command", COMMANDS)
def test_help_of_every_command_has_examples(minkref: Minkref, command: str) -> None:
    ran = minkref(command, "--help")
    assert ran.code == 0
    assert "Examples" in ran.out
    assert f"minkref {command}" in ran.out


@pytest.mark.parametrize("name", (*COMMANDS, *GROUPS))
def test_no_word_of_a_help_is_taken_for_markup(name: str) -> None:
    """`[tool.minkref]` would vanish."""
    commands = [load(name)]
    while commands:
        command = commands.pop()
        commands += getattr(command, "commands", {}).values()
        for text in (command.help, *(getattr(option, "help", "") for option in command.params)):
            assert Text.from_markup(text or "").plain == (text or "")


@pytest.mark.parametrize("name", ["path", "fit", "trap", "hold", "innerfit"])
def test_what_moves_is_a_part_among_obstacles_or_in_a_container(name: str) -> None:
    """One word for one thing; examples name files as they like."""
    command = load(name)
    told = (command.help or "").split("Examples")[0]
    texts = [told, *(getattr(option, "help", None) or "" for option in command.params)]
    names = [str(option.name) for option in command.params]
    words = set(re.findall("[a-z]+", " ".join([*texts, *names]).lower()))
    assert not words & {"robot", "tool", "cutter", "workpiece", "assembly", "shape", "environment"}
    assert {"part", "container" if name in ("fit", "innerfit") else "obstacles"} <= words


@pytest.mark.parametrize("command", COMMANDS)
def test_schema_is_printed_without_operands_and_is_a_schema(minkref: Minkref, command: str) -> None:
    ran = minkref(command, "--schema")
    assert ran.code == 0
    jsonschema.Draft202012Validator.check_schema(ran.json)
    assert ran.json == schema(command)
    result = result_schema(command)
    assert result["properties"]["command"] == {"const": command}
    assert {"version", "command", "seconds", "peak_bytes"} <= set(result["required"])


@pytest.mark.parametrize("command", ["models", "targets"])
def test_lists_follow_their_schemas(minkref: Minkref, command: str) -> None:
    ran = minkref(command, "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, schema(command))


def test_targets_name_our_routes_and_all_methods_of_cgal(minkref: Minkref) -> None:
    rows = {row["name"]: row for row in minkref("targets", "--json").json["targets"]}
    for route in ("paper", "winding", "definition"):
        assert rows[f"minkref:{route}"]["available"]
    for method in ("reduced", "full", "vertical", "triangulation", "ssab", "optimal", "greene"):
        row = rows[f"cgal-{method}"]
        assert row["available"] or "cmake --build" in row["reason"]


def test_absent_target_names_the_command_that_builds_it(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from minkref.fuzz.cgal import executables as cgal_executables

    monkeypatch.setattr(cgal_executables, "search_folders", lambda: [tmp_path])
    ran = minkref("verify", "cgal-reduced", "--pairs", "1")
    assert ran.code == 2
    assert "cmake --build" in ran.err


def test_internal_error_is_short_and_exits_70(
    minkref: Minkref, monkeypatch: pytest.MonkeyPatch
) -> None:
    from minkref.verbs import models

    def broken() -> None:
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr(models, "all_models", broken)
    ran = minkref("models")
    assert ran.code == 70
    assert "a fault of ours" in ran.err
    assert "Traceback" not in ran.err
    ran = minkref("models", "--debug")
    assert ran.code == 70
    assert "Traceback" in ran.err


def test_module_and_pipe_give_the_json_and_nothing_else() -> None:
    ran = program("sum", "g1", "g3", "--json")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert json.loads(ran.stdout)["command"] == "sum"


def test_closed_pipe_is_no_error() -> None:
    ran = subprocess.run(
        f"{sys.executable} -m minkref sum --schema | head -c 1",
        shell=True,
        capture_output=True,
        text=True,
    )
    assert (ran.stdout, ran.stderr) == ("{", "")
