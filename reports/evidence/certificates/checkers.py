"""The checkers as commands, on many files at once."""

from __future__ import annotations

import re
import resource
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CHECKER = ROOT / "oracle" / "checker" / "check.py"
WORDS = {"verified": 0, "refuted": 1, "malformed": 2, "out of budget": 4, "declined": 5}
LINE = re.compile(r"^(\S.*): (verified|refuted|malformed|out of budget|declined)(?:: (.*))?$")


@dataclass(frozen=True)
class Verdict:
    code: int
    why: str


def in_python() -> list[str]:
    """The file alone: no package, no site."""
    return [sys.executable, "-I", "-S", str(CHECKER)]


def in_command() -> list[str]:
    """The command, which unpacks what is compressed."""
    return [sys.executable, "-m", "minkref", "check"]


def in_cpp() -> list[str]:
    """The C++ checker's command. Raises FileNotFoundError if not built."""
    beside = Path(sys.executable).parent / "minkref-check"
    built = ROOT / "build" / "release" / "oracle" / "checker" / "minkref-check"
    found = next((str(path) for path in (beside, built) if path.exists()), None)
    program = found or shutil.which("minkref-check")
    if program is None:
        raise FileNotFoundError("minkref-check is not built: make setup")
    return [program]


def in_proved() -> list[str]:
    """The command for the checker proved right with Coq. Raises FileNotFoundError if not built."""
    name = "minkref-check-proved"
    beside = Path(sys.executable).parent / name
    built = ROOT / "build" / "proofs" / name
    found = next((str(path) for path in (beside, built) if path.exists()), None)
    program = found or shutil.which(name)
    if program is None:
        raise FileNotFoundError(f"{name} is not built: make proofs")
    return [program]


def verdicts(command: Sequence[str], files: Sequence[Path]) -> list[Verdict]:
    """One for each file. Raises RuntimeError if the checker breaks down."""
    ran = subprocess.run([*command, *map(str, files)], capture_output=True, text=True, check=False)
    found = [match for line in ran.stdout.splitlines() if (match := LINE.match(line))]
    if ran.stderr or [match[1] for match in found] != list(map(str, files)):
        raise RuntimeError(f"{command[-1]} ended with {ran.returncode}: {ran.stderr[-400:]}")
    return [Verdict(WORDS[match[2]], match[3] or "") for match in found]


def timed(command: Sequence[str], file: Path) -> tuple[Verdict, float]:
    """The verdict, and processor seconds for the whole command, including its start."""
    began = _spent()
    (verdict,) = verdicts(command, [file])
    return verdict, _spent() - began


def _spent() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
