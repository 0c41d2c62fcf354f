"""Checks of the room without Coq: the part to be believed is short, and nothing is assumed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from minkref.reports.evidence.certificates.checkers import ROOT

ROOM = ROOT / "oracle" / "proved"
BELIEVED = ROOM / "definitions"
SHORT = (
    ("Definitions.v", 80),
    ("Form.v", 65),
    ("Predicates.v", 60),
    ("Moving.v", 65),
    ("Legality.v", 50),
    ("Operations.v", 20),
    ("Ways.v", 60),
    ("Space.v", 115),
)
PAGE = ROOT / "docs" / "proved.md"
NAMED = re.compile(r"\b(?:Lemma|Theorem|Corollary|Definition|Fixpoint|Inductive|Record) (\w+)")
USED = re.compile(r"^From Proved Require (?:Import|Export) ([^.]*)\.", re.MULTILINE)
GAP = re.compile(r"\b(Admitted|admit|Axiom|Parameter|Conjecture)\b")


def without_comments(path: Path) -> str:
    return re.sub(r"\(\*.*?\*\)", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)


def test_what_has_to_be_believed_is_short() -> None:
    for name, most in SHORT:
        lines = (BELIEVED / name).read_text(encoding="utf-8").splitlines()
        assert len(lines) <= most, name
        assert not re.search(r"\b(Lemma|Theorem)\b", without_comments(BELIEVED / name))


def test_nothing_is_assumed() -> None:
    files = sorted(ROOM.glob("*/*.v"))
    assert len(files) > 10
    assert [path.name for path in files if GAP.search(without_comments(path))] == []


def test_each_room_uses_only_those_above_it() -> None:
    """In the order of the room's README: what has to be believed rests on nothing else."""
    rows = re.findall(r"^\| `(\w+)/` \|", (ROOM / "README.md").read_text(encoding="utf-8"), re.M)
    assert rows[0] == "definitions" and rows[-1] == "driver"
    room_of = {path.stem: path.parent.name for path in ROOM.glob("*/*.v")}
    assert set(rows) == {*room_of.values(), "driver"}
    for path in ROOM.glob("*/*.v"):
        for names in re.findall(USED, without_comments(path)):
            for name in names.split():
                above = rows.index(room_of[name]) <= rows.index(room_of[path.stem])
                assert above, f"{path.name} uses {name}"


def test_files_are_short() -> None:
    for path in [*ROOM.glob("*/*.v"), *(ROOM / "driver").glob("*.ml")]:
        lines = path.read_text(encoding="utf-8").splitlines()
        assert len(lines) < 400 and max(map(len, lines)) <= 100, path.name


def test_the_page_names_what_is_there() -> None:
    """Each name in a code span of the page with an underscore is one of the room, or
    what Coq computes by."""
    there = set(re.findall(NAMED, "".join(map(without_comments, ROOM.glob("*/*.v")))))
    named = set(re.findall(r"`([a-z][a-z0-9]*(?:_[a-z0-9]+)+)`", PAGE.read_text(encoding="utf-8")))
    assert len(named) >= 15
    assert named - {"vm_compute"} <= there, named - there


def test_all_files_are_compiled() -> None:
    script = (ROOT / "tools" / "scripts" / "proofs.sh").read_text(encoding="utf-8")
    assert "cp oracle/proved/*/*.v build/proofs/" in script
    names = [path.stem for path in ROOM.glob("*/*.v")]
    assert len(names) == len(set(names)), "two files of one name in one folder"
    (programs,) = re.findall(r"^programs=\(([^)]*)\)", script, re.MULTILINE)
    written = {path.stem for path in (ROOM / "driver").glob("*.ml")}
    assert set(programs.split()) == written | {"checker"}


@pytest.mark.parametrize(
    ("file", "least"),
    [("theory/Paper.v", 10), ("uniqueness/OneForm.v", 7), ("verified/Statement.v", 3)],
)
def test_each_statement_of_a_page_is_proved_or_refuted(file: str, least: int) -> None:
    """And `make proofs` prints what each rests on."""
    page = without_comments(ROOM / file)
    assert not re.search(r"\b(Lemma|Theorem)\b", page)
    lines = len((ROOM / file).read_text(encoding="utf-8").splitlines())
    assert f"`oracle/proved/{file}`, of {lines} lines" in PAGE.read_text(encoding="utf-8")
    stated = re.findall(r"^Definition (\w+) : Prop :=", page, re.MULTILINE)
    assert len(stated) >= least
    proofs = "".join(without_comments(path) for path in ROOM.glob("*/*.v"))
    printed = without_comments(ROOM / "claims" / "Axioms.v")
    for name in stated:
        signs = {f"{name}_holds": "", f"{name}_fails": "~ "}
        found = [it for it, sign in signs.items() if f"Theorem {it} : {sign}{name}." in proofs]
        assert len(found) == 1, name
        assert f"Print Assumptions {found[0]}." in printed, name
        assert f"`{name}`" in PAGE.read_text(encoding="utf-8"), name


def test_each_theorem_that_the_page_names_first_is_printed() -> None:
    """`make proofs` looks at the assumptions of each theorem in a table on the page."""
    printed = without_comments(ROOM / "claims" / "Axioms.v")
    told = re.findall(r"^\| `(\w+_is_right)` \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(told) >= 7
    others = ("sum_is_union", "membership_is_decided", "legality_is_decided", "forms_agree")
    for name in (*told, *others, "gap_separation"):
        assert f"Print Assumptions {name}." in printed, name
