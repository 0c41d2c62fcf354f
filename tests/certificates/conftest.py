"""Both checkers, and cases to certify."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python

Verdict = tuple[int, str]
Check = Callable[..., Verdict]
CheckValue = Callable[[Any, Any], Verdict]


def run(command: list[str], *arguments: str) -> Verdict:
    ran = subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout


def both(in_python: list[str], path: Path, *options: str) -> Verdict:
    python = run(in_python, *options, str(path))
    cpp = run(in_cpp(), *options, str(path))
    assert cpp[0] == python[0], (python[1], cpp[1])
    return python


@pytest.fixture
def check() -> Check:
    """Runs both checkers: they exit alike. What the one in Python says."""
    return lambda path, *options: both(in_python(), path, *options)


@pytest.fixture
def check_value(check: Check, tmp_path: Path) -> CheckValue:
    """The verdict on a certificate and a case that are given as values."""

    def call(certificate: Any, case: Any) -> Verdict:
        (tmp_path / "case.json").write_text(json.dumps(case), encoding="utf-8")
        path = tmp_path / "it.cert.json"
        path.write_text(json.dumps(certificate), encoding="utf-8")
        return check(path)

    return call


@pytest.fixture
def expect_refused(check_value: CheckValue) -> Callable[..., None]:
    """That a certificate, spoilt in a way, is refused with this code, and why is said."""

    def expect(value: Any, case: Any, spoil: Callable[[Any], object], code: int, why: str) -> None:
        spoil(value)
        got, said = check_value(value, case)
        assert got == code, said
        assert why in said and len(said) < 2000

    return expect
