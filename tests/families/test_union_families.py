"""Degenerate unions: members keep their families' promises, by plain fractions; certificates prove
expected results."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from members import assert_made_again, faults_of_spoilt
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import ALL_FAMILIES, UNION_FAMILIES, made_member
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.unions.outline import UNIONS
from minkref.fuzz.geometry.plane import Shape, edges, in_box, read_shape, turn
from minkref.fuzz.unions.side_check import wrong_side
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts

SEED = 31


def cases(name: str) -> list[Path]:
    """The family's case files of the corpus."""
    files = (UNIONS.corpus / name).iterdir()
    return sorted(file for file in files if not file.name.endswith(".cert.json"))


def shapes(value: dict[str, Any]) -> list[Shape]:
    return [read_shape(json.dumps(one)) for one in value["sets"]]


@pytest.mark.parametrize("name", UNION_FAMILIES)
def test_points_of_a_case_are_where_sets_meet(name: str) -> None:
    """Vertices or edges meet from two sets, never two edges alone."""
    for file in cases(name):
        value = json.loads(file.read_text(encoding="utf-8"))
        sets = [edges(shape) for shape in shapes(value)]
        for x, y in value["degeneracy"]["points"]:
            p = Fraction(x), Fraction(y)
            ends = [any(p == a for a, _ in one) for one in sets]
            inside = [
                sum(turn(a, b, p) == 0 and in_box(a, b, p) and p not in (a, b) for a, b in one)
                for one in sets
            ]
            met = [k for k, _ in enumerate(sets) if ends[k] or inside[k]]
            assert len(met) > 1 and (any(ends) or sum(inside) > 2), (file.name, x, y)
        assert value["degeneracy"]["points"] or name == "union-signs"


@pytest.mark.parametrize("name", UNION_FAMILIES)
def test_claimed_unions_are_right_edge_by_edge(name: str) -> None:
    """In plain fractions, with none of our code for unions."""
    for file in cases(name):
        value = json.loads(file.read_text(encoding="utf-8"))
        text = file.with_name(value["certificate"]).read_text(encoding="utf-8")
        claims = {claim["claim"]: claim for claim in json.loads(text)["claims"]}
        region = read_shape(json.dumps({"polygons": claims["union"]["polygons"]}))
        assert wrong_side(shapes(value), region) is None
        wanted = {"union-seams": "overlap", "union-signs": "sign"}.get(name, "meet")
        assert wanted in claims, name


def test_both_checkers_verify_the_corpus() -> None:
    certificates = sorted(UNIONS.corpus.glob("*/*.cert.json"))
    assert len(certificates) == UNIONS.count * len(UNION_FAMILIES)
    for command in (in_python(), in_cpp()):
        assert {verdict.code for verdict in verdicts(command, certificates)} == {0}


@pytest.mark.parametrize("name", UNION_FAMILIES)
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    family, folder = UNION_FAMILIES[name], UNIONS.corpus / name
    assert_made_again(folder, UNIONS.count, lambda k: made_member(family, CORPUS_SEED, k))


def test_the_corpus_is_in_form() -> None:
    assert not list(lint.faults(UNIONS.corpus, again=False))
    assert {path.name for path in UNIONS.corpus.iterdir()} == set(UNION_FAMILIES)
    assert not set(UNION_FAMILIES) & set(ALL_FAMILIES)


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("sets"), "'sets' is a required property"),
        (lambda v: v["expected"].__setitem__("digest", "0" * 64), "the union is not claimed"),
        (lambda v: v["sets"].pop(), "the certificate of another case"),
        (lambda v: v["degeneracy"].__setitem__("points", []), "degeneracy is not what"),
        (lambda v: v["sets"][0]["polygons"][0]["outer"].reverse(), "orientation"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, UNION_FAMILIES["union-common-point"], SEED, spoil)
    assert any(fault in line for line in found), found
