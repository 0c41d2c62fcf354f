"""The topology of random sums: constant between arrangement events, told at each of them."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.families.random_pairs import random_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import REFERENCE, Findings

SUBJECT = (
    "500 random pairs with holes: between consecutive arrangement events and at each of them the "
    "static sum has the holes and components of the timeline; every change is an event; the lives "
    "of holes and components add up to their numbers."
)
MINUTES = (1, 0.1)
DEPENDS = (*REFERENCE, "fuzz/families/integer_rings.py", "fuzz/families/random_pairs.py")

SEED = 541186
PAIRS, QUICK_PAIRS = 500, 12


def numbers(P: _core.PolygonSet, Q: _core.PolygonSet, scale: Fraction) -> tuple[int, int]:
    answer = _core.minkowski_sum(P, Q, str(scale))
    return answer.holes, answer.components


def look(index: int) -> dict[str, Any]:
    """One pair: how many intervals and events were looked at, and the first thing that is wrong."""
    pair = random_pair(SEED, 3 * index + 1)  # the generator's pairs with holes
    P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
    dynamic = _core.DynamicSum(P, Q)
    scales = [Fraction(scale) for scale, _ in dynamic.event_scales()]
    states = dynamic.state_counts()
    begins = [Fraction(begin) if begin is not None else Fraction(0) for begin, _ in states]
    tally: Counter[str] = Counter(scales=len(scales))
    told = {(Fraction(row[0]), row[1]) for row in dynamic.topology_events()}
    tally["topology events"] = len(dynamic.topology_events())
    wrong = None

    def fault(what: str) -> dict[str, Any]:
        return {"pair": pair.name, "P": pair.P, "Q": pair.Q, "what": what}

    state = 0
    before: tuple[int, int] | None = None
    for i in range(len(scales) + 1):
        low = scales[i - 1] if i else Fraction(0)
        high = scales[i] if i < len(scales) else 2 * low + 1
        while state + 1 < len(states) and begins[state + 1] <= low:
            state += 1
        holes, components, _, holes_at, components_at = states[state][1]
        between = numbers(P, Q, (low + high) / 2)
        if between != (holes, components):
            wrong = wrong or fault(f"between {low} and {high}")
        if i:
            at = numbers(P, Q, low)
            expected = (holes_at, components_at) if begins[state] == low else (holes, components)
            if at != expected:
                wrong = wrong or fault(f"at {low}")
            for kind, was, now in zip(
                ("hole", "component"), before or between, between, strict=True
            ):
                if was != now and (low, kind) not in told:
                    wrong = wrong or fault(f"a {kind} changes at {low} and no event tells")
        before = between
    for begin, (_, (holes, components, *_rest)) in zip(begins, states, strict=True):
        for kind, count in (("hole", holes), ("component", components)):
            alive = sum(
                (born is None or Fraction(born) <= begin)
                and (died is None or Fraction(died) > begin)
                for _, born, died in dynamic.lives(kind)
            )
            if alive != count:
                wrong = wrong or fault(f"{alive} {kind}s live above {begin}, {count} are there")
    return {"tally": tally, "fault": wrong}


def run(findings: Findings, quick: bool) -> None:
    pairs = QUICK_PAIRS if quick else PAIRS
    step = PAIRS // pairs  # the quick ones are spread evenly over all
    total: Counter[str] = Counter()
    faults = []
    chosen = range(0, PAIRS, step)
    for result in in_processes(look, chosen, each=20, what="pairs"):
        total.update(result["tally"])
        if result["fault"]:
            faults.append(result["fault"])
    findings.figures |= {"seed": SEED, "pairs": len(chosen), **total, "faults": faults[:5]}
    findings.none("pairs with a wrong topology somewhere", len(faults))
    findings.target("topology events seen", total["topology events"] > 0, "some",
                    total["topology events"])  # fmt: skip
