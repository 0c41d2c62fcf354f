"""Claims `point` and `outside`: the proved checker takes true claims about points beside the
boundary, and no false one."""

from __future__ import annotations

import copy
import json
import random
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.plane.families.catalogue import FAMILIES
from named_cases import named
from points_beside import certified, changed, is_true

SEED = 67
VERIFIED, REFUTED = 0, 1
FRAME = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"


@pytest.mark.parametrize("family", FAMILIES)
def test_points_in_the_sum_and_points_that_are_not(check_value: Any, family: str) -> None:
    case = named(f"{family}:{SEED}:0")
    if not any(o.is_region or o.is_empty for o in (case.P, case.Q)):
        return
    certificate = certified(case, 5, random.Random(SEED), thin=False)
    value, of = json.loads(certificate.text("case.json")), json.loads(certificate.case())
    code, said = check_value(value, of)
    assert code == VERIFIED, (SEED, case.name.text, said)
    assert is_true(case, certificate.claims)


@pytest.mark.parametrize("family", ["holes", "touching"])
def test_no_change_makes_a_falsehood_accepted(check_value: Any, family: str) -> None:
    dice = random.Random(SEED)
    case = named(f"{family}:{SEED}:1")
    certificate = certified(case, 2, dice, thin=False)
    value, of = json.loads(certificate.text("case.json")), json.loads(certificate.case())
    for other in changed(case, value, dice):
        if check_value(other, of)[0] == VERIFIED:
            assert is_true(case, other["claims"]), (SEED, case.name.text, other["claims"])


@pytest.mark.parametrize("thin", ["POINT(1 1)", "LINESTRING(0 0, 1 1)", "POLYGON EMPTY"])
@pytest.mark.parametrize("first", [True, False])
def test_points_outside_of_sums_with_a_thin_operand(
    check_value: Any, thin: str, first: bool
) -> None:
    operands = [_core.read_text(text, "wkt", "a test") for text in (thin, FRAME)]
    certificate = Certificate(*(operands if first else operands[::-1]))
    assert certificate.outside("1/2", (40, "1/3")) == 0
    value, of = json.loads(certificate.text("case.json")), json.loads(certificate.case())
    code, said = check_value(value, of)
    assert (code, "is no point of the sum" in said) == (VERIFIED, True), said
    assert (value["claims"][0]["code"] == []) == ("EMPTY" in thin)
    value["claims"][0]["code"].append(0)
    value["claims"][0]["normals"] = [[1, 0]]
    assert check_value(value, of)[0] != VERIFIED


@pytest.mark.parametrize("thin", ["POINT(1 1)", "LINESTRING(0 0, 1 1)"])
@pytest.mark.parametrize("first", [True, False])
def test_points_in_sums_with_a_thin_operand(check_value: Any, thin: str, first: bool) -> None:
    """And with another p, q or point the same claim is none."""
    operands = [_core.read_text(text, "wkt", "a test") for text in (thin, FRAME)]
    certificate = Certificate(*(operands if first else operands[::-1]))
    certificate.point("1", (1, 1))
    value, of = json.loads(certificate.text("case.json")), json.loads(certificate.case())
    code, said = check_value(value, of)
    assert code == VERIFIED and "(1, 1) at 1 is a point of the sum" in said, said
    for name in ("p", "q", "point"):
        other = copy.deepcopy(value)
        other["claims"][0][name] = ["9", "9"]
        assert check_value(other, of)[0] == REFUTED, name
