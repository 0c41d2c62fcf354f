"""Certificates of bridges: by hand, from the producer, and changed: both checkers give one verdict,
and verify nothing that is not so."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import bridges
import pytest
from minkref import _core
from minkref.certify.disc.bridge_certificate import BridgeCertificate
from minkref.fuzz.judges.disc.certified_bridges import drawn_certificate, is_true, made
from replacing import Change, changed, replaced, sample, verdicts_on
from thoroughness import draws
from walls import polygons

CheckValue = Callable[[Any, Any], tuple[int, str]]
SEED = 11


def produced(number: int) -> Change | None:
    certificate = drawn_certificate(SEED, number)
    return None if certificate is None else made(certificate)


def test_by_hand(check_value: CheckValue) -> None:
    code, said = check_value(bridges.certificate(), bridges.CASE)
    assert code == 0, said
    assert "bridge from vertex 7 to vertex 4, squared radius 25" in said
    assert "disc about (3, 4) that touches 2 features" in said


def test_what_is_produced_is_verified(tmp_path: Path) -> None:
    print("seed", SEED)
    drawn = [one for k in range(draws(30, 300)) if (one := produced(k))]
    assert len(drawn) > draws(30, 300) // 2
    assert set(verdicts_on(tmp_path, drawn)) == {0}


SLOT = ((0, 0), (10, 0), (10, 10), (6, 10), (6, 2), (4, 2), (4, 10), (0, 10))


@pytest.mark.parametrize(
    ("size", "away", "count"),
    [("1", "1e13", 1), ("1e-312", "0", 1), ("1e290", "0", 1), ("1", "1e17", 0), ("1e-322", "0", 0),
     ("1e400", "0", 0)],
)  # fmt: skip
def test_any_size_is_verified_or_declined(tmp_path: Path, size: str, away: str, count: int) -> None:
    """A slot, also where doubles do not tell the place of the disc at its bottom."""
    corners = [*SLOT[:4], (Fraction(6) + Fraction(1, 10**31), 9), *SLOT[4:]]  # one edge is short
    points = [[str(c * Fraction(size) + Fraction(away)) for c in point] for point in corners]
    P = _core.PolygonSet.from_json(json.dumps(polygons(points)))
    certificate = BridgeCertificate(P, Fraction(size) * 3 / 2)
    assert certificate.bridges(_core.features(P)) == count
    assert certificate.declined.total() == 1 - count
    if count:
        assert verdicts_on(tmp_path, [made(certificate)]) == [0]


@pytest.mark.parametrize(
    ("path", "new", "why"),
    [
        (("square",), "26", "as far from both features"),
        (("square",), "0", "not positive"),
        (("claims", 0, "left"), ["vertex", 3], "nearer to an edge"),
        (("claims", 0, "left"), ["vertex", 5], "convex"),
        (("claims", 0, "left"), ["edge", 7], "in front of"),
        (("claims", 0, "right"), ["vertex", 7], "twice"),
        (("claims", 0, "box", 0), ["3", "-127/32"], "nearer to an edge"),
        (("claims", 0, "box", 1), ["-1/24", "1/32"], "flat"),
        (("claims", 0, "box", 2), ["-1/24", "1/16"], "as far from both features"),
        (("claims", 0, "box", 1), ["4", "3"], "wider"),
        (("claims", 1, "centre"), ["3", "5"], "is not as far"),
        (("claims", 1, "features"), [bridges.LEFT], "two features"),
        (("claims", 1, "features"), [bridges.LEFT, bridges.LEFT], ""),
        (("claims", 1), None, "no claim"),
        (("claims",), [], "nothing is claimed"),
        (("claims", 0), {"claim": "bridge", "left": bridges.LEFT}, "missing"),
    ],
)
def test_each_rule_refuses(check_value: CheckValue, path: Any, new: Any, why: str) -> None:
    code, said = check_value(replaced(bridges.certificate(), path, new), bridges.CASE)
    assert code in (1, 2) and why in said, said


@pytest.mark.parametrize(
    ("outer", "why"),
    [
        ([["2", "1"], ["4", "1"], ["4", "2"], ["2", "2"]], "edge"),  # a box in the disc
        ([["-50", "-50"], ["50", "-50"], ["50", "50"], ["-50", "50"]], "outside"),
        ([["0", "0"], ["-3", "2"], ["-3", "1"]], "rings touch"),
    ],
)
def test_more_of_the_set_is_seen(check_value: CheckValue, outer: Any, why: str) -> None:
    case = {"P": polygons(bridges.SLOT, outer)}
    value = replaced(bridges.certificate(), ("case", "sha256"), bridges.digest_of_case(case))
    code, said = check_value(value, case)
    assert code == 1 and why in said, said


def test_a_spike_is_not_in_the_set(check_value: CheckValue) -> None:
    """A ring that goes out and back: the disc touches its tip only, not the set."""
    ring = [["0", "0"], ["4", "0"], ["4", "4"], ["2", "4"], ["2", "6"], ["2", "4"], ["0", "4"]]
    case = {"P": polygons(ring, [["0", "8"], ["4", "8"], ["4", "9"], ["0", "9"]])}
    touch = {"claim": "touch", "centre": ["2", "7"], "features": [["vertex", 4], ["edge", 7]]}
    head = {"path": "case.json", "sha256": bridges.digest_of_case(case)}
    value = {**bridges.certificate(), "case": head, "square": "1", "claims": [touch]}
    code, said = check_value(value, case)
    assert code == 1 and "convex" in said, said


def test_changes_verify_nothing_false(tmp_path: Path) -> None:
    """A box may change and still have the centre inside; whatever is verified is so."""
    given = [(bridges.certificate(), bridges.CASE), *filter(None, map(produced, range(6)))]
    changes = sample([(value, case) for one, case in given for value in changed(one)], 1000)
    codes = verdicts_on(tmp_path, changes)
    verified = [change for change, code in zip(changes, codes, strict=True) if code == 0]
    assert len(verified) < len(changes) // 2
    assert all(is_true(*change) for change in verified)
