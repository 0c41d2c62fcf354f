"""The checker in Python copied to an empty folder; false certificates written by hand."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.certified_cases import cases, written
from minkref.reports.evidence.certificates.checkers import CHECKER
from minkref.reports.evidence.framework.command import tests_pass
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 0.4, 0.5)

SEED = 1201
FALSE = "tests/certificates/test_false_certificates.py"
BY_ITSELF = "tests/certificates/test_the_file_alone.py"


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(CHECKER, folder)
        case = next(case for case in cases(SEED, ("holes",)))
        certificate = Certificate(case.P, case.Q)
        certificate.sum(case.scale, passages=True)
        dynamic = _core.DynamicSum(case.P, case.Q)
        certificate.degeneracy(dynamic.event_scales()[0][0])
        file = written(certificate, folder, "it")
        _follow(findings, "a true one", folder, file.name, 0)
        text = (folder / "it.case.json").read_text(encoding="utf-8")
        changed = re.sub(
            r'(\[")(-?\d+)', lambda found: f"{found[1]}{int(found[2]) + 1}", text, count=1
        )
        (folder / "it.case.json").write_text(changed, encoding="utf-8")
        _follow(findings, "a case that was changed", folder, file.name, 1)
        (folder / "it.case.json").unlink()
        _follow(findings, "a case that is missing", folder, file.name, 2)
    for what, path in (("false certificates by hand", FALSE), ("the file alone", BY_ITSELF)):
        tests_pass(findings, f"{what}: pytest {path}", path)


def _follow(findings: Findings, what: str, folder: Path, file: str, wanted: int) -> None:
    """As a stranger does who has Python and nothing else."""
    command = [sys.executable, "-I", "-S", "check.py", file]
    ran = subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True)
    findings.law(f"check.py alone, {what}: exit code", ran.returncode == wanted, wanted,
                 f"{ran.returncode} {ran.stderr[-100:]}".strip())  # fmt: skip
