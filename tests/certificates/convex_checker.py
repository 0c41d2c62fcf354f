"""The checker in Python of sums of convex polyhedra, as a command."""

from __future__ import annotations

import sys

from minkref.reports.evidence.certificates.checkers import CHECKER

CONVEX = CHECKER.with_name("check_convex.py")


def in_python_of_convex() -> list[str]:
    """The file alone: no package, no site."""
    return [sys.executable, "-I", "-S", str(CONVEX)]
