"""Certificates of points beside a sum's boundary, in the sum and not, and changes of them."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.mutants import mutants

BESIDE = Fraction(1, 10**6)
Point = tuple[str, str]


def is_in_sum(case: Case, point: Any, scale: str | None = None) -> bool:
    """By the reference, which knows nothing of pieces and normals."""
    x, y = map(str, point)
    found = _core.decide(case.P, case.Q, scale or case.scale, x, y)
    return bool(found["contact"] != "empty")


def points(case: Case, count: int, dice: random.Random) -> list[Point]:
    """Corners of the sum, and points close to them and between them."""
    region = json.loads(_core.minkowski_sum(case.P, case.Q, case.scale).region.to_json())
    rings = [ring for p in region["polygons"] for ring in (p["outer"], *p.get("holes", []))]
    corners = [(Fraction(x), Fraction(y)) for ring in rings for x, y in ring]
    found = []
    for _ in range(count if corners else 0):
        (x, y), (u, v) = dice.choice(corners), dice.choice(corners)
        by, aside = dice.choice([0, BESIDE, -BESIDE]), dice.choice([0, BESIDE, -BESIDE])
        t = dice.choice([Fraction(0), Fraction(1, 2), Fraction(1, 3)])
        found.append((str(x + t * (u - x) + by), str(y + t * (v - y) + aside)))
    return found or [("0", "0")]


def certified(case: Case, count: int, dice: random.Random, thin: bool = True) -> Certificate:
    """Claims for each point what the reference says: in the sum, or outside. Without `thin` no
    point in a sum with a point or a segment, for which there is no theorem."""
    certificate = Certificate(case.P, case.Q)
    for point in dict.fromkeys(points(case, count, dice)):
        if not is_in_sum(case, point):
            certificate.outside(case.scale, point)
        elif thin or (case.P.is_region and case.Q.is_region):
            certificate.point(case.scale, point)
    if not certificate.claims:
        certificate.outside(case.scale, (10**9, 10**9))
    return certificate


def changed(case: Case, value: Any, dice: random.Random) -> Iterator[Any]:
    """Certificates with another point, with a claim of the other kind, and mutants."""
    for i, claim in enumerate(value["claims"]):
        for point in points(case, 4, dice):
            other = copy.deepcopy(value)
            other["claims"][i]["point"] = list(point)
            yield other
        swapped = copy.deepcopy(value)
        there = swapped["claims"][i]
        if claim["claim"] == "outside":
            for name in ("normals", "code"):
                del there[name]
            there |= {"claim": "point", "p": ["0", "0"], "q": claim["point"], "pieces": [0, 0]}
        else:
            for name in ("p", "q", "pieces"):
                del there[name]
            there |= {"claim": "outside", "normals": [[1, 0], [0, 1]], "code": [0]}
        yield swapped
    for mutant in mutants(value, 1, dice):
        yield mutant.value


def is_true(case: Case, claims: Any) -> bool:
    """Returns whether claims about points hold, at their scales."""
    return all(
        is_in_sum(case, claim["point"], str(Fraction(claim["scale"])))
        == (claim["claim"] == "point")
        for claim in claims
    )
