"""Where the checkers are, and how they are run."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CHECKER = ROOT / "oracle" / "checker" / "check.py"


def in_cpp() -> str | None:
    beside = Path(sys.executable).parent / "minkref-check"
    built = ROOT / "build" / "release" / "oracle" / "checker" / "minkref-check"
    found = next((str(path) for path in (beside, built) if path.exists()), None)
    return found or shutil.which("minkref-check")


Verdict = tuple[int, str]
Check = Callable[..., Verdict]


def run(command: list[str], *arguments: str) -> Verdict:
    ran = subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)
    assert ran.stderr == "", ran.stderr
    return ran.returncode, ran.stdout
