"""What tests of families have in common: what a member depends on, faults of spoilt files, and
vectors of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.degeneracies import lint
from minkref.degeneracies.case_texts import canonical_text
from minkref.degeneracies.files import AnyFamily, write_member

Vector = tuple[Fraction, Fraction, Fraction]


def lines_under_two_hash_seeds(script: str) -> list[str]:
    """What a script prints, which must not depend on how Python hashes."""
    found = []
    for hash_seed in "01":
        env = {**os.environ, "PYTHONHASHSEED": hash_seed}
        ran = subprocess.run(
            [sys.executable, "-c", script], capture_output=True, text=True, env=env, check=True
        )
        found.append(ran.stdout)
    assert found[0] == found[1]
    return found[0].splitlines()


def faults_of_spoilt(
    folder: Path, family: AnyFamily, seed: int, spoil: Callable[[Any], object]
) -> list[str]:
    """What lint finds where the case file of a member is spoilt."""
    path = Path(write_member(family, seed, 0, folder)["case"])
    value = json.loads(path.read_text(encoding="utf-8"))
    spoil(value)
    path.write_text(canonical_text(value), encoding="utf-8")
    return list(lint.faults(folder))


def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a: Vector, b: Vector) -> Fraction:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
