"""Claims about paths and traps, proved; what is false of them is refuted, and no changed
certificate is proved that `check.py` refutes."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import walls
from minkref.reports.evidence.certificates.checkers import ROOT, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import mutants

VERIFIED, REFUTED, MALFORMED = 0, 1, 2
SEED = 7
BY_HAND = [
    (walls.certificate, walls.CASE, "valid: of (0, infinity), contact allowed: (0, 1/3], [2, 2],"),
    (walls.room, walls.ROOM_CASE, "trap: of (0, infinity), contact allowed: (1, 4]"),
    (walls.door, walls.DOOR_CASE, "escapes: at (0, 1), contact forbidden"),
]
CORPUS = ROOT / "degeneracies" / "motion" / "corpus"


@pytest.mark.parametrize(("made", "case", "told"), BY_HAND)
def test_certificates_by_hand(check_value: Any, made: Any, case: Any, told: str) -> None:
    code, said = check_value(made(), case)
    assert code == VERIFIED and told in said, said
    assert said.count("contact") == len(made()["claims"])


def test_certificates_of_the_corpus(proved: list[str]) -> None:
    files = sorted(CORPUS.rglob("*.cert.json"))
    found = verdicts(proved, files)
    assert len(files) > 10 and [one.why for one in found if one.code != VERIFIED] == []


def _other_place(case: Any) -> Any:
    other = {**case, "path": [["5", "2"]]}
    return other, {"path": "case.json", "sha256": walls.digest_of_case(other)}


@pytest.mark.parametrize(
    ("made", "case", "path", "other"),
    [
        # the part collides a little above 1/3, and not at 2
        (walls.certificate, walls.CASE, ("claims", 5, "valid", 0, "to"), "1/2"),
        (walls.certificate, walls.CASE, ("claims", 5, "valid", 1, "to"), "5/2"),
        (walls.certificate, walls.CASE, ("claims", 1, "hits", 0, "points", 1, 2, 0), "7/2"),
        (walls.certificate, walls.CASE, ("steps", 2, "normals", 0), [1, 0]),
        (walls.certificate, walls.CASE, ("steps", 3, "codes", 0), [-2, 0, 0]),
        # a ring that does not lead around the place, and one that leaves the walls
        (walls.room, walls.ROOM_CASE, ("claims", 1, "ring", 3), ["9/2", "0", "4", "0"]),
        (walls.room, walls.ROOM_CASE, ("claims", 1, "ring", 3), ["1", "0", "2", "0"]),
        (walls.room, walls.ROOM_CASE, ("claims", 1, "ring", 0, 1), "1"),
        (walls.room, walls.ROOM_CASE, ("claims", 3, "trapped"), []),
        # a way that ends at the door, and a way back
        (walls.room, walls.ROOM_CASE, ("steps", 2, "path", 1, 0), "4"),
        (walls.room, walls.ROOM_CASE, ("claims", 0, "normal"), [-1, 0]),
        (walls.door, walls.DOOR_CASE, ("steps", 2, "path", 2, 3), "-2/5"),
        (walls.door, walls.DOOR_CASE, ("steps", 2, "scales", "to_in"), True),
    ],
)
def test_what_is_false_is_refuted(
    check_value: Any, made: Callable[[], Any], case: Any, path: tuple[Any, ...], other: Any
) -> None:
    value = made()
    at = value
    for name in path[:-1]:
        at = at[name]
    at[path[-1]] = other
    assert check_value(value, case)[0] == REFUTED


def test_a_trap_is_of_its_place(check_value: Any) -> None:
    """Outside the room, in the door: the same steps say nothing."""
    value = walls.room()
    case, value["case"] = _other_place(walls.ROOM_CASE)
    assert check_value(value, case)[0] == REFUTED


@pytest.mark.parametrize(("made", "case", "_told"), BY_HAND)
def test_no_mutant_is_proved_that_is_refuted(
    proved: list[str], tmp_path: Path, made: Any, case: Any, _told: str
) -> None:
    (tmp_path / "case.json").write_text(json.dumps(case), encoding="utf-8")
    files = []
    for number, mutant in enumerate(mutants(made(), 1, random.Random(SEED))):
        files.append(tmp_path / f"{number}.cert.json")
        files[-1].write_text(json.dumps(mutant.value), encoding="utf-8")
    ours, theirs = verdicts(proved, files), verdicts(in_python(), files)
    assert len(files) > 50 and any(one.code == REFUTED for one in ours)
    told = [
        (file.read_text(encoding="utf-8"), other.why)
        for file, one, other in zip(files, ours, theirs, strict=True)
        if one.code == VERIFIED and other.code != VERIFIED
    ]
    assert told == [], f"seed {SEED}"
