"""Certificates of bridges: by hand, from the producer, and changed: both checkers give one verdict,
and verify nothing that is not so."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import bridges
import pytest
from minkref import _core
from minkref.certify.disc.bridge_certificate import BridgeCertificate
from minkref.fuzz.features.feature_draws import drawn_set, set_of
from replacing import Change, Value, changed, replaced, sample, verdicts_on
from thoroughness import draws
from walls import polygons

CheckValue = Callable[[Any, Any], tuple[int, str]]
SEED = 11


def made(number: int) -> Change | None:
    """A drawn set's certificate, at a radius beside an event's; None without a claim."""
    _, shape = drawn_set(SEED, number)
    P = set_of(shape)
    found = _core.features(P)
    if not found.radii:
        return None
    radius = Fraction(found.radius(1 + number % found.radii)[0]).limit_denominator(1000)
    certificate = BridgeCertificate(P, (radius or Fraction(1, 7)) * (1 + Fraction(number % 3, 9)))
    certificate.bridges(found)
    certificate.touches()
    if not certificate.claims:
        return None
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def test_by_hand(check_value: CheckValue) -> None:
    code, said = check_value(bridges.certificate(), bridges.CASE)
    assert code == 0, said
    assert "bridge from vertex 7 to vertex 4, squared radius 25" in said
    assert "disc about (3, 4) that touches 2 features" in said


def test_what_is_produced_is_verified(tmp_path: Path) -> None:
    print("seed", SEED)
    drawn = [one for k in range(draws(30, 300)) if (one := made(k))]
    assert len(drawn) > draws(30, 300) // 2
    assert set(verdicts_on(tmp_path, drawn)) == {0}


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


def test_changes_verify_nothing_false(tmp_path: Path) -> None:
    """A box may change and still have the centre inside; whatever is verified is so."""
    given = [(bridges.certificate(), bridges.CASE), *filter(None, map(made, range(6)))]
    changes = sample([(value, case) for one, case in given for value in changed(one)], 1000)
    codes = verdicts_on(tmp_path, changes)
    verified = [change for change, code in zip(changes, codes, strict=True) if code == 0]
    assert len(verified) < len(changes) // 2
    assert all(is_true(*change) for change in verified)


def is_true(value: Value, case: Value) -> bool:
    """By doubles: named features are as far from the box or centre as the radius, none is
    nearer."""
    rings = [
        [(float(Fraction(x)), float(Fraction(y))) for x, y in ring]
        for polygon in case["P"]["polygons"]
        for ring in (polygon["outer"], *polygon.get("holes", []))
    ]
    edges = [(a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    radius = float(Fraction(value["square"])) ** 0.5
    for claim in value["claims"]:
        if claim["claim"] == "bridge":
            p, u, w = ([float(Fraction(x)) for x in pair] for pair in claim["box"])
            centre = p[0] + (u[0] + w[0]) / 2, p[1] + (u[1] + w[1]) / 2
            slack, named = math.hypot(*u) + math.hypot(*w), [claim["left"], claim["right"]]
        else:
            centre = tuple(float(Fraction(x)) for x in claim["centre"])
            slack, named = 1e-9, claim["features"]
        far = [distance(centre, *edge) for edge in edges]
        own = [math.dist(centre, edges[n][0]) if kind == "vertex" else far[n] for kind, n in named]
        if min(far) < radius - slack or any(abs(one - radius) > slack for one in own):
            return False
    return True


def distance(p: Any, a: Any, b: Any) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)
