"""True claims about points beside the boundary are verified; no change to a certificate makes a
checker accept a false claim."""

from __future__ import annotations

import json
import random
from typing import Any

import pytest
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
