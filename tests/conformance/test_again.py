"""The command that makes a report again."""

from __future__ import annotations

import shlex
from pathlib import Path

from minkref.cli.command_line import command_line
from minkref.verbs import verify


def test_what_was_given_is_said_and_nothing_else() -> None:
    values = {
        "targets": ["py:a b:c", "cgal-reduced"],
        "pairs": 30,
        "seed": 1,
        "family": ["holes", "comb"],
        "models": False,
        "strict": True,
        "json": True,
        "report": Path("build/a b"),
        "watch": object(),
    }
    line = command_line("verify", verify.command, values)
    words = shlex.split(line)
    assert words[:4] == ["minkref", "verify", "py:a b:c", "cgal-reduced"]
    pairs = [" ".join(words[k : k + 2]) for k in range(len(words) - 1)]
    for part in ("--pairs 30", "--family holes", "--family comb", "--report build/a b"):
        assert part in pairs
    assert {"--no-models", "--strict", "--json"} <= set(words)
    assert "--seed" not in words
    assert len(words) == 4 + 2 * 4 + 3
