"""Unions: both checkers agree about changed certificates and cases; reference and plain fractions
confirm all verified claims."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import touching
from minkref import _core
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.plane.certified_unions import UnionConfirmation
from minkref.fuzz.unions.union_cases import drawn_union
from minkref.oracle.checker import check as checker
from replacing import Change, Value, changed, replaced, sample, verdicts_on
from thoroughness import draws

MANY, FEW = 300, 12
SLOW = 120  # edges, from which on a check takes seconds


def made(*sets: _core.PolygonSet) -> UnionCertificate:
    """By the producer, with claims of all kinds."""
    certificate = UnionCertificate(sets)
    certificate.union()
    certificate.degeneracies()
    certificate.signs()
    for point in (("0", "0"), ("1/2", "1/3")):
        certificate.point(point)
    return certificate


def drawn(index: int) -> tuple[_core.PolygonSet, ...]:
    case = drawn_union(CaseName(f"union:7:{index}", "union"), "union", 7, index)
    return case.sets


def by_producer(*sets: _core.PolygonSet) -> Change:
    certificate = made(*sets)
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def of_json(value: Value) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(json.dumps(value))


GIVEN: dict[str, Change] = {
    "by hand": (touching.certificate(), touching.CASE),
    "the same, made": by_producer(*map(of_json, touching.SETS)),
    "a fan of triangles": by_producer(*drawn(39)),
}


def changes(certificate: Value, case: Value) -> Iterator[Change]:
    """Changes the certificate, and the case with its old digest and with its new one."""
    for value in changed(certificate):
        yield value, case
    for value in changed(case):
        yield certificate, value
        try:
            digest = touching.digest_of_case(value)
        except (KeyError, TypeError, ValueError, AttributeError):
            continue
        yield replaced(certificate, ("case", "sha256"), digest), value


def is_true(certificate: Value, case: Value) -> bool:
    """Certificates use winding numbers alone; sets that validation refuses are ignored."""
    try:
        return UnionConfirmation(json.dumps(case)).all_hold(certificate["claims"])
    except _core.BadInput:
        return case is not touching.CASE


@pytest.mark.parametrize("name", GIVEN)
def test_every_change_is_refused_or_true(tmp_path: Path, name: str) -> None:
    certificate, case = GIVEN[name]
    given = sample(changes(certificate, case))
    codes = verdicts_on(tmp_path, [(certificate, case), *given])
    assert codes[0] == 0
    assert UnionConfirmation(json.dumps(case)).all_hold(certificate["claims"])
    held = [one for one, code in zip(given, codes[1:], strict=True) if code == 0]
    for one in held:
        assert is_true(*one), one
    assert len(held) < len(given) / 3


def test_unions_of_all_kinds_are_proven(tmp_path: Path) -> None:
    """Degenerate sets, any sets, placed sums: both checkers verify."""
    given: list[tuple[Any, Any]] = []
    for index in range(draws(FEW, MANY)):
        sets = drawn(index)
        if sum(one.vertices for one in sets) <= SLOW:
            given.append(by_producer(*sets))
    assert set(verdicts_on(tmp_path, given)) == {0}
    for certificate, case in given[:FEW]:
        assert UnionConfirmation(json.dumps(case)).all_hold(certificate["claims"])


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (lambda v: v["claims"].append({"claim": "sum"}), "there is no claim 'sum'"),
        (lambda v: v["claims"].append(v["claims"][0]), "made twice"),
        (lambda v: v.update(claims=[]), "nothing is claimed"),
        (lambda v: v.update(steps=[]), "more members"),
        (lambda v: v["claims"][1].update(vertices=[]), "one set, or none"),
        (lambda v: v["claims"][1].update(edges=[[0, 1], [0, 1]]), "named twice"),
        (lambda v: v["claims"][1].update(edges=[[0, 9]]), "no number 9"),
        (lambda v: v["claims"][1].update(edges=[[0, 0]]), "does not pass"),
        (lambda v: v["claims"][3].update(way=1), "the other way"),
        (lambda v: v["claims"][3].update(edges=[[0, 1], [0, 1]]), "one set is named"),
        (lambda v: v["claims"][3].update(edges=[[0, 3], [1, 3]]), "on two lines"),
        (lambda v: v["claims"][4].update(inside=[0, 1]), "have it inside"),
        (lambda v: v["claims"][5].update(on=[0]), "pass the point"),
        (lambda v: v["claims"][7].update(sign=0), "another sign"),
        (lambda v: v["claims"][0]["polygons"].pop(), "the sides differ"),
        (lambda v: v["claims"][0]["polygons"][0]["outer"].reverse(), "the sides differ"),
        (lambda v: v["claims"][0]["polygons"].append(v["claims"][0]["polygons"][0]), "differ"),
    ],
)
def test_each_rule_is_demanded(tmp_path: Path, spoil: Any, why: str) -> None:
    value = touching.certificate()
    spoil(value)
    (tmp_path / "case.json").write_text(json.dumps(touching.CASE), encoding="utf-8")
    file = tmp_path / "it.cert.json"
    file.write_text(json.dumps(value), encoding="utf-8")
    code, told, _ = checker.verdict(file, None, (60, 1e9, 1e9), checker.FILES)
    assert code in (1, 2) and why in told, told


def test_a_point_or_a_segment_is_refused() -> None:
    with pytest.raises(Exception, match="no interior"):
        UnionCertificate([of_json(touching.polygons(touching.points("0 0", "1 1")))])
