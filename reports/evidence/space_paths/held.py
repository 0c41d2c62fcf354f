"""Held scales in space before static sums; fits anywhere and traps before the plane's."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import minkref
from minkref.fuzz.judges.motion.held_scales import (
    scales_beside,
    wrong_ends,
    wrong_scales,
    wrong_stops,
)
from minkref.fuzz.judges.motion.space_path_cases import space_path_case
from minkref.fuzz.judges.motion.space_path_collisions import StaticSum, by_slow_engine
from minkref.fuzz.space.exact_sum import core_polyhedron
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 2, 8)

SEED = 3350
CASES = Counts(4, 50, 210)
PRISMS = Counts(2, 16, 60)
SLOW_SCALES = 3
CONTACTS = ("allowed", "forbidden")


def run(findings: Findings, size: Size) -> None:
    _held(findings, size.of(CASES))
    _prisms(findings, size.of(PRISMS))


def _held(findings: Findings, count: int) -> None:
    tally: Counter[str] = Counter()
    wrong: list[str] = []
    for found in in_processes(judge, range(count), 30, "assemblies in space"):
        tally.update(found["tally"])
        wrong += found["faults"]
    findings.none("assemblies in space: answers that differ from static sums", wrong)
    findings.equal("assemblies in space", count, tally["cases"])
    findings.note(
        f"{tally['cases']:,} assemblies in space ({tally['degenerate']:,} degenerate, seed "
        f"{SEED}): {tally['ranges']:,} ranges of held scales, each with its stop; "
        f"{tally['scales']:,} scales by static sums, {tally['slow scales']:,} by the slow engine"
    )
    findings.figures["assemblies"] = dict(tally)


def judge(index: int) -> dict[str, Any]:
    case = space_path_case(SEED, index)
    part, obstacles = core_polyhedron(case.part), core_polyhedron(case.obstacles)
    tally: Counter[str] = Counter(cases=1, degenerate=int(case.kind != "general"))
    faults: list[str] = []
    for contact in CONTACTS:
        found = minkref.held_scales(part, obstacles, case.path, contact)

        def static(way: Sequence[Any], scale: Fraction, contact: str = contact) -> bool:
            return StaticSum(case, scale, contact).meets(way)

        def slow(way: Sequence[Any], scale: Fraction, contact: str = contact) -> bool:
            return by_slow_engine(replace(case, path=list(way)), scale, contact)

        scales = scales_beside(found)
        several = [
            *wrong_scales(found, case.path, scales, static),
            *wrong_stops(found, case.path, contact, static),
            *wrong_ends(found),
        ]
        if not case.is_thin:
            few = random.Random(case.name).sample(scales, min(SLOW_SCALES, len(scales)))
            tally["slow scales"] += len(few)
            several += wrong_scales(found, case.path, few, slow)
        faults += [f"{case.name} ({case.kind}), {contact}: {one}" for one in several]
        tally["scales"] += len(scales)
        tally["ranges"] += len(found.held)
    return {"tally": tally, "faults": faults}


def _prisms(findings: Findings, count: int) -> None:
    tally: Counter[str] = Counter()
    wrong: list[str] = []
    for found in in_processes(judge_prism, range(count), 60, "prisms"):
        tally.update(found["tally"])
        wrong += found["faults"]
    findings.none("prisms: fits anywhere and traps that differ from the plane's", wrong)
    findings.equal("prisms", count, tally["cases"])
    findings.note(
        f"{count:,} prisms in containers that are not convex, and in rooms with a door, between a "
        f"floor and a ceiling: the scales are those of their sections, which the plane finds by an "
        f"index; {tally['trapped']:,} of the parts are trapped at some scale"
    )


def judge_prism(index: int) -> dict[str, Any]:
    """A convex polygon and its prism, somewhere in an angle, and trapped in a room."""
    dice = random.Random(f"{SEED}:prism:{index}")
    contact = CONTACTS[index % 2]
    outline = [
        (dice.randint(1, 4), -dice.randint(1, 3)), (dice.randint(1, 4), dice.randint(1, 3)),
        (-dice.randint(1, 4), dice.randint(1, 3)), (-dice.randint(1, 4), -dice.randint(1, 3)),
    ]  # fmt: skip
    flat, part = minkref.PolygonSet(outline), together(prism(outline, -1, 1))
    wide, high, thick = (dice.randint(6, 9) for _ in range(3))
    angle = [(0, 0), (wide, 0), (wide, thick // 3), (thick // 2, thick // 3 + 1), (3, high),
             (0, high)]  # fmt: skip
    faults = []
    expected = minkref.largest_fit(flat, minkref.PolygonSet(angle), contact=contact)
    found = minkref.largest_fit(part, together(prism(angle, 0, 99)), contact=contact)
    if found.ranges != expected.ranges:
        faults.append(f"prism {index}, {contact}: fits {found.ranges}, not {expected.ranges}")
    low = dice.randint(1, 9)
    walls = [(-1, -1), (13, -1), (13, low), (12, low), (12, 0), (0, 0), (0, 12), (12, 12),
             (12, low + 2), (13, low + 2), (13, 13), (-1, 13)]  # fmt: skip
    lid = [(-1, -1), (13, -1), (13, 13), (-1, 13)]
    slit = Fraction(1, 10)
    room = together(prism(walls, -40, 40), prism(lid, -42, -40 - slit), prism(lid, 40 + slit, 42))
    place = Fraction(dice.randint(10, 14), 2), Fraction(dice.randint(10, 14), 2)
    trap = minkref.trapped_scales(flat, minkref.PolygonSet(walls), place, contact)
    there = minkref.trapped_scales(part, room, (*place, 0), contact)
    if there.ranges != trap.ranges:
        faults.append(f"prism {index}, {contact}: trapped {there.ranges}, not {trap.ranges}")
    return {"tally": Counter(cases=1, trapped=int(bool(trap.ranges))), "faults": faults}


def prism(outline: Sequence[Any], low: Any, high: Any) -> tuple[list[Any], list[list[int]]]:
    n = len(outline)
    points = [(x, y, z) for z in (low, high) for x, y in outline]
    sides = [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)]
    return points, [list(range(n - 1, -1, -1)), *sides, list(range(n, 2 * n))]


def together(*solids: tuple[list[Any], list[list[int]]]) -> minkref.Polyhedron:
    points: list[Any] = []
    faces: list[list[int]] = []
    for more, rings in solids:
        faces += [[k + len(points) for k in ring] for ring in rings]
        points += more
    return minkref.Polyhedron(points, faces)
