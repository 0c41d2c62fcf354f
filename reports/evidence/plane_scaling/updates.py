"""Convex polygons under changing factors for each axis: updates beside sums from scratch."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.fuzz.plane.families.drawing import convex, shape_text
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1, 3)

SEED = 609
WALKS, STEPS = Counts(10, 200, 1000), 20
CORNERS = Counts(200, 2_000, 20_000)  # of the polygons whose costs are measured
NEAR = Fraction(1, 10**4)  # relative change of a factor, in small steps


def polygon(dice: random.Random, corners: int, reach: int) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(shape_text([[convex(dice, corners, reach)]]))


def scale_text(x: Fraction, y: Fraction) -> str:
    return f"{x},{y}"


def exactness(findings: Findings, walks: int) -> None:
    """After each update the sum and the pairs are those from scratch."""
    dice = random.Random(SEED)
    tally: Counter[str] = Counter()
    for _ in range(walks):
        reach = dice.choice((2, 3, 9, 100))  # small ones have parallel edges at many scales
        P, Q = (polygon(dice, dice.randint(3, 12), reach) for _ in "PQ")
        moving = _core.DynamicPolygonSum(P, Q, "1")
        for _ in range(STEPS):
            x, y = (Fraction(dice.randint(1, 9), dice.randint(1, 6)) for _ in "xy")
            did = moving.update(scale_text(x, y))
            fresh = _core.DynamicPolygonSum(P, Q, scale_text(x, y))
            static = _core.minkowski_sum(P, Q, scale_text(x, y)).region
            text = moving.sum().region.canonical_json()
            tally["updates"] += 1
            tally["errors mended"] += did["ev_errors"] + did["ve_errors"]
            tally["other sums"] += text != static.canonical_json()
            tally["other pairs"] += moving.pairs() != fresh.pairs()
    findings.figures["walks"] = dict(tally)
    findings.none("updates after which the sum is not the static one", tally["other sums"])
    findings.none("updates after which pairs are not those from scratch", tally["other pairs"])
    findings.law("errors mended", tally["errors mended"] > 0, "some", tally["errors mended"])


def cost(findings: Findings, corners: int) -> None:
    """A small step of large polygons changes few pairs, and costs few descents."""
    dice = random.Random(SEED + 1)
    P, Q = (polygon(dice, corners, 10**9) for _ in "PQ")
    moving = _core.DynamicPolygonSum(P, Q, "1")
    edges = sum(len(of) for of in moving.pairs())
    changed = 0
    small = []
    for k in range(1, 51):
        before = moving.pairs()
        small.append(moving.update(scale_text(1 + k * NEAR, Fraction(1))))
        changed += sum(
            one != other
            for old, new in zip(before, moving.pairs(), strict=True)
            for one, other in zip(old, new, strict=True)
        )
    large = [moving.update(scale_text(Fraction(k % 7 + 1), Fraction(k % 5 + 1))) for k in range(20)]
    rows = {}
    for name, steps in (("small steps", small), ("large steps", large)):
        errors = sum(did["ev_errors"] + did["ve_errors"] for did in steps)
        seconds = sum(did["seconds"] for did in steps)
        rows[name] = {
            "updates": len(steps),
            "errors": errors,
            "descent steps": sum(did["descent_steps"] for did in steps),
            "microseconds": round(seconds / len(steps) * 1e6, 2),
        }
    findings.figures[f"{edges} edges"] = rows
    findings.equal(
        f"errors that 50 small steps of {edges} edges find, for pairs that change", changed,
        rows["small steps"]["errors"],
    )  # fmt: skip
    faster = rows["small steps"]["microseconds"] * 10 < rows["large steps"]["microseconds"]
    findings.target("small steps cost a tenth of large ones", faster, "less", str(rows))


def run(findings: Findings, size: Size) -> None:
    exactness(findings, size.of(WALKS))
    cost(findings, size.of(CORNERS))
