"""Degenerate families of general polyhedra as files: the same bytes every time, and lint's faults
for spoilt files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from members import assert_made_again, faults_of_spoilt, turn
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import SOLID_FAMILIES, made_member
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.solids.outline import SOLIDS
from solid_members import SEED


@pytest.mark.parametrize("name", turn(SOLID_FAMILIES, 0, 2))
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    family, folder = SOLID_FAMILIES[name], lint.CORPUS / name
    assert_made_again(folder, SOLIDS.count, lambda k: made_member(family, CORPUS_SEED, k))
    assert not list(lint.faults(folder, again=False))


def test_a_member_has_no_certificate(tmp_path: Path) -> None:
    row = made_member(SOLID_FAMILIES["solids-one-line"], SEED, 0).write(tmp_path)
    assert row["certificate"] is None and row["bytes"] == Path(row["case"]).stat().st_size


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("flags"), "flags is missing"),
        (lambda v: v["flags"].append("sparkling"), "not explained"),
        (lambda v: v["flags"].pop(), "flags is not what"),
        (lambda v: v["expected"][0].__setitem__("volume", "1"), "expected is not what"),
        (lambda v: v["expected"].pop(), "not each scale"),
        (lambda v: v["scales"].pop(), "id is not"),
        (lambda v: v["P"]["faces"].pop(), "edge"),
        (lambda v: v["degeneracy"]["ties"].pop(), "ties"),
        (lambda v: v["degeneracy"]["ties"][0].__setitem__("what", "knot"), "knot"),
        (lambda v: v["degeneracy"].__setitem__("points", []), "points of degeneracy is not what"),
        (lambda v: v.__setitem__("certificate", "a.cert.json"), "have no certificates"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, SOLID_FAMILIES["solids-slot-closes"], SEED, spoil)
    assert any(fault in line for line in found), found
