"""Certificates of sums with a disc: by hand, from the producer, and changed: both checkers give one
verdict, and verify nothing that is not so."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import bridges
import grown
import pytest
from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.degeneracies.certified_disc_sums import (
    drawn_certificate,
    false_certificates,
    is_true,
    made,
)
from replacing import changed, replaced, sample, verdicts_on
from thoroughness import draws
from walls import polygons

CheckValue = Callable[[Any, Any], tuple[int, str]]
SEED = 12
TOTAL = ("claims", 0)


def _set_of(value: Any) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(json.dumps(value))


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
        ((*TOTAL, "joints"), [grown.HIGH, grown.LOW, grown.LOW], "not used"),
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


def test_what_is_produced_is_verified_and_what_is_false_is_not(tmp_path: Path) -> None:
    """Sets at any radii and at those of events, and members of degenerate families."""
    print("seed", SEED)
    given = [made(drawn_certificate(SEED, k)) for k in range(draws(4, 80))]
    assert set(verdicts_on(tmp_path, given)) == {0}
    assert all(is_true(*one) for one in given[:2])
    dice = random.Random(SEED)
    false = [
        (value, case)
        for one, case in given[: draws(1, 20)]
        for _, value in false_certificates(one, dice)
    ]
    (tmp_path / "false").mkdir()
    assert 0 not in verdicts_on(tmp_path / "false", false)
    assert len(false) > draws(8, 200)


def test_changes_verify_nothing_false(tmp_path: Path) -> None:
    """A joint that two blocked parts meet at may be another one; whatever is verified is so."""
    changes = sample(((value, grown.CASE) for value in changed(grown.certificate())), 400)
    codes = verdicts_on(tmp_path, changes)
    verified = [change for change, code in zip(changes, codes, strict=True) if code == 0]
    assert len(verified) < len(changes) // 2
    assert all(is_true(*change) for change in verified)


def test_a_vertex_inside_an_edge_becomes_a_vertex_of_both(tmp_path: Path) -> None:
    """A triangle touches the middle of a square's edge with its tip."""
    square, tip = "0 0,4 0,4 4,0 4", "2 0,1 -2,3 -2"
    rings = [[point.split() for point in ring.split(",")] for ring in (square, tip)]
    P = _set_of(polygons(*rings))
    certificate = DiscSumCertificate(P, Fraction(1, 4))
    certificate.sum()
    assert len(made(certificate)[1]["P"]["polygons"][0]["outer"]) == 5
    assert verdicts_on(tmp_path, [made(certificate)]) == [0]


TEETH = ", ".join(f"{x} 0, {x} 50, {x - 10} 50, {x - 10} 0" for x in (90, 70, 50, 30, 10))
DIAMOND = "0 0, 10 0, 10 10, 0 10, 0 0), (0 5, 5 0, 10 5, 5 10, 0 5"  # touched from within
SIZES = {
    "a hole touches from within": (DIAMOND, ("1e-60", "1e-12", "1e60")),
    "teeth": (f"0 -10, 100 -10, {TEETH}, 0 -10", ("1e-60", "1e60")),
    "far from the origin": ("1e200 1e200, 2e200 1e200, 2e200 2e200, 1e200 1e200", ("1e60",)),
    "nearly cut in two": ("0 0, 1 0, 1 1, 0.5 1e-90, 0 1, 0 0", ("1e-30", "1e60")),
}


@pytest.mark.parametrize("shape", SIZES)
def test_sizes_may_differ(tmp_path: Path, shape: str) -> None:
    """Radii much smaller and much larger than a set: digits follow the input."""
    rings, radii = SIZES[shape]
    given = []
    for radius in radii:
        P = _core.read_text(f"POLYGON (({rings}))", "wkt")
        certificate = DiscSumCertificate(P, Fraction(radius) ** 2)
        certificate.sum()
        given.append(made(certificate))
    assert set(verdicts_on(tmp_path, given)) == {0}


def test_numbers_of_too_many_digits_are_refused() -> None:
    P = _set_of(polygons([["0", "0"], [f"1{'0' * 2000}", "0"], ["0", "1"]]))
    with pytest.raises(NoProof, match="digits together"):
        DiscSumCertificate(P, Fraction(1)).sum()


def test_a_segment_is_refused() -> None:
    segment = {"polygons": [{"outer": [["0", "0"], ["1", "0"]], "holes": []}]}
    with pytest.raises(NoProof, match="regions"):
        DiscSumCertificate(_set_of(segment), Fraction(1, 4))
