"""Both checkers, and cases to certify."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from both_checkers import CHECKER, Check, Verdict, in_cpp, run


@pytest.fixture
def check() -> Check:
    """Runs both checkers: they exit alike. What the one in Python says."""
    program = in_cpp()
    if program is None:
        pytest.fail("minkref-check is not built: make setup")

    def call(path: Path, *options: str) -> Verdict:
        python = run([sys.executable, str(CHECKER)], *options, str(path))
        cpp = run([program], *options, str(path))
        assert cpp[0] == python[0], (python[1], cpp[1])
        return python

    return call


@pytest.fixture
def check_value(check: Check, tmp_path: Path) -> Callable[[Any, Any], Verdict]:
    """The verdict on a certificate and a case that are given as values."""

    def call(certificate: Any, case: Any) -> Verdict:
        (tmp_path / "case.json").write_text(json.dumps(case), encoding="utf-8")
        path = tmp_path / "it.cert.json"
        path.write_text(json.dumps(certificate), encoding="utf-8")
        return check(path)

    return call
