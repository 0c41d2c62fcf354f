"""Rules for steps that the page asks for, and no theorem does."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
import squares

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET, DECLINED = 0, 1, 2, 4, 5
BOX_AND_SUM = [[8, 9, 10, 11], [12, 15, 14, 13]]  # the second along the box, the wrong way
NORMALS = [["0", "-1/2"], [1, 0], [0, 1], [-1, 0]]
HALVES = [[0, 1, 2], [0, 2, 3]]


def changed(step: int, **members: Any) -> dict[str, Any]:
    value = squares.certificate()
    value["steps"][step].update(copy.deepcopy(members))
    return value


@pytest.mark.parametrize(
    ("step", "members", "code"),
    [
        (2, {"polygons": [BOX_AND_SUM]}, REFUTED),
        (2, {"cells": [squares.EQ["cells"][0][::-1], *squares.EQ["cells"][1:]]}, REFUTED),
        (2, {"cells": [[8, 9, 10, 11, 11], *squares.EQ["cells"][1:]]}, REFUTED),
        (2, {"normals": NORMALS}, MALFORMED),
        (2, {"normals": [*squares.EQ["normals"], [0, 0]]}, MALFORMED),
        (2, {"contacts": [[[8, 9, 10], 0]]}, MALFORMED),
        (2, {"contacts": [[[8, 8], 0]]}, MALFORMED),
        (2, {"contacts": [[[], 0]]}, MALFORMED),
        (2, {"contacts": [[[8], 2]]}, REFUTED),
        (2, {"contacts": [[[8], 0, 0]]}, REFUTED),
        (2, {"contacts": [[[8]]]}, REFUTED),
        (2, {"box": ["3", "3", "-1", "-1"]}, REFUTED),
        (0, {"pieces": [[0, 1, 0, 1, 2, 3]]}, REFUTED),
        (0, {"pieces": [[0, 0, 1, 2, 3]]}, REFUTED),
        (0, {"pieces": HALVES, "groups": [[0]]}, REFUTED),
        (0, {"pieces": [[0, 1, 2, 3], [0, 1, 2]], "groups": [[0]]}, REFUTED),
    ],
)
def test_steps_of_another_form(check_value: Any, step: int, members: Any, code: int) -> None:
    assert check_value(changed(step, **members), squares.CASE)[0] == code


def test_a_ring_with_a_vertex_twice_in_a_row_is_declined(check_value: Any) -> None:
    """The others take it: such an edge has no effect on the set."""
    outer = squares.SQUARE["polygons"][0]["outer"]
    case = {**squares.CASE, "P": {"polygons": [{"outer": [*outer, outer[3]]}]}}
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    assert check_value(value, case)[0] == DECLINED


def test_each_claim_spends_the_tests_of_its_steps(check: Any, tmp_path: Path) -> None:
    """One claim, written in 300 ways."""
    value = squares.certificate()
    value["claims"] = [{**squares.CLAIM, "scale": f"1.{'0' * i}"} for i in range(300)]
    (tmp_path / "case.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    path = tmp_path / "it.cert.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    assert check(path, "--tests", str(300 * 64 + 1000))[0] == OUT_OF_BUDGET
    assert check(path)[0] == VERIFIED
