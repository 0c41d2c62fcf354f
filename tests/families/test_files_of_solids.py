"""Degenerate families of polyhedra of any shape as files: the same bytes every time, and what lint
finds in spoilt ones."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import pytest
from members import faults_of_spoilt, lines_under_two_hash_seeds
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.degeneracies.files import write_member
from minkref.degeneracies.make_corpus import COUNT_OF_SOLIDS as IN_CORPUS
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.solids.case_document import DegenerateSolids
from solid_members import SEED

CODE = f"""
import hashlib
from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.degeneracies.solids.case_document import DegenerateSolids
for name, family in sorted(SOLID_FAMILIES.items()):
    text = DegenerateSolids.of(family, {SEED}, 0).case_text
    print(name, hashlib.sha256(text.encode()).hexdigest())
"""


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    """All of them, and no more: the same bytes."""
    made = [DegenerateSolids.of(SOLID_FAMILIES[name], CORPUS_SEED, k) for k in range(IN_CORPUS)]
    texts = {f"{each.id}.json": each.case_text for each in made}
    folder = lint.CORPUS / name
    assert texts == {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir()}
    assert not list(lint.faults(folder, again=False))


def test_a_member_depends_on_seed_and_number_only(tmp_path: Path) -> None:
    found = lines_under_two_hash_seeds(CODE)
    assert len(found) == len(SOLID_FAMILIES)
    row = write_member(SOLID_FAMILIES["solids-one-line"], SEED, 0, tmp_path)
    content = Path(row["case"]).read_bytes()
    assert f"solids-one-line {hashlib.sha256(content).hexdigest()}" in found
    assert row["certificate"] is None and row["bytes"] == len(content)


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
