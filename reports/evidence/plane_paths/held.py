"""Held scales of random assemblies, before decisions at single scales."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import minkref
from minkref.fuzz.judges.motion.held_cases import KINDS, HeldCase, held_case
from minkref.fuzz.judges.motion.held_scales import (
    scales_beside,
    wrong_ends,
    wrong_scales,
    wrong_stops,
)
from minkref.fuzz.motion.path_collisions import Collisions, Decide, by_slow_engine, by_triangles
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1.0, 5)

SEED = 3150
CASES = Counts(16, 130, 1000)
SLOW = Counts(8, 32, 240)
SLOW_SCALES = 4
CONTACTS = ("allowed", "forbidden")


def run(findings: Findings, size: Size) -> None:
    count, slow = size.of(CASES), size.of(SLOW)
    tally: Counter[str] = Counter()
    wrong: list[str] = []
    held: Counter[str] = Counter()
    tasks = [(index, index < slow) for index in range(count)]
    for found in in_processes(judge, tasks, 50, "assemblies"):
        tally.update(found["tally"])
        wrong += found["faults"]
        held.update(found["held"])
    findings.none("random assemblies: answers that differ from decisions at single scales", wrong)
    findings.equal("random assemblies", count, tally["cases"])
    findings.law(
        "half of them degenerate", 2 * tally["degenerate"] >= count, f"{count / 2:g}",
        tally["degenerate"],
    )  # fmt: skip
    findings.law(
        "kinds of assemblies that hold some part", len(held) == len(KINDS) - 2,
        f"all of {len(KINDS)}, but for ways that stay and ends that coincide", len(held),
    )  # fmt: skip
    findings.note(
        f"{tally['cases']:,} assemblies ({tally['degenerate']:,} degenerate, seed {SEED}), contact "
        f"allowed and forbidden: {tally['ranges']:,} ranges of held scales, {tally['single']:,} "
        f"single scales among them, {tally['stops']:,} stops; {tally['scales']:,} scales decided "
        f"from the definition, {tally['slow scales']:,} also by the slow engine"
    )
    findings.figures["assemblies"] = {**tally, "held": dict(held)}


def judge(task: tuple[int, bool]) -> dict[str, Any]:
    """One assembly, with contact allowed and forbidden."""
    index, slowly = task
    case = held_case(SEED, index)
    tally: Counter[str] = Counter(cases=1, degenerate=int(case.is_degenerate))
    held: Counter[str] = Counter()
    faults: list[str] = []
    for contact in CONTACTS:
        told = f"{case.name} ({case.kind}), {contact}"
        found = minkref.held_scales(case.part, case.obstacles, case.way, contact)
        other = minkref.held_scales(case.part, case.obstacles, case.way, contact, route="contacts")
        if other.ranges != found.ranges:
            faults.append(f"{told}: the routes differ")
        decided = _decided(case, contact, by_triangles(case.part, case.obstacles))
        scales = scales_beside(found)
        faults += [
            f"{told}: {fault}"
            for fault in (
                *wrong_scales(found, case.way, scales, decided),
                *wrong_stops(found, case.way, contact, decided),
                *wrong_ends(found),
            )
        ]
        tally["scales"] += len(scales)
        tally["ranges"] += len(found.held)
        tally["stops"] += len(found.held)
        tally["single"] += sum(one.low == one.high for one in found.ranges)
        if found.held:
            held[case.kind] += 1
        if slowly:
            few = random.Random(case.name).sample(scales, min(SLOW_SCALES, len(scales)))
            tally["slow scales"] += len(few)
            engine = _decided(case, contact, by_slow_engine(case.part, case.obstacles))
            faults += [f"{told}, slow: {one}" for one in wrong_scales(found, case.way, few, engine)]
    return {"tally": tally, "faults": faults, "held": held}


def _decided(case: HeldCase, contact: str, decide: Decide) -> Any:
    def collides(way: Sequence[Any], scale: Fraction) -> bool:
        return Collisions(case.part, case.obstacles, way).collides(scale, contact, decide)

    return collides
