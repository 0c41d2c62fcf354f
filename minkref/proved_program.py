"""The program that `make proofs` extracts from proofs in Coq (docs/proved.md): where it is, and
questions that it answers without a certificate."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.output.signals import end_with_parent, ending_in_order

PROGRAM = "minkref-check-proved"
BELIEVED = (
    "Coq's kernel and extraction, OCaml, zarith, and the definitions that docs/proved.md lists"
)
BUILT_BY = "`make proofs` in the source tree builds it (docs/proved.md)"
NO_LIMIT = ("--seconds=1e9", "--tests=1e18", "--bytes=1e18")
OUT_OF_BUDGET = 4


def found() -> str | None:
    """The executable beside the interpreter, else on the search path; None if there is none."""
    beside = Path(sys.executable).parent / PROGRAM
    return str(beside) if beside.exists() else shutil.which(PROGRAM)


def program(option: str = "--proved") -> str:
    """The executable. Refuses the option that needs it where there is none."""
    executable = found()
    if executable is None:
        raise Refusal(f"{PROGRAM} is not built", option, BUILT_BY, "not-built")
    return executable


def run(command: list[str], asked: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    """Runs the program, which ends with this process, or where this process is told to end."""
    with ending_in_order():
        return subprocess.run(
            command,
            input=asked,
            capture_output=True,
            check=False,
            preexec_fn=partial(end_with_parent, os.getpid()),
        )


def points(P: str, Q: str, scale: str | list[str], asked: Iterable[tuple[str, str]]) -> list[bool]:
    """Whether each point is in the sum of two legal operands, given as JSON, by the program that is
    proved right. Raises MemoryError, and RuntimeError where the program breaks down."""
    places = [list(point) for point in asked]
    found = _answer(P, Q, scale, "--points", places)["points"]
    if [row["point"] for row in found] != places:
        raise RuntimeError(f"{PROGRAM} answered about other points")
    return [row["in_sum"] is True for row in found]


def whole_sum(P: str, Q: str, scale: str | list[str]) -> dict[str, Any]:
    """The sum of two legal operands, not both thin: `polygons`, `components`, `holes` and `digest`,
    by a program whose answers are proved to be right. Raises as `points`."""
    return _answer(P, Q, scale, "--sum", None)


def combination(operation: str, sets: Iterable[str]) -> dict[str, Any]:
    """The union, intersection or difference of polygon sets, given as JSON: members and errors as
    of `whole_sum`."""
    question = f'{{"operation": {json.dumps(operation)}, "sets": [{", ".join(sets)}]}}'
    return _told(question, "--combination", "--proved")


def _answer(
    P: str, Q: str, scale: str | list[str], verb: str, places: list[list[str]] | None
) -> dict[str, Any]:
    asked = {} if places is None else {"points": places}
    rest = json.dumps({"scale": scale, **asked})
    question = f'{{"P": {P}, "Q": {Q}, {rest[1:]}'
    return _told(question, verb, "--route proved" if places is None else "--proved")


def _told(question: str, verb: str, asks: str) -> dict[str, Any]:
    ran = run([program(asks), verb, "--json", *NO_LIMIT, "-"], question.encode())
    if ran.returncode == OUT_OF_BUDGET or ran.returncode < 0:
        raise MemoryError(f"{PROGRAM} has no more memory")
    try:
        value: dict[str, Any] = json.loads(ran.stdout)
        whole = value["verdict"] in ("decided", "computed")
    except (ValueError, TypeError, KeyError):
        whole = False
    if not whole or ran.returncode:
        told = (ran.stdout + ran.stderr)[-400:]
        raise RuntimeError(f"{PROGRAM} ended with {ran.returncode}: {told!r}")
    return value
