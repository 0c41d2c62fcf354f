"""Both checkers, and cases to certify."""

from __future__ import annotations

import io
import json
import subprocess
import sys
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import pytest
from file_alone import checker
from minkref.reports.evidence.certificates.checkers import in_cpp

Verdict = tuple[int, str]
Check = Callable[..., Verdict]
CheckValue = Callable[[Any, Any], Verdict]


def in_cpp_of(*arguments: str) -> Verdict:
    ran = subprocess.run([*in_cpp(), *arguments], capture_output=True, text=True, check=False)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout


def in_python_of(*arguments: str) -> Verdict:
    """In this process; as a file alone: tests/certificates/file_alone.py."""
    most_digits = sys.get_int_max_str_digits()
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        try:
            code = checker().main(list(arguments))
        finally:
            sys.set_int_max_str_digits(most_digits)
    assert err.getvalue() == "", err.getvalue()
    return code, out.getvalue()


@pytest.fixture
def check() -> Check:
    """Runs both checkers, which must exit alike; gives the verdict of the Python checker."""

    def call(path: Path, *options: str) -> Verdict:
        python, cpp = (run(*options, str(path)) for run in (in_python_of, in_cpp_of))
        assert cpp[0] == python[0], (python[1], cpp[1])
        return python

    return call


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
    """Asserts that a spoilt certificate is refused with this code, and that the reason is said."""

    def expect(value: Any, case: Any, spoil: Callable[[Any], object], code: int, why: str) -> None:
        spoil(value)
        got, said = check_value(value, case)
        assert got == code, said
        assert why in said and len(said) < 2000

    return expect
