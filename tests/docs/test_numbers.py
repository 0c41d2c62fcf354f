"""Numbers on the pages agree with the project."""

from __future__ import annotations

import re
from pathlib import Path

from minkref.output.exits import MEANINGS
from minkref.strategies import DEGENERATE_FAMILIES

ROOT = Path(__file__).resolve().parents[2]


def text(name: str) -> str:
    return " ".join((ROOT / name).read_text(encoding="utf-8").split())


def test_families_of_the_strategies() -> None:
    found = re.search(
        r"`degenerate_pairs\(\)` sees some (\d+) of the (\d+)", text("docs/strategies.md")
    )
    assert found and int(found[2]) == len(DEGENERATE_FAMILIES) > int(found[1])


def test_lines_of_a_program_that_is_an_adapter() -> None:
    templates = (ROOT / "fuzz/adapters/templates").glob("template.*")
    # The C template is a library function, no program.
    lines = [len(t.read_text().splitlines()) for t in templates if t.suffix != ".c"]
    assert f"a program of {min(lines)} to {max(lines)} lines" in text("README.md")


def test_exit_codes_of_the_help_and_of_the_page() -> None:
    page = (ROOT / "docs/command-line.md").read_text(encoding="utf-8")
    table = page.partition("## Exit codes")[2].partition("\n## ")[0]
    listed = [int(code) for code in re.findall(r"^\| (\d+) \|", table, re.MULTILINE)]
    assert listed == [int(code) for code in MEANINGS]
