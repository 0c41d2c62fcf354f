"""Degenerate families: each member keeps its family's promise, has a certificate that both checkers
follow, and has the same bytes every time. The corpus is well-formed and would be made again."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from members import assert_made_again, faults_of_spoilt, turn
from minkref import _core
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import (
    ALL_FAMILIES,
    FAMILIES,
    SOLID_FAMILIES,
    SPACE_FAMILIES,
    made_member,
)
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.make_corpus import SEED
from minkref.degeneracies.plane.case_document import content_of
from minkref.degeneracies.plane.contacts import FAMILIES as CONTACTS
from minkref.degeneracies.plane.flags import FLAGS, explained
from minkref.degeneracies.plane.outline import PLANE
from minkref.degeneracies.space.flags import FLAGS_IN_SPACE
from minkref.oracle import slow
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import THOROUGH, draws, some

OTHER_SEED = 907


def test_members_are_certified_as_expected(tmp_path: Path) -> None:
    names = turn(FAMILIES, 0, 6)
    rows = [made_member(FAMILIES[name], OTHER_SEED, 3).write(tmp_path) for name in names]
    assert not list(lint.faults(tmp_path))
    for command in (in_python(), in_cpp()):
        found = verdicts(command, [Path(str(row["certificate"])) for row in rows])
        assert [verdict.why for verdict in found if verdict.code] == []


@pytest.mark.parametrize("name", turn(FAMILIES, 1, 4))
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    folder = lint.CORPUS / name
    assert_made_again(folder, PLANE.count, lambda k: made_member(FAMILIES[name], SEED, k))


def test_the_corpus_is_in_form() -> None:
    families = sorted(lint.CORPUS.iterdir())
    for folder in [lint.CORPUS] if THOROUGH else [*families[::8], lint.CORPUS / "found"]:
        assert list(lint.faults(folder, again=False)) == []
    assert list(lint.corpus_faults()) == []
    assert len(lint.case_paths(lint.CORPUS)) >= 400
    assert sum(path.stat().st_size for path in lint.CORPUS.rglob("*.json")) < 20_000_000


def test_the_corpus_is_certified() -> None:
    files = sorted(lint.CORPUS.rglob("*.cert.json"))
    assert {verdict.code for verdict in verdicts(in_cpp(), files[:: draws(7, 1)])} == {0}
    assert {verdict.code for verdict in verdicts(in_python(), files[:: draws(60, 10)])} == {0}


def test_every_family_and_story_is_in_the_corpus() -> None:
    folders = {path.name for path in lint.CORPUS.iterdir()}
    assert folders == {*ALL_FAMILIES, "found"}
    assert len(list((lint.CORPUS / "found").glob("*.cert.json"))) == len(FOUND)


@pytest.mark.parametrize("name", [*FAMILIES, "found"])
def test_what_is_expected_is_what_the_slow_engine_finds(name: str) -> None:
    for path in some(lint.case_paths(lint.CORPUS / name), 1):
        value = json.loads(path.read_text(encoding="utf-8"))
        P, Q = (slow.operand_from_json(value[name]) for name in "PQ")
        for expected in value["expected"]:
            found = slow.minkowski_sum(P, Q, Fraction(expected["scale"]))
            assert found.digest == expected["digest"], path.stem
            assert (found.components, found.holes) == (expected["components"], expected["holes"])
            assert str(found.area) == expected["area"]
            if expected["scale"] == value["degeneracy"]["at"]:
                assert bool(found.tight) == bool(value["degeneracy"]["tight_passages"]), path.stem


def test_each_family_has_its_page_and_each_flag_its_meaning() -> None:
    pages = {path.stem for path in (lint.ROOM / "pages").glob("*.md")}
    assert set(FAMILIES) <= pages
    for family in FAMILIES.values():
        assert len(family.why) > 100 and "\n" not in family.why.replace("\n\n", "")
    assert set(FLAGS) | set(FLAGS_IN_SPACE) == set(explained())
    assert {family.name for family in CONTACTS} <= set(FAMILIES)


SEEN = {  # flags that can be read off a case file, by the rest of what it says
    "event": lambda v, told: told["events"] != [],
    "several-events": lambda v, told: len({tuple(e["at"]) for e in told["events"]}) > 1,
    "tight-passage": lambda v, told: told["tight_passages"] != [],
    "winding-zero": lambda v, told: "wound_zero_times" in told,
    "components": lambda v, told: any(e["feature"] == "component" for e in told["topology"]),
    "hole-closes": lambda v, told: "death" in changes_of_holes(told),
    "holes-merge": lambda v, told: "merge" in changes_of_holes(told),
    "scale-is-no-float": lambda v, told: (
        Fraction(float(Fraction(told["at"]))) != Fraction(told["at"])
    ),
    "vanishing-holes": lambda v, told: holes_of(v) > v["expected"][0]["holes"],
}


def changes_of_holes(told: Any) -> set[str]:
    return {e["change"] for e in told["topology"] if e["feature"] == "hole"}


def holes_of(value: Any) -> int:
    return sum(len(p["holes"]) for name in "PQ" for p in value[name]["polygons"])


def test_flags_hold_where_they_are_given_and_only_there() -> None:
    for path in lint.case_paths(lint.CORPUS):
        value = json.loads(path.read_text(encoding="utf-8"))
        if value["dimension"] == 3:  # tests/families/test_flags_in_space.py
            continue
        for flag, seen in SEEN.items():
            assert (flag in value["flags"]) == seen(value, value["degeneracy"]), (path.stem, flag)


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v["flags"].append("sparkling"), "not explained"),
        (lambda v: v.__setitem__("id", "hole-to-segment-000000000000"), "the id is not"),
        (lambda v: v["expected"][0].__setitem__("holes", 7), "not certified"),
        (lambda v: v.__setitem__("comet", 1), "unexpected"),
        (lambda v: v["P"]["polygons"][0]["outer"].reverse(), "runs"),
        (lambda v: v["P"]["polygons"][0]["outer"][0].__setitem__(0, "-999"), "id is not"),
        (lambda v: v["flags"].pop(), "flags is not what"),
        (lambda v: v["flags"].append("components"), "flags is not what"),
        (lambda v: v["expected"][0].__setitem__("area", "1"), "expected is not what"),
        (lambda v: v["expected"][0].__setitem__("vertices", 3), "expected is not what"),
        (lambda v: v["expected"][0].pop("result"), "expected is not what"),
        (lambda v: v.pop("degeneracy"), "degeneracy is missing"),
        (lambda v: v.__setitem__("licence", "Proprietary"), "licence is not what"),
        (lambda v: v.__setitem__("title", "another"), "title is not what"),
        (lambda v: v.__setitem__("source", "minkref generate nothing"), "makes nothing"),
        *(
            (
                lambda v, name=name, other=other: v["degeneracy"].__setitem__(name, other),
                f"{name} of degeneracy is not what",
            )
            for name, other in (
                ("why", "because"),
                ("events", []),
                ("topology", []),
                ("tight_passages", []),
                ("below_at_above", [[7, 7], [8, 8], [9, 9]]),
                ("varies", []),
                ("floats", []),
                ("at", "7"),
                ("wound_zero_times", ["1", "2"]),
            )
        ),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, FAMILIES["hole-to-segment"], OTHER_SEED, spoil)
    assert any(fault in line for line in found)


def test_lint_finds_what_a_certificate_leaves_out(tmp_path: Path) -> None:
    row = made_member(FAMILIES["hole-to-segment"], OTHER_SEED, 0).write(tmp_path)
    path = Path(row["certificate"])
    value = json.loads(path.read_text(encoding="utf-8"))
    value["claims"] = [claim for claim in value["claims"] if claim["claim"] == "sum"]
    path.write_text(json.dumps(value), encoding="utf-8")
    assert any("not the certificate" in line for line in lint.faults(tmp_path))


def test_lint_is_a_command(tmp_path: Path) -> None:
    row = made_member(FAMILIES["hole-to-segment"], OTHER_SEED, 0).write(tmp_path)
    assert lint.main([str(tmp_path)]) == 0
    Path(row["certificate"]).unlink()
    assert lint.main([str(tmp_path)]) == 1


def test_the_same_rings_from_other_vertices_are_the_same_case() -> None:
    square, corner = (
        [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]],
        [["5", "5"], ["6", "5"], ["5", "6"]],
    )

    def operand(*rings: list[list[str]]) -> _core.PolygonSet:
        polygons = [{"outer": ring, "holes": []} for ring in rings]
        return _core.PolygonSet.from_json(json.dumps({"polygons": polygons}))

    one = operand(square, corner)
    other = operand(corner[1:] + corner[:1], square[2:] + square[:2])
    assert content_of(one, one) == content_of(other, other) != content_of(one, operand(square))


def test_lint_wants_the_canonical_form_and_no_case_twice(tmp_path: Path) -> None:
    row = made_member(FAMILIES["hole-to-segment"], OTHER_SEED, 0).write(tmp_path)
    path = Path(row["case"])
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace(",\n", ", "), encoding="utf-8")
    path.with_name("again.json").write_text(text, encoding="utf-8")
    found = "\n".join(lint.faults(tmp_path))
    assert "not in canonical form" in found and "the operands are those of" in found


def test_the_example_reads_the_corpus_without_us(tmp_path: Path) -> None:
    """Takes a part of the corpus if few are drawn."""
    few = ("hole-to-segment", "euler-zero", "with-itself", "solids-one-line")
    names = [path.name for path in lint.CORPUS.iterdir()] if THOROUGH else few
    for name in names:
        shutil.copytree(lint.CORPUS / name, tmp_path / "all" / "corpus" / name)
    example = shutil.copy(lint.ROOM / "example.py", tmp_path / "all")
    command = [sys.executable, "-I", "-S", str(example)]
    ran = subprocess.run(command, capture_output=True, text=True)
    cases = {name: len(lint.case_paths(lint.CORPUS / name)) for name in names}
    in_space = sum(cases[name] for name in {*SPACE_FAMILIES, *SOLID_FAMILIES} & set(cases))
    assert ran.returncode == 1 and f"; {in_space} in space are left out" in ran.stdout
    assert f"{sum(cases.values()) - in_space} cases, " in ran.stdout
    assert "wrong: hole-to-segment" in ran.stdout and "wrong: euler-zero" not in ran.stdout
    folder = tmp_path / "given"
    folder.mkdir()
    assert subprocess.run([*command, str(folder)]).returncode == 2
    made_member(SPACE_FAMILIES["with-itself"], OTHER_SEED, 0).write(folder)
    assert subprocess.run([*command, str(folder)]).returncode == 2
    made_member(FAMILIES["euler-zero"], OTHER_SEED, 0).write(folder)
    assert subprocess.run([*command, str(folder)]).returncode == 0
