"""The checker that is proved in Coq (docs/proved.md), as `make proofs` builds it."""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from minkref.errors import Refusal

PROGRAM = "minkref-check-proved"
WORDS = {0: "verified", 1: "refuted", 2: "malformed", 4: "out of budget", 5: "declined"}
DECLINED = 5


@dataclass(frozen=True)
class Proof:
    """The answer on one certificate: a word, why, and what is proved."""

    word: str
    why: str
    proved: list[str]


def program(option: str = "--proved") -> str:
    """The executable. Refuses the option that needs it where there is none."""
    beside = Path(sys.executable).parent / PROGRAM
    found = str(beside) if beside.exists() else shutil.which(PROGRAM)
    if found is None:
        mend = "`make proofs` in the source tree builds it (docs/proved.md)"
        raise Refusal(f"{PROGRAM} is not built", option, mend, "not-built")
    return found


def follow(path: Path, *options: str) -> Proof:
    """Runs it on a certificate. Raises RuntimeError where it breaks down."""
    command = [program(), *options, "--", str(path)]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    first, *rest = ran.stdout.splitlines() or [""]
    word = WORDS.get(ran.returncode)
    if word is None or f": {word}" not in first:
        told = ran.stderr[-400:].strip() or first[-400:]
        raise RuntimeError(f"{PROGRAM} ended with {ran.returncode}: {told}")
    proved = [line.strip() for line in rest]
    return Proof(word, first.rpartition(f": {word}")[2].removeprefix(": "), proved)
