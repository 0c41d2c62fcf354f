"""The counts of the house, which `make lint` compares with their limits, see what they count."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any

import pytest


def _counts() -> Any:
    path = Path(__file__).resolve().parents[2] / "tools" / "scripts" / "check_counts.py"
    spec = importlib.util.spec_from_file_location("check_counts", path)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


COUNTS = _counts()
PROJECT = {"pyproject.toml": "[tool.importlinter]\ncontracts = []\n"}
LONG = "functions over 100 lines"
TWO = "files of no setting that name two"
HOOKS = "hooks for faults in reference/"
EXCEPTIONS = "exceptions to the floors"
HEADS = "sentences that begin with Of, What, That, Which, Those"
FOLDERS = "folders of code at the top"
SCHEMAS = "lines of JSON schemas written by hand"


def counted(file: str, text: str) -> dict[str, float]:
    """The counts that one file changes."""
    before, found = (COUNTS.count_rows(PROJECT | more) for more in ({}, {file: text}))
    return {name: n for name, n in found.items() if n != before[name]}


def cpp(lines: int, head: str = "void f() {") -> str:
    return "\n".join([head, *["  g();"] * (lines - 2), "}", ""])


def python(lines: int, indent: str = "") -> str:
    return indent + f"def f():\n{indent}    g()\n" + f"{indent}    g()\n" * (lines - 2)


@pytest.mark.parametrize(
    ("file", "text", "name"),
    [
        ("fuzz/a.py", python(101), LONG),
        ("fuzz/a.py", "class A:\n" + python(101, "    "), LONG),
        ("fuzz/a.py", "async " + python(101), LONG),
        ("reference/a.cpp", cpp(101), LONG),
        ("reference/a.cpp", cpp(101, "bool A::f(int x) const noexcept {"), LONG),
        ("reference/a.cpp", cpp(101, "A::A(int x)\n    : a(x),\n      b{x} {"), LONG),
        ("reference/a.hpp", cpp(101, "void f(int x,\n       int y) {"), LONG),
        ("reference/a.cpp", "if (planted(Fault::any)) return;\n", HOOKS),
        ("reference/a.cpp", '#include "plane/a.hpp"\n#include "space/b.hpp"\n', TWO),
        ("minkref/a.py", "from minkref.plane.a import b\nfrom minkref.disc.c import d\n", TWO),
        ("minkref/schemas/a.json", "{}\n", SCHEMAS),
        (
            "pyproject.toml",
            '[[tool.importlinter.contracts]]\nignore_imports = ["minkref.a -> minkref.b"]\n',
            EXCEPTIONS,
        ),
        ("fuzz/a.py", '"""Of the two sums this one is larger."""\n', HEADS),
        ("fuzz/a.py", "# Two sums meet. What they share stays here.\n", HEADS),
        ("tests/a.py", '"""Which sum comes first, nobody says."""\n', HEADS),
        ("reference/a.hpp", "/// Those sums come first, always.\n", HEADS),
        ("docs/a.md", "That sum comes first here.\n", HEADS),
    ],
)  # fmt: skip
def test_a_count_sees_one(file: str, text: str, name: str) -> None:
    assert counted(file, text).get(name) == 1


@pytest.mark.parametrize(
    ("file", "text", "name"),
    [
        ("fuzz/a.py", python(100) + python(100), LONG),
        ("tests/a.py", python(101), LONG),
        ("reference/a.cpp", cpp(100) + cpp(100), LONG),
        ("reference/a.hpp", "struct A {\n" + "  int x;\n" * 200 + "};\n" + cpp(50), LONG),
        ("reference/a.cpp", "namespace {\n" + cpp(60) + cpp(60) + "}  // namespace\n", LONG),
        (
            "reference/a.cpp",
            "struct alignas(8) A {\n" + "  int x;\n" * 200 + "};\n" + cpp(50),
            LONG,
        ),
        ("tests/a.cpp", "if (planted(Fault::any)) return;\n", HOOKS),
        ("reference/space/a.cpp", '#include "plane/a.hpp"\n#include "space/b.hpp"\n', TWO),
        ("reference/a.cpp", '#include "plane/a.hpp"\n#include "plane/b.hpp"\n', TWO),
        ("fuzz/a.py", '"""The larger of two sums, often found."""\n', HEADS),
        ("fuzz/a.py", 'text = "Of the two sums this one is larger."\n', HEADS),
        ("docs/a.md", "```\nThat sum comes first here.\n```\n", HEADS),
    ],
)
def test_a_count_sees_nothing_else(file: str, text: str, name: str) -> None:
    assert name not in counted(file, text)


def test_function_words_are_counted_per_thousand() -> None:
    found = counted("docs/a.md", "One is here. It is the sum of two sets by one.\n")
    assert found == {"function words in documents, per thousand": 556}


def test_folders_count_once() -> None:
    two = {"fuzz/a.py": "", "fuzz/b.py": "", "oracle/a.py": "", "docs/a.md": "", "a.py": ""}
    assert COUNTS.count_rows(PROJECT | two)[FOLDERS] == 2
