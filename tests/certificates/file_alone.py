"""check.py in a folder of its own with certificates to be checked, and as a module."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from minkref.reports.evidence.certificates.checkers import CHECKER


@cache
def checker() -> ModuleType:
    """check.py as a module: a process for each of many small files is what they would cost."""
    found = importlib.util.spec_from_file_location("check", CHECKER)
    assert found is not None and found.loader is not None
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


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
