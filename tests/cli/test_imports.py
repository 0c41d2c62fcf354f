"""A command imports only the modules that it uses: each start pays for shared imports."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

TOLD = """
import sys
from minkref.cli.cli import main
try:
    main()
finally:
    sys.stderr.write("".join(f"{name}\\n" for name in sys.modules))
"""
#: Modules that a start without work must not import.
HEAVY = ("jinja2", "jsonschema", "matplotlib", "minkref.degeneracies", "minkref.fuzz",
         "minkref.reports", "msgspec", "multiprocessing", "numpy", "plotly", "pyarrow",
         "sympy")  # fmt: skip


def modules(*arguments: str) -> set[str]:
    ran = subprocess.run(
        [sys.executable, "-c", TOLD, *arguments], capture_output=True, text=True, timeout=60
    )
    assert ran.returncode == 0, ran.stderr
    return set(ran.stderr.splitlines())


def commands(names: set[str]) -> set[str]:
    """Modules and pages of single commands, in the plane and in space."""
    shared = ("minkref.cli", "minkref.verbs.lists", "minkref.schemas")
    return {
        name for name in names if name.startswith("minkref.verbs.") and not name.startswith(shared)
    }


def heavy(names: set[str]) -> set[str]:
    return {name for name in names if any(f"{name}.".startswith(f"{h}.") for h in HEAVY)}


@pytest.mark.parametrize("asked", ["--version", "--help"])
def test_no_command_is_imported_to_tell_of_all(asked: str) -> None:
    imported = modules(asked)
    assert not commands(imported)
    assert not heavy(imported)


def test_nothing_draws_to_print_the_version() -> None:
    assert not {"rich", "rich.console", "pydantic"} & modules("--version")


def test_a_sum_imports_no_other_command_and_nothing_that_it_does_not_use(tmp_path: Path) -> None:
    operand = tmp_path / "P.wkt"
    operand.write_text("POLYGON((0 0, 2 0, 0 2, 0 0))", encoding="utf-8")
    imported = modules("sum", str(operand), str(operand), "--json")
    assert commands(imported) <= {"minkref.verbs.sum", "minkref.plane.commands.sum_table"}
    assert not heavy(imported)
    assert "rich.progress" not in imported
