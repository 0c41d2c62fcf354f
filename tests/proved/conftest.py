"""The checker that is proved right. Without its executable the tests that need it are skipped, and
say so; `make proofs` builds it."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.reports.evidence.certificates.checkers import in_cpp, in_proved, in_python

Verdict = tuple[int, str]


@pytest.fixture(scope="session")
def proved() -> list[str]:
    try:
        return in_proved()
    except FileNotFoundError as error:
        pytest.skip(str(error))


@pytest.fixture
def check(proved: list[str]) -> Callable[..., Verdict]:
    """Verdict and output of the proved checker; the two others verify all that it verifies."""

    def call(path: Path, *options: str) -> Verdict:
        ran = _run(proved, path, options)
        if ran[0] == 0:
            assert _run(in_python(), path, options)[0] == 0
            assert _run(in_cpp(), path, options)[0] == 0
        return ran

    return call


@pytest.fixture
def check_value(check: Callable[..., Verdict], tmp_path: Path) -> Callable[[Any, Any], Verdict]:
    """The verdict on a certificate and a case that are given as values."""

    def call(certificate: Any, case: Any) -> Verdict:
        (tmp_path / "case.json").write_text(json.dumps(case), encoding="utf-8")
        path = tmp_path / "it.cert.json"
        path.write_text(json.dumps(certificate), encoding="utf-8")
        return check(path)

    return call


def _run(command: list[str], path: Path, options: tuple[str, ...]) -> Verdict:
    ran = subprocess.run([*command, *options, str(path)], capture_output=True, text=True)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout
