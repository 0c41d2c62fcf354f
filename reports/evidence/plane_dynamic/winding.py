"""Random walks of the dynamic sum by winding numbers: after each step the winding numbers beside
all edges of the full convolution are those from scratch, and the sum is that of the reduced one."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.plane_dynamic.walks import operand

MINUTES = Minutes(0.1, 0.8, 8)

SEED = 30
PAIRS, STEPS = Counts(4, 60, 240), 18


def walk(index: int) -> dict[str, Any]:
    """Half the stops fall on event scales, half the pairs have holes."""
    dice = random.Random(f"minkref winding {SEED} {index}")
    holes = index % 2 == 1
    (first, m), (second, n) = operand(dice, holes), operand(dice, holes and dice.random() < 0.5)
    P, Q = _core.PolygonSet.from_json(first), _core.PolygonSet.from_json(second)
    full, reduced = _core.DynamicSum(P, Q, route="winding"), _core.DynamicSum(P, Q)
    scales = [scale for scale, _ in full.event_scales()]
    tally: Counter[str] = Counter(
        vertices=m + n,
        holes=holes,
        full_pair_events=full.counts()["pair_events"],
        reduced_pair_events=reduced.counts()["pair_events"],
        full_triple_events=full.counts()["triple_events"],
        reduced_triple_events=reduced.counts()["triple_events"],
    )
    faults = []
    if not holes and _boundary(full, full) != _boundary(reduced, full):
        faults.append("other boundary events")
    for step in range(STEPS):
        scale = str(Fraction(dice.randint(1, 400), dice.randint(1, 120)))
        if step % 2 == 0 and scales:
            scale = dice.choice(scales)
            tally["at_events"] += 1
        full.move_to(scale)
        tally["steps"] += 1
        faults += [wrong] if (wrong := full.difference_from_scratch()) else []
        static = _core.minkowski_sum(P, Q, scale, "paper")
        if _digest(full.sum()) != _digest(static):
            faults.append(f"at {scale}: another sum than by collision detection")
        if faults:
            break
    return {"tally": tally, "fault": {"P": first, "Q": second, "at": faults} if faults else None}


def _boundary(sums: _core.DynamicSum, full: _core.DynamicSum) -> list[Any]:
    """The boundary events, with edges numbered as in the full convolution."""
    number = {row: place for place, row in enumerate(full.edges())}
    edges = [number[row] for row in sums.edges()]
    return [
        (scale, change, sorted(edges[e] for e in which), place)
        for scale, change, which, place in sums.boundary_events()
    ]


def _digest(answer: _core.Sum) -> str:
    return digest(answer.region.canonical_json())


def run(findings: Findings, size: Size) -> None:
    pairs = size.of(PAIRS)
    total: Counter[str] = Counter()
    faults = []
    for result in in_processes(walk, range(pairs), each=10, what="walks by winding numbers"):
        total.update(result["tally"])
        if result["fault"]:
            faults.append(result["fault"])
    findings.figures |= {"seed": SEED, "pairs": pairs, **total, "faults": faults[:5]}
    findings.none("walks that leave the winding numbers or the sum from scratch", len(faults))
    findings.law("steps", total["steps"] >= pairs * STEPS, pairs * STEPS, total["steps"])
    findings.law(
        "stops on events", 2 * total["at_events"] >= total["steps"] - pairs, "half",
        f"{total['at_events']} of {total['steps']}",
    )  # fmt: skip
    findings.law("walks with holes", 2 * total["holes"] >= pairs - 1, "half", total["holes"])
