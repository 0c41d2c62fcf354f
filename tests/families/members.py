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
    running = [
        subprocess.Popen(
            [sys.executable, "-c", script],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": hash_seed},
        )
        for hash_seed in "01"
    ]
    ran = [(*each.communicate(), each.returncode) for each in running]
    assert [code for *_, code in ran] == [0, 0], ran
    assert ran[0][0] == ran[1][0]
    return ran[0][0].splitlines()


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
