"""Degenerate families: each member has what its family promises, a certificate that both checkers
follow, and the same bytes every time. The corpus is in form, and is what would be made again."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.degeneracies import lint
from minkref.degeneracies.case_document import Degenerate, canonical_text
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.files import write_member
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.make_corpus import SEED
from minkref.degeneracies.plane.contacts import FAMILIES as CONTACTS
from minkref.oracle import slow
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts

OTHER_SEED = 907


@pytest.mark.parametrize("name", FAMILIES)
def test_a_member_is_certified_as_expected(tmp_path: Path, name: str) -> None:
    row = write_member(FAMILIES[name], OTHER_SEED, 3, tmp_path)
    assert not [fault for fault in lint.faults(tmp_path) if not fault.startswith("flags.json")]
    certificate = Path(row["certificate"])
    for command in (in_python(), in_cpp()):
        (verdict,) = verdicts(command, [certificate])
        assert verdict.code == 0, verdict.why


@pytest.mark.parametrize("name", FAMILIES)
def test_a_member_of_the_corpus_is_made_again(name: str) -> None:
    made = Degenerate.of(FAMILIES[name], SEED, 0)
    folder = lint.CORPUS / name
    assert made.case_text == (folder / f"{made.id}.json").read_text(encoding="utf-8")
    text = (folder / f"{made.id}.cert.json").read_text(encoding="utf-8")
    assert made.certificate_text == text


def test_the_corpus_is_in_form() -> None:
    assert list(lint.faults()) == []
    assert len(lint.case_paths(lint.CORPUS)) >= 400
    assert sum(path.stat().st_size for path in lint.CORPUS.rglob("*.json")) < 20_000_000


def test_the_corpus_is_certified() -> None:
    files = sorted(lint.CORPUS.rglob("*.cert.json"))
    assert {verdict.code for verdict in verdicts(in_cpp(), files)} == {0}
    assert {verdict.code for verdict in verdicts(in_python(), files[::10])} == {0}


def test_every_family_and_story_is_in_the_corpus() -> None:
    folders = {path.name for path in lint.CORPUS.iterdir()}
    assert folders == {*FAMILIES, "found"}
    assert len(list((lint.CORPUS / "found").glob("*.cert.json"))) == len(FOUND)


@pytest.mark.parametrize("path", lint.case_paths(lint.CORPUS)[::40], ids=lambda path: path.stem)
def test_what_is_expected_is_what_the_slow_engine_finds(path: Path) -> None:
    value = json.loads(path.read_text(encoding="utf-8"))
    P, Q = (slow.operand_from_json(value[name]) for name in "PQ")
    for expected in value["expected"][:3]:
        found = slow.minkowski_sum(P, Q, Fraction(expected["scale"]))
        assert found.digest == expected["digest"]
        assert (found.components, found.holes) == (expected["components"], expected["holes"])
        assert str(found.area) == expected["area"]


def test_each_family_has_its_page_and_known_flags() -> None:
    known = lint.flags()
    pages = {path.stem for path in (lint.ROOM / "pages").glob("*.md")}
    assert set(FAMILIES) <= pages
    for family in FAMILIES.values():
        assert len(family.why) > 100 and set(family.flags) <= set(known)
    assert {family.name for family in CONTACTS} <= set(FAMILIES)


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v["flags"].append("sparkling"), "not explained"),
        (lambda v: v.__setitem__("id", "hole-to-segment-000000000000"), "the id is not"),
        (lambda v: v["expected"][0].__setitem__("holes", 7), "not certified"),
        (lambda v: v.__setitem__("comet", 1), "unexpected"),
        (lambda v: v["P"]["polygons"][0]["outer"].reverse(), "id is not"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    row = write_member(FAMILIES["hole-to-segment"], OTHER_SEED, 0, tmp_path)
    path = Path(row["case"])
    value = json.loads(path.read_text(encoding="utf-8"))
    spoil(value)
    path.write_text(canonical_text(value), encoding="utf-8")
    assert any(fault in line for line in lint.faults(tmp_path))


def test_lint_wants_the_canonical_form_and_no_case_twice(tmp_path: Path) -> None:
    row = write_member(FAMILIES["hole-to-segment"], OTHER_SEED, 0, tmp_path)
    path = Path(row["case"])
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace(",\n", ", "), encoding="utf-8")
    path.with_name("again.json").write_text(text, encoding="utf-8")
    found = "\n".join(lint.faults(tmp_path))
    assert "not in canonical form" in found and "the operands are those of" in found


def test_the_example_reads_the_corpus_without_us() -> None:
    command = [sys.executable, "-I", "-S", str(lint.ROOM / "example.py")]
    ran = subprocess.run(command, capture_output=True, text=True, check=True)
    cases = len(lint.case_paths(lint.CORPUS))
    assert f"{cases} cases, " in ran.stdout and "wrong: euler-zero" not in ran.stdout
    assert "wrong: hole-to-segment" in ran.stdout
