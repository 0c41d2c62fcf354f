"""True claims about points beside the boundary are verified; no change to a certificate makes a
checker accept a false claim."""

from __future__ import annotations

import json
import random
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.plane.families.catalogue import FAMILIES
from named_cases import named
from points_beside import certified, changed, is_true
from thoroughness import draws

SEED = 61


@pytest.mark.parametrize("family", FAMILIES)
def test_points_in_the_sum_and_points_that_are_not(check_value: Any, family: str) -> None:
    case = named(f"{family}:{SEED}:0")
    if not any(o.is_region or o.is_empty for o in (case.P, case.Q)):
        return
    dice = random.Random(SEED)
    certificate = certified(case, draws(6, 30), dice)
    code, said = check_value(*(json.loads(t) for t in (certificate.text("case.json"),
                                                       certificate.case())))  # fmt: skip
    assert code == 0, (SEED, case.name.text, said)
    assert is_true(case, certificate.claims)


SQUARE = {"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]]}]}
THIN = {
    "a segment": ([["0", "0"], ["2", "4"]], ("1", "2"), [("3", "6"), ("1", "3"), ("-1", "-2")]),
    "an upright segment": ([["1", "1"], ["1", "3"]], ("1", "3"), [("1", "4"), ("2", "2")]),
    "a point": ([["3", "1"]], ("3", "1"), [("3", "2"), ("4", "1"), ("6", "2")]),
}


@pytest.mark.parametrize("name", THIN)
def test_points_of_a_sum_with_a_segment_or_a_point(check_value: Any, name: str) -> None:
    """A point on the segment's line, beyond its ends, is not on the segment."""
    ring, on, beside = THIN[name]
    P, Q = {"polygons": [{"outer": ring, "holes": []}]}, SQUARE
    sets = [_core.PolygonSet.from_json(json.dumps(one)) for one in (P, Q)]
    for order in (sets, sets[::-1]):
        certificate = Certificate(*order)
        certificate.point("1", on)
        value, case = json.loads(certificate.text("case.json")), json.loads(certificate.case())
        assert check_value(value, case)[0] == 0
        part = "p" if order is sets else "q"
        for other in beside:
            value["claims"][0] |= {"point": other, "p": ["0", "0"], "q": ["0", "0"], part: other}
            code, said = check_value(value, case)
            assert code == 1 and "not in" in said, said


@pytest.mark.parametrize("family", ["holes", "comb", "touching", "degenerate"])
def test_no_change_makes_a_falsehood_accepted(check_value: Any, family: str) -> None:
    dice = random.Random(SEED)
    accepted = 0
    case = named(f"{family}:{SEED}:1")
    certificate = certified(case, 3, dice)
    value, of = json.loads(certificate.text("case.json")), json.loads(certificate.case())
    for other in changed(case, value, dice):
        code, said = check_value(other, of)
        assert code in (0, 1, 2), (SEED, said)
        accepted += code == 0
        if code == 0:
            assert is_true(case, other["claims"]), (SEED, case.name.text, other["claims"])
    assert accepted > 0, "a changed witness may be as good"
