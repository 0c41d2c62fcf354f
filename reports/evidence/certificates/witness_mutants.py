"""Certificates of a point in the plane, changed in what they say: the point, the side, an operand,
the scale. The case and its digest always fit, so that only the proof can refuse."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.case_text import case_digest

STEPS = (*(Fraction(1, 2**k) for k in (40, 20, 8, 3, 1)), Fraction(3), Fraction(50))
FACTORS = (Fraction(1, 3), Fraction(2**30 + 1, 2**30), Fraction(7, 5), Fraction(2))
BOX_NORMALS = [[1, 0], [0, 1], [-1, 0], [0, -1]]
Point = tuple[Fraction, ...]


@dataclass(frozen=True)
class ChangedWitness:
    """`way`: the change; `case` and `certificate` as JSON values."""

    way: str
    case: dict[str, Any]
    certificate: dict[str, Any]


def changed_witnesses(case: str, certificate: str, dice: random.Random) -> Iterator[ChangedWitness]:
    """Changes of a certificate with one claim `point` or `outside`, without end. Operands stay
    valid."""
    beside, value = json.loads(case), json.loads(certificate)
    ways = (_moved, _across, _flipped, _operand, _scaled)
    while True:
        for way in ways:
            changed = way(copy.deepcopy(beside), copy.deepcopy(value), dice)
            if changed is not None:
                yield ChangedWitness(way.__name__.strip("_"), *changed)


Changed = tuple[dict[str, Any], dict[str, Any]] | None


def _moved(case: Any, value: Any, dice: random.Random) -> Changed:
    """The point a little to some side; of a point in the sum, q too."""
    claim = value["claims"][0]
    by = [dice.choice((-1, 0, 1)) * dice.choice(STEPS) for _ in range(2)]
    claim["point"] = _plus(claim["point"], by)
    if claim["claim"] == "point":
        claim["q"] = _plus(claim["q"], by)
    return (case, value) if any(by) else None


def _across(case: Any, value: Any, dice: random.Random) -> Changed:
    """To a sum of two vertices, or far out."""
    claim = value["claims"][0]
    p, q = (dice.choice(_vertices(case[name])) for name in "PQ")
    if claim["claim"] == "outside":
        claim["point"] = _sum(claim["scale"], p, q)
    else:
        claim["point"] = _plus(claim["point"], [Fraction(10**6), Fraction(0)])
        claim["q"] = _plus(claim["q"], [Fraction(10**6), Fraction(0)])
    return case, value


def _flipped(case: Any, value: Any, dice: random.Random) -> Changed:
    """The opposite claim, in a form that a checker has to follow."""
    old = value["claims"][0]
    kept = {name: old[name] for name in ("scale", "point", "by")}
    if old["claim"] == "point":
        code = [dice.randrange(len(BOX_NORMALS))]
        claim = {"claim": "outside", **kept, "normals": BOX_NORMALS, "code": code}
    else:
        p = dice.choice(_vertices(case["P"]))
        s = Fraction(old["scale"])
        q = [str(Fraction(x) - s * c) for x, c in zip(old["point"], p, strict=True)]
        pieces = [dice.randrange(len(value["steps"][step]["pieces"])) for step in old["by"]]
        claim = {"claim": "point", **kept, "p": [str(c) for c in p], "q": q, "pieces": pieces}
    value["claims"] = [claim]
    return case, value


def _operand(case: Any, value: Any, dice: random.Random) -> Changed:
    """A vertex moved; the digest is that of the changed case."""
    rings = _rings(case[dice.choice("PQ")])
    ring = dice.choice(rings)
    at = dice.randrange(len(ring))
    by = [dice.choice((-1, 1)) * dice.choice(STEPS) for _ in range(2)]
    ring[at] = _plus(ring[at], by)
    sets = [_core.PolygonSet.from_json(json.dumps(case[name])) for name in "PQ"]
    try:
        for name, one in zip("PQ", sets, strict=True):
            one.validate(name)
    except _core.BadInput:
        return None
    value["case"]["sha256"] = case_digest(sets[0], sets[1])
    return case, value


def _scaled(case: Any, value: Any, dice: random.Random) -> Changed:
    """Another scale; of a point in the sum with the q that makes up for it."""
    claim = value["claims"][0]
    s = Fraction(claim["scale"]) * dice.choice(FACTORS)
    claim["scale"] = str(s)
    if claim["claim"] == "point":
        parts = zip(claim["point"], claim["p"], strict=True)
        claim["q"] = [str(Fraction(x) - s * Fraction(p)) for x, p in parts]
    return case, value


def _rings(operand: Any) -> list[Any]:
    return [r for one in operand["polygons"] for r in (one["outer"], *one.get("holes", []))]


def _vertices(operand: Any) -> list[Point]:
    return [tuple(map(Fraction, vertex)) for ring in _rings(operand) for vertex in ring]


def _plus(place: Any, by: list[Fraction]) -> list[str]:
    return [str(Fraction(c) + d) for c, d in zip(place, by, strict=True)]


def _sum(scale: str, p: Point, q: Point) -> list[str]:
    return [str(Fraction(scale) * a + b) for a, b in zip(p, q, strict=True)]
