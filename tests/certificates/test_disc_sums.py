"""Certificates of sums with a disc: by hand, from the producer, and changed: both checkers give one
verdict, and verify nothing that is not so."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bridges
import grown
import pytest
from replacing import replaced
from walls import polygons

CheckValue = Callable[[Any, Any], tuple[int, str]]
TOTAL = ("claims", 0)


def test_by_hand(check_value: CheckValue) -> None:
    code, said = check_value(grown.certificate(), grown.CASE)
    assert code == 0, said
    assert f"sum: 1 components, 0 holes, {grown.DIGEST}, squared radius 1" in said
    assert "point: (2, 2) is at the radius" in said


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        (("square",), "2", "off its arc"),
        (("square",), "-1", "not positive"),
        ((*TOTAL, "joints", 0, 2, 0), "1", "off its arc"),
        ((*TOTAL, "joints", 0, 0), "0", "not of a positive number"),
        ((*TOTAL, "joints", 0, 1), ["-1", "0"], "not of a positive number"),
        ((*TOTAL, "joints"), [], "no number"),
        ((*TOTAL, "edges", 1), grown.FREE, "near to a free part"),
        ((*TOTAL, "edges", 0, 1), 7, "not near to a blocked part"),
        ((*TOTAL, "edges", 0, 1), [2], "does not face"),
        ((*TOTAL, "edges", 0), [None, "free"], "places and links"),
        ((*TOTAL, "edges", 0), [None, "free", "2", "free", None], "off its curve"),
        ((*TOTAL, "edges", 0), [None, "free", 0, "free", None], "off its line"),
        ((*TOTAL, "edges", 0), [0, "free", None], "off its line"),
        ((*TOTAL, "edges"), [grown.FREE], "not 8 entries"),
        ((*TOTAL, "arcs", 0), [None, "free", ["0", "0"], "free", None], "direction is zero"),
        ((*TOTAL, "arcs", 1, 1), 7, "not near"),
        ((*TOTAL, "arcs", 1), [None, "free", None], "near to a free part"),
        ((*TOTAL, "arcs", 1, 3), "free", "near to a free part"),
        ((*TOTAL, "components"), [], "one ring each"),
        ((*TOTAL, "components"), [[grown.RING], [grown.RING]], "several components"),
        ((*TOTAL, "components"), [[grown.RING, grown.RING]], "one ring each"),
        ((*TOTAL, "components", 0, 0), grown.RING[::-1], "follow each other"),
        ((*TOTAL, "components", 0, 0), grown.RING[1:], "follow each other"),
        ((*TOTAL, "components", 0), [], "missing or empty"),
        ((*TOTAL, "holes"), 1, "0 holes"),
        ((*TOTAL, "holes"), "0", "no integer"),
        ((*TOTAL, "digest"), "0" * 64, "another digest"),
        (("claims", 1, "distance"), 1, "not as far"),
        (("claims", 2, "point"), ["2", "3"], "not as far"),
        (("claims", 3), {"claim": "bridge"}, "no claim"),
        (("claims", 3), {"claim": "point", "point": ["2", "2"], "distance": 0}, "twice"),
    ],
)
def test_each_rule_refuses(check_value: CheckValue, path: Any, new: Any, why: str) -> None:
    code, said = check_value(replaced(grown.certificate(), path, new), grown.CASE)
    assert code in (1, 2) and why in said, said


@pytest.mark.parametrize(
    ("outer", "why"),
    [
        ([["1/2", "1/2"], ["5/2", "1/2"], ["5/2", "3/4"]], "meet"),  # it crosses both squares
        ([["1", "-1"], ["2", "-1"], ["2", "0"], ["1", "0"]], "12 entries"),  # it touches both
        ([["1", "0"], ["2", "0"], ["2", "-1"], ["1", "-1"]], "not on the left"),
        ([["0", "0"], ["1", "0"], ["0", "-1"]], "overlap"),
        ([["5", "5"], ["6", "6"], ["7", "5"], ["6", "6"], ["6", "7"]], "twice"),
        ([["1/4", "1/4"], ["3/4", "1/4"], ["3/4", "3/4"]], "not on the left"),
        ([["5", "0"], ["6", "0"], ["6", "1"]], "entries"),
    ],
)
def test_the_set_is_looked_at(check_value: CheckValue, outer: Any, why: str) -> None:
    rings = [polygon["outer"] for polygon in grown.CASE["P"]["polygons"]]
    case = {"P": polygons(*rings, outer)}
    value = replaced(grown.certificate(), ("case", "sha256"), bridges.digest_of_case(case))
    code, said = check_value(value, case)
    assert code in (1, 2) and why in said, said
