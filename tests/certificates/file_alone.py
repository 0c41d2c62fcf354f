"""check.py in a folder of its own, and certificates to be checked there."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

from minkref.reports.evidence.certificates.checkers import CHECKER


def alone(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """In a folder that holds the file and what is to be checked, without any package."""
    if not (folder / CHECKER.name).exists():
        shutil.copy(CHECKER, folder)
    command = [sys.executable, "-I", "-S", CHECKER.name, *arguments]
    return subprocess.run(command, cwd=folder, env={}, capture_output=True, text=True, check=False)


def laid(folder: Path, case: Any, certificate: Any) -> Path:
    """The folder, with the two as case.json and it.cert.json."""
    (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")
    (folder / "it.cert.json").write_text(json.dumps(certificate), encoding="utf-8")
    return folder
