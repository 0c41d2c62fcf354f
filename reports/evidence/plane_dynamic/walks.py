"""Random walks of the dynamic sum, held against the static one after each step."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import set_json
from minkref.fuzz.plane.families.integer_rings import Ring, counter_clockwise, scattered, untangled
from minkref.fuzz.plane.families.random_pairs import random_holes
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.8, 6)

SEED = 2012
WALKS, STEPS = Counts(6, 130, 1000), 30
KINDS = ("pair", "parallel", "triple")


def operand(dice: random.Random, holes: bool) -> tuple[str, int]:
    """A grid polygon with 8 to 40 vertices, as JSON text, and the vertex count."""
    while True:
        grid = dice.choice((8, 12, 20))
        outer: Ring | None = None
        while outer is None:
            outer = untangled(scattered(dice, dice.randint(8, 24 if holes else 40), grid, grid))
        outer = counter_clockwise(outer)
        inner = random_holes(dice, outer, 3, dice.random() < 0.3) if holes else []
        count = len(outer) + sum(map(len, inner))
        if (holes and not inner) or not 8 <= count <= 40:
            continue
        dx, dy = dice.randint(-grid, 0), dice.randint(-grid, 0)
        shifted = [
            [(x + dx, y + dy) for x, y in ring] for ring in (outer, *(h[::-1] for h in inner))
        ]
        text = set_json([(shifted[0], shifted[1:])])
        try:
            _core.PolygonSet.from_json(text).validate("random operand")
        except _core.BadInput:
            continue
        return text, count


def walk(index: int) -> dict[str, Any]:
    dice = random.Random(f"minkref walk {SEED} {index}")
    holes = index % 2 == 1
    (first, m), (second, n) = operand(dice, holes), operand(dice, holes and dice.random() < 0.5)
    P, Q = _core.PolygonSet.from_json(first), _core.PolygonSet.from_json(second)
    dynamic = _core.DynamicSum(P, Q)
    scales: dict[str, list[str]] = {kind: [] for kind in KINDS}
    for scale, kinds in dynamic.event_scales():
        for kind in kinds:
            scales[kind].append(scale)
    tally: Counter[str] = Counter(vertices=m + n, holes=holes)
    up = Fraction(0)
    for step in range(STEPS):
        scale = str(Fraction(dice.randint(1, 400), dice.randint(1, 120)))
        kind = KINDS[dice.randrange(3)]
        if step % 3 == 0 and not scales[kind]:
            kind = "pair"
        if step % 3 == 0 and scales[kind]:
            scale = dice.choice(scales[kind])
            tally[kind] += 1
        tally["down" if Fraction(scale) < up else "up"] += 1
        up = Fraction(scale)
        report = dynamic.move_to(scale)
        for name in ("insertions", "deletions", "swaps"):
            tally[name] += report[name]
        wrong = dynamic.difference_from_scratch()
        if wrong:
            return {"tally": tally, "fault": {"walk": index, "P": first, "Q": second, "at": wrong}}
    return {"tally": tally, "fault": None}


def run(findings: Findings, size: Size) -> None:
    walks = size.of(WALKS)
    total: Counter[str] = Counter()
    faults = []
    for result in in_processes(walk, range(walks), each=20, what="walks"):
        total.update(result["tally"])
        if result["fault"]:
            faults.append(result["fault"])
    steps = total["up"] + total["down"]
    at_events = sum(total[kind] for kind in KINDS)
    findings.figures |= {"seed": SEED, "walks": walks, **total, "faults": faults[:5]}
    findings.none("walks that leave the static arrangement or sum", len(faults))
    findings.law("steps", steps >= walks * STEPS, walks * STEPS, steps)
    findings.law("stops on events", 3 * at_events >= steps, "a third", f"{at_events} of {steps}")
    reached = ", ".join(f"{kind} {total[kind]}" for kind in KINDS)
    findings.target("of each kind", all(total[kind] for kind in KINDS), "some", reached)
    findings.target(
        "in both directions", min(total["up"], total["down"]) > steps // 4, "a quarter at least",
        f"{total['up']} up, {total['down']} down",
    )  # fmt: skip
    findings.law("walks with holes", 2 * total["holes"] >= walks - 1, "half", total["holes"])
