"""Flags that change double arithmetic: public headers refuse them at compile time if the compiler
names them. (The evidence `filter_signs` tries the flags that compilers do not name, and runs the
rest.)"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from minkref.reports.evidence.framework.flags import REFUSED, TAKEN

ROOT = Path(__file__).resolve().parents[2]
HEADER = "reference/number/float_flags.hpp"


def compiled(flags: tuple[str, ...]) -> subprocess.CompletedProcess[str]:
    command = ["g++", "-std=c++20", "-fsyntax-only", f"-I{ROOT}", "-include", HEADER, *flags]
    return subprocess.run(
        [*command, "-x", "c++", "-"], input="", capture_output=True, text=True, check=False
    )


@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
@pytest.mark.parametrize("flags", REFUSED["g++"], ids=" ".join)
def test_unsafe_flags_are_refused_in_words(flags: tuple[str, ...]) -> None:
    done = compiled(flags)
    assert done.returncode != 0
    assert "minkref needs" in done.stderr


@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
@pytest.mark.parametrize("flags", TAKEN["g++"][:-1], ids=" ".join)
def test_flags_that_leave_doubles_alone_are_taken(flags: tuple[str, ...]) -> None:
    assert compiled(flags).returncode == 0


def test_each_header_that_counts_on_doubles_says_so() -> None:
    """The header includes the check directly, or through the header for rational numbers."""
    assert f'#include "{HEADER}"' in (ROOT / "reference/number/error_free.hpp").read_text()
    assert "float_self_test.hpp" in (ROOT / "reference/number/rational.hpp").read_text()
