"""Changes certificates about a sum's point: another point, side, operand or scale. Case and digest
always fit, so only the proof can refuse."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.case_text import case_digest
from minkref.certify.space.tiled_solids import solid_case_digest

STEPS = (*(Fraction(1, 2**k) for k in (40, 20, 8, 3, 1)), Fraction(3), Fraction(50))
FACTORS = (Fraction(1, 3), Fraction(2**30 + 1, 2**30), Fraction(7, 5), Fraction(2))
FAR = Fraction(10**6)
Point = tuple[Fraction, ...]
Changed = tuple[dict[str, Any], dict[str, Any]] | None


@dataclass(frozen=True)
class ChangedWitness:
    """`way`: the change; `case` and `certificate` as JSON values."""

    way: str
    case: dict[str, Any]
    certificate: dict[str, Any]


def changed_witnesses(case: str, certificate: str, dice: random.Random) -> Iterator[ChangedWitness]:
    """Changes of a certificate with one claim `point` or `outside`, without end. Operands stay
    valid."""
    while True:
        for way in (_moved, _across, _flipped, _operand, _scaled):
            changed = way(json.loads(case), json.loads(certificate), dice)
            if changed is not None:
                yield ChangedWitness(way.__name__.strip("_"), *copy.deepcopy(changed))


def _moved(case: Any, value: Any, dice: random.Random) -> Changed:
    """Moves the point a little, and q with a point inside."""
    claim = value["claims"][0]
    by = [dice.choice((-1, 0, 1)) * dice.choice(STEPS) for _ in claim["point"]]
    _move(claim, by)
    return (case, value) if any(by) else None


def _across(case: Any, value: Any, dice: random.Random) -> Changed:
    """Moves the point to a sum of two vertices, or far out."""
    claim = value["claims"][0]
    if claim["claim"] == "outside":
        if not all(_vertices(case[name]) for name in "PQ"):
            return None
        p, q = (dice.choice(_vertices(case[name])) for name in "PQ")
        scaled = [s * a for s, a in zip(_factors(claim), p, strict=True)]
        claim["point"] = _plus(scaled, q)
    else:
        _move(claim, [FAR, *(Fraction(0) for _ in claim["point"][1:])])
    return case, value


def _flipped(case: Any, value: Any, dice: random.Random) -> Changed:
    """Claims the opposite, in a form that checkers have to follow."""
    old = value["claims"][0]
    kept = {name: old[name] for name in ("scale", "scaling", "point", "by") if name in old}
    numbers = _numbers_of_pieces(value)
    if not all(numbers):
        return None
    if old["claim"] == "point":
        normal = [0] * len(old["point"])
        normal[dice.randrange(len(normal))] = dice.choice((-1, 1))
        pairs = 1 if "by" in old else numbers[0] * numbers[1]
        claim = {"claim": "outside", **kept, "normals": [normal], "code": [0] * pairs}
    else:
        p = dice.choice(_vertices(case["P"]))
        q = [Fraction(x) - s * c for x, s, c in zip(old["point"], _factors(old), p, strict=True)]
        pieces = [dice.randrange(number) for number in numbers]
        claim = {"claim": "point", **kept, "p": _texts(p), "q": _texts(q), "pieces": pieces}
    value["claims"] = [claim]
    return case, value


def _operand(case: Any, value: Any, dice: random.Random) -> Changed:
    """Moves a vertex, at times far, and computes the new digest."""
    rings = _rings(case[dice.choice("PQ")])
    if not rings:
        return None
    ring = dice.choice(rings)
    at = dice.randrange(len(ring))
    by = [dice.choice((-1, 0, 1)) * dice.choice(STEPS) for _ in ring[at]]
    ring[at] = _plus(ring[at], by)
    try:
        value["case"]["sha256"] = _digest(case)
    except _core.BadInput:
        return None
    return (case, value) if any(by) else None


def _scaled(case: Any, value: Any, dice: random.Random) -> Changed:
    """Changes the scale, and q for a point inside: s p + q stays."""
    claim = value["claims"][0]
    factors = [s * f for s, f in zip(_factors(claim), [dice.choice(FACTORS)] * 3, strict=False)]
    if "scale" in claim:
        claim["scale"] = str(factors[0])
    else:
        claim["scaling"] = _texts(factors)
    if claim["claim"] == "point":
        parts = zip(claim["point"], factors, claim["p"], strict=True)
        claim["q"] = _texts([Fraction(x) - s * Fraction(p) for x, s, p in parts])
    return case, value


def _move(claim: Any, by: Sequence[Fraction]) -> None:
    claim["point"] = _plus(claim["point"], by)
    if claim["claim"] == "point":
        claim["q"] = _plus(claim["q"], by)


def _factors(claim: Any) -> list[Fraction]:
    if "scale" in claim:
        return [Fraction(claim["scale"])] * len(claim["point"])
    return [Fraction(s) for s in claim["scaling"]]


def _numbers_of_pieces(value: Any) -> list[int]:
    if "steps" in value:
        return [len(step["pieces"]) for step in value["steps"]]
    return [len(value["proof"][name]["hulls"]) for name in "PQ"]


def _digest(case: Any) -> str:
    """Raises BadInput for an operand that is not valid."""
    if "vertices" not in case["P"]:
        sets = [_core.PolygonSet.from_json(json.dumps(case[name])) for name in "PQ"]
        for name, one in zip("PQ", sets, strict=True):
            one.validate(name)
        return case_digest(sets[0], sets[1])
    bodies = []
    for name in "PQ":
        rows = [(x, y, z) for x, y, z in case[name]["vertices"]]
        bodies.append(_core.Polyhedron(rows, case[name]["faces"]))
        _core.PolyhedralSet(bodies[-1], name)
    return solid_case_digest(bodies[0], bodies[1])


def _rings(operand: Any) -> list[Any]:
    if "vertices" in operand:
        return [operand["vertices"]]
    return [r for one in operand["polygons"] for r in (one["outer"], *one.get("holes", []))]


def _vertices(operand: Any) -> list[Point]:
    return [tuple(map(Fraction, vertex)) for ring in _rings(operand) for vertex in ring]


def _plus(place: Sequence[Any], by: Sequence[Fraction]) -> list[str]:
    return [str(Fraction(c) + d) for c, d in zip(place, by, strict=True)]


def _texts(place: Sequence[Fraction]) -> list[str]:
    return [str(c) for c in place]
