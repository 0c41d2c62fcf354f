"""The checker that is proved in Coq (docs/proved.md), as `make proofs` builds it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from minkref import proved_program
from minkref.proved_program import PROGRAM

WORDS = {0: "verified", 1: "refuted", 2: "malformed", 4: "out of budget", 5: "declined"}
DECLINED = 5


@dataclass(frozen=True)
class Proof:
    """The answer on one certificate: a word, why, and what is proved."""

    word: str
    why: str
    proved: list[str]


def follow(path: Path, *options: str) -> Proof:
    """Runs it on a certificate; its answer is JSON, where no name or claim can look like a verdict.
    Raises RuntimeError where it breaks down."""
    ran = proved_program.run([proved_program.program(), "--json", *options, "--", str(path)])
    if ran.returncode < 0:  # no memory is left, usually; the files after this one are checked
        return Proof("out of budget", f"a signal ended {PROGRAM}: {-ran.returncode}", [])
    try:
        (line,) = ran.stdout.splitlines()
        told = json.loads(line)
        found = Proof(told["verdict"], told["why"], told["proved"])
    except (ValueError, TypeError, KeyError):
        found = None
    if found is None or WORDS.get(ran.returncode) != found.word:
        raise RuntimeError(f"{PROGRAM} ended with {ran.returncode}: {ran.stderr[-400:]!r}")
    return found
