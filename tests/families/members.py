"""Helpers for tests of families: members made again or by other processes, faults of spoilt files,
and separate vector functions."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

from minkref.degeneracies.case_texts import canonical_text
from minkref.degeneracies.catalogue import (
    DISC_FAMILIES,
    PATH_FAMILIES,
    SOLID_FAMILIES,
    SPACE_FAMILIES,
    UNION_FAMILIES,
    made_member,
)
from minkref.degeneracies.files import Made
from minkref.degeneracies.invalid.catalogue import (
    INVALID_FAMILIES,
    INVALID_MESH_FAMILIES,
    invalid_member,
)
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.random_pairs import Pair
from thoroughness import THOROUGH, draws

Vector = tuple[Fraction, Fraction, Fraction]
Value = TypeVar("Value")
LARGE = {"invalid-too-many-vertices", "invalid-too-many-digits"}  # some seconds each


def turn(values: Iterable[Value], place: int, laws: int) -> list[Value]:
    """The values for one of several laws, which take turns; all values for a thorough run."""
    return list(values) if THOROUGH else list(values)[place::laws]


def text_of(pair: Pair) -> str:
    return f"{pair.P} {pair.Q} {pair.scale}\n"


#: For each group: its families, those that other processes make, how many members of each family,
#: and the function that makes a member from its number.
GROUPS: dict[
    str, tuple[Mapping[str, Any], list[str], int, Callable[[Any, int, int], object]]
] = {
    "space": (SPACE_FAMILIES, turn(SPACE_FAMILIES, 1, 6), draws(1, 3), made_member),
    "solids": (SOLID_FAMILIES, turn(SOLID_FAMILIES, 1, 8), 1, made_member),
    "disc": (DISC_FAMILIES, turn(DISC_FAMILIES, 1, 6), 1, made_member),
    "paths": (PATH_FAMILIES, turn(PATH_FAMILIES, 1, 4), 1, made_member),
    "unions": (UNION_FAMILIES, turn(UNION_FAMILIES, 1, 4), 1, made_member),
    "invalid": (
        INVALID_FAMILIES, [n for n in turn(INVALID_FAMILIES, 0, 5) if n not in LARGE], draws(2, 6),
        invalid_member,
    ),
    "invalid meshes": (
        INVALID_MESH_FAMILIES, turn(INVALID_MESH_FAMILIES, 0, 5), draws(2, 6), invalid_member,
    ),
    "pairs": (
        FAMILIES, turn(FAMILIES, 0, 2), draws(3, 50), lambda f, seed, k: text_of(f.pair(seed, k)),
    ),
}  # fmt: skip
SEED = 5
TELL = "import members; members.tell()"


def digest_of(group: str, name: str, seed: int = SEED) -> str:
    """Digest of the first members of a family, made in reverse order."""
    families, _, count, make = GROUPS[group]
    made = [str(make(families[name], seed, k)) for k in reversed(range(count))]
    return sha256("".join(reversed(made)).encode()).hexdigest()[:16]


def tell() -> None:
    found = {
        group: {name: digest_of(group, name) for name in reversed(names)}
        for group, (_, names, *_) in GROUPS.items()
    }
    print(json.dumps(found))


@cache
def digests() -> dict[str, dict[str, str]]:
    """Digests by group and family, from two processes with different hash seeds that must agree."""
    running = [
        subprocess.Popen(
            [sys.executable, "-c", TELL],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)},
        )
        for seed in "01"
    ]
    ran = [(*each.communicate(), each.returncode) for each in running]
    assert [code for *_, code in ran] == [0, 0], ran
    assert ran[0][0] == ran[1][0]
    found: dict[str, dict[str, str]] = json.loads(ran[0][0])
    return found


def assert_made_again(folder: Path, count: int, make: Callable[[int], Made]) -> None:
    """Asserts that the members made again have exactly the files of a corpus folder, byte for byte;
    tries one member if the run is not thorough."""
    numbers = range(count) if THOROUGH else [len(folder.name) % count]
    made = [make(k) for k in numbers]
    files = [file for one in made for file in (one.case, one.beside) if file is not None]
    stored = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert dict(files).items() <= stored.items()
    assert len(dict(files)) == len(files) and len(stored) * len(numbers) == len(files) * count


_MADE: dict[tuple[str, int], Made] = {}


def faults_of_spoilt(
    folder: Path, family: Any, seed: int, spoil: Callable[[Any], object]
) -> list[str]:
    """Faults that lint finds after the first member's case file is spoilt."""
    from minkref.degeneracies import lint  # slow to import, and not needed to make members

    if (family.name, seed) not in _MADE:
        _MADE[family.name, seed] = made_member(family, seed, 0)
    path = Path(_MADE[family.name, seed].write(folder)["case"])
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
