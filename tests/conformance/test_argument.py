"""The sentences about a witness."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import decide
from minkref.fuzz.run import naming
from minkref.fuzz.run.runner import Finding
from minkref.reports.conformance.argument import argument_in_plane
from minkref.reports.conformance.space_argument import argument_in_space

SQUARE = [[0, 0], [2, 0], [2, 2], [0, 2]]
FRAME = {"outer": [[0, 0], [9, 0], [9, 9], [0, 9]], "holes": [[[1, 1], [1, 8], [8, 8], [8, 1]]]}
TETRAHEDRON = {
    "vertices": [[0, 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0]],
    "faces": [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
}


def sentences(P: Any, Q: Any, point: tuple[str, str], scale: str = "1") -> str:
    value = {"P": {"polygons": P}, "Q": {"polygons": Q}, "scale": scale}
    case = naming.load(CaseName(json.dumps(value), "named"))
    assert isinstance(case, Case)
    return "\n".join(argument_in_plane(case.P_json, case.Q_json, scale, decide(case, point)))


@pytest.mark.parametrize(
    ("P", "Q", "point", "wanted"),
    [
        ({"outer": SQUARE}, {"outer": SQUARE}, ("5", "1"), "the line through"),
        (FRAME, {"outer": SQUARE}, ("5", "5"), "x - Q lies strictly inside the hole"),
        ({"outer": SQUARE}, FRAME, ("5", "5"), "sP lies strictly inside the hole"),
        ({"outer": SQUARE}, {"outer": SQUARE}, ("4", "4"), "p = (2, 2) is a vertex of P"),
    ],
)
def test_how_the_operands_miss_or_meet(P: Any, Q: Any, point: tuple[str, str], wanted: str) -> None:
    assert wanted in sentences([P], [Q], point)


def test_numbers_are_written_out_for_the_hand() -> None:
    text = sentences(
        [{"outer": [[-1, -1], [2, -1], [-1, 2]]}], [{"outer": SQUARE}], ("-3/2", "0"), "3/2"
    )
    assert "3/2 * (-1) + 0 = -3/2" in text
    assert "So x lies in the sum" in text


def test_neither_side_of_a_line_is_claimed_where_there_is_none() -> None:
    bent = [[0, 0], [9, 0], [9, 9], [8, 9], [8, 1], [0, 1]]
    text = sentences([{"outer": bent}], [{"outer": SQUARE}], ("6", "5"))
    assert "neither holds a vertex of the other" in text


def test_a_plane_parts_two_solids(finding: Callable[..., Finding]) -> None:
    text = json.dumps({"P": TETRAHEDRON, "Q": TETRAHEDRON, "scale": "1"})
    found = finding(text, "manifold3d", ("1", "1", "1"))
    case, witness = found.case, found.outcome.witness
    assert case.P and case.Q and witness
    told = "\n".join(argument_in_space(case.P, case.Q, "1", witness))
    assert "the plane of face" in told
    inside = finding(text, "manifold3d", ("1", "1", "0")).outcome.witness
    assert inside
    assert "So x lies in the sum" in "\n".join(argument_in_space(case.P, case.Q, "1", inside))
