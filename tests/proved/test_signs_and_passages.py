"""Claims `sign` and `passage`, proved; what is false of them is refuted."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
import squares
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.certified_cases import written

VERIFIED, REFUTED, MALFORMED = 0, 1, 2
FRAME = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))"
CORRIDOR = "POLYGON((0 0, 5 0, 5 4, 0 4, 0 0), (1 1, 1 2, 4 2, 4 1, 1 1))"
SQUARE = "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))"
SLOPE = ["orientation", [[1, None], [None, 1], [None, 2]]]  # 1 - s
LINES = ["concurrent", [[[None, 0], [None, 2]], [[1, None], [2, None]], [[None, 2], [None, 3]]]]


def signed(of: Any, a: str, b: str, sign: Any) -> dict[str, Any]:
    value = squares.certificate()
    value["claims"].append({"claim": "sign", "of": of, "from": a, "to": b, "sign": sign})
    return value


@pytest.mark.parametrize(
    ("of", "a", "b", "sign"),
    [
        (["orientation", [[0, 0], [1, 0], [2, 0]]], "1/2", "2", 1),
        (["orientation", [[0, 0], [2, 0], [1, 0]]], "1/2", "2", -1),
        (["orientation", [[0, 0], [1, 0], [1, 1]]], "1/1000", "1000", 0),
        (["orientation", [[None, None], [3, None], [None, 1]]], "1", "1", -1),
        (SLOPE, "1/2", "1", 1),
        (SLOPE, "1", "1", 0),
        (SLOPE, "1", "7/2", -1),
        (LINES, "1/2", "1", 1),
        (LINES, "1", "1", 0),
        (LINES, "1", "2", -1),
    ],
)
def test_signs(check_value: Any, of: Any, a: str, b: str, sign: int) -> None:
    code, said = check_value(signed(of, a, b, sign), squares.CASE)
    assert code == VERIFIED, said
    assert f"has the sign {sign} from {a} to {b}" in said
    for other in {-1, 0, 1} - {sign}:
        assert check_value(signed(of, a, b, other), squares.CASE)[0] == REFUTED


@pytest.mark.parametrize(
    ("of", "a", "b", "sign", "code"),
    [
        (SLOPE, "1/2", "2", 1, REFUTED),
        (SLOPE, "1", "2", 1, REFUTED),
        (SLOPE, "1/2", "1000001/1000000", 1, REFUTED),
        (SLOPE, "999999/1000000", "999999/1000000", 0, REFUTED),
        (SLOPE, "2", "1", -1, MALFORMED),
        (SLOPE, "0", "1", 1, MALFORMED),
        (SLOPE, "1/2", "1", 2, MALFORMED),
        (SLOPE, "1/2", "1", "1", MALFORMED),
        (["orientation", [[4, None], [None, 1], [None, 2]]], "1/2", "1", 1, MALFORMED),
        (["orientation", [[-1, None], [None, 1], [None, 2]]], "1/2", "1", 1, MALFORMED),
        (["orientation", [[1, None], [None, 1]]], "1/2", "1", 1, MALFORMED),
        (["concurrent", SLOPE[1]], "1/2", "1", 1, MALFORMED),
        (["parallel", SLOPE[1]], "1/2", "1", 1, MALFORMED),
    ],
)
def test_what_is_no_sign(check_value: Any, of: Any, a: str, b: str, sign: Any, code: int) -> None:
    assert check_value(signed(of, a, b, sign), squares.CASE)[0] == code


def tight(Q: str, P: str, scale: str) -> Certificate:
    operands = (_core.read_text(text, "wkt", "a test") for text in (Q, P))
    certificate = Certificate(*operands)
    certificate.sum(scale, passages=True)
    assert {claim["claim"] for claim in certificate.claims} == {"sum", "passage"}
    return certificate


@pytest.mark.parametrize(
    ("P", "Q", "scale", "points"),
    [
        (FRAME, SQUARE, "1", [["2", "2"]]),
        (SQUARE, FRAME, "1", [["2", "2"]]),
        (CORRIDOR, SQUARE, "1", [["2", "2"], ["4", "2"]]),
        (SQUARE, CORRIDOR, "1", [["2", "2"], ["4", "2"]]),
    ],
)
def test_passages(
    check: Any, tmp_path: Path, P: str, Q: str, scale: str, points: list[list[str]]
) -> None:
    certificate = tight(P, Q, scale)
    found = certificate.claims[1]["points"]
    assert sorted(found)[0] == points[0] and sorted(found)[-1] == points[-1]
    path = written(certificate, tmp_path, "it")
    code, said = check(path)
    assert code == VERIFIED, said
    assert f"passage: at {scale}, of {len(found)} points" in said
    value = json.loads(path.read_text(encoding="utf-8"))
    ends = [claim for claim in value["claims"] if claim["claim"] == "passage"]
    assert len(ends) == 1
    for spoil, expected in SPOILT:
        other = copy.deepcopy(value)
        spoil(other, other["claims"][1], other["steps"][other["claims"][1]["step"]])
        path.write_text(json.dumps(other), encoding="utf-8")
        assert check(path)[0] == expected, other["claims"][1]


def moved(_: Any, claim: Any, __: Any) -> None:
    claim["points"][0][1] = "3"


def longer(_: Any, claim: Any, __: Any) -> None:
    claim["points"].append(claim["points"][0])
    claim["path"].append(claim["path"][0])


def elsewhere(_: Any, claim: Any, step: Any) -> None:
    """To a corner of the boundary that no contact touches, with its own coordinates."""
    corner = step["polygons"][0][0][0]
    claim["path"] = [corner]
    claim["points"] = [["0", "0"]]
    step["contacts"].append([[corner], *step["contacts"][0][1:]])


def without_its_code(_: Any, __: Any, step: Any) -> None:
    step["contacts"] = [[contact[0]] for contact in step["contacts"]]


def without_a_contact(_: Any, __: Any, step: Any) -> None:
    step["contacts"] = []


def at_no_scale(_: Any, claim: Any, __: Any) -> None:
    claim["scale"] = "2"


def without_points(_: Any, claim: Any, __: Any) -> None:
    claim["points"], claim["path"] = [], []


SPOILT = [
    (moved, REFUTED),
    (longer, REFUTED),
    (elsewhere, REFUTED),
    (without_its_code, REFUTED),
    (without_a_contact, REFUTED),
    (at_no_scale, REFUTED),
    (without_points, MALFORMED),
]


def test_the_boundary_is_no_passage(check_value: Any) -> None:
    """Two squares of the hand-written certificate: their sum's corner and side are missed by the
    sum of the interiors, but not inside the sum."""
    value = squares.certificate()
    step = value["steps"][2]
    step["contacts"] = [[[9], 0], [[9, 10], 1]]
    for points, path in ([["2", "0"]], [9]), ([["2", "0"], ["2", "2"]], [9, 10]):
        other = copy.deepcopy(value)
        other["claims"].append(
            {"claim": "passage", "scale": "1", "step": 2, "points": points, "path": path}
        )
        assert check_value(value, squares.CASE)[0] == VERIFIED
        assert check_value(other, squares.CASE)[0] == REFUTED


def test_no_passage_where_an_operand_is_thin(check: Any, tmp_path: Path) -> None:
    """Its pieces have seams, which contacts follow."""
    operands = (_core.read_text(text, "wkt", "a test") for text in (FRAME, "POINT(0 0)"))
    certificate = Certificate(*operands)
    certificate.sum("1")
    path = written(certificate, tmp_path, "it")
    value = json.loads(path.read_text(encoding="utf-8"))
    step = value["claims"][0]["step"]
    ring = value["steps"][step]["polygons"][0][0]
    value["claims"].append(
        {"claim": "passage", "scale": "1", "step": step, "points": [["0", "0"]],
         "path": ring[:1]}
    )  # fmt: skip
    path.write_text(json.dumps(value), encoding="utf-8")
    assert check(path)[0] == MALFORMED


def test_all_passages_are_declined(check: Any, tmp_path: Path) -> None:
    """There is no theorem about a list that is complete."""
    certificate = Certificate(*(_core.read_text(wkt, "wkt", "a test") for wkt in (FRAME, SQUARE)))
    certificate.sum(1, complete=True)
    code, said = check(written(certificate, tmp_path, "it"))
    assert (code, "no theorem about all passages" in said) == (5, True), said
