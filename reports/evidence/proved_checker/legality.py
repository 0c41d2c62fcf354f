"""Operands that the extracted program takes: legal ones are answered, illegal ones refused, as by
the reference. Lists of rings on small lattices, and the family `invalid` of `verify`."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.geometry.plane import Ring, Shape, doubled_area
from minkref.fuzz.invalid.family import invalid_pair
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.integer_rings import scattered, untangled
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.proved_checker.sums import answers, is_absent

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(0.1, 0.4, 4)

SEED = 1132
LISTS, PAIRS = Counts(300, 5000, 50_000), Counts(40, 400, 2000)
LEAST = 0.25  # of the lists are legal, and as many are not
LATTICES = (4, 6, 8)  # steps along a side
POINT = '{"polygons":[{"outer":[["0","0"]],"holes":[]}]}'
TRIANGLE = '{"polygons":[{"outer":[["0","0"],["1","0"],["0","1"]],"holes":[]}]}'
INVALID, REFUSED, OTHERWISE = "invalid", "malformed", "for another reason"
BATCH = 50  # for one run of the program
WHYS = {
    "is not legal": "by the test that is proved",
    "runs the wrong way": "by the reader: wrong way around",
    "of too few vertices": "by the reader: too few vertices",
}


def drawn(index: int) -> tuple[str, str]:
    """A list of one to three rings, beside a point or a triangle; no rule is kept but by chance."""
    dice = Dice(f"minkref legality {SEED} {index}")
    side = dice.choice(LATTICES)
    shape: Shape = []
    windows = [(0, side)]  # where rings are drawn; later ones within earlier ones
    count = dice.choice((1, 1, 2, 2, 3, 3, 3))
    for more in reversed(range(count)):
        low, high = windows[-1] if dice.random() < 0.85 else (0, side)
        ring = _ring(dice, low, high, 0.7 if more else 0.1)
        is_hole = bool(shape) and dice.random() < (0.8 if len(shape[-1]) == 1 else 0.4)
        if ((doubled_area(ring) < 0) == is_hole) == (dice.random() < 0.03):
            ring = ring[::-1]
        if is_hole:
            shape[-1].append(ring)
        else:
            shape.append([ring])
        if high - low > 2:
            windows.append((low + (dice.random() < 0.8), high - 1))
    is_thin = len(shape) == 1 and len(shape[0]) == 1 and len(shape[0][0]) < 3
    return _text(shape), TRIANGLE if is_thin or dice.random() < 0.5 else POINT


def _ring(dice: Dice, low: int, high: int, frames: float) -> Ring:
    """The frame of its window, a simple ring, or any points one after another."""
    width = high - low
    if dice.random() < frames:
        return [(low, low), (high, low), (high, high), (low, high)]
    if dice.random() < 0.75:
        found = untangled(scattered(dice, dice.randint(3, 7), width, width))
        if found is not None:
            return [(x + low, y + low) for x, y in found]
    count = dice.randint(1, 2) if dice.random() < 0.05 else dice.randint(3, 6)
    return [(dice.randint(low, high), dice.randint(low, high)) for _ in range(count)]


def _text(shape: Shape) -> str:
    """JSON, rings as they are drawn."""
    rows = [[[[str(x), str(y)] for x, y in ring] for ring in polygon] for polygon in shape]
    polygons = [{"outer": outer, "holes": holes} for outer, *holes in rows]
    return json.dumps({"polygons": polygons}, separators=(",", ":"))


def judge(tasks: Sequence[tuple[str, int]]) -> dict[str, Any]:
    """Both sets as the first and as the second operand, in one run of the program."""
    pairs = [_pair(*task) for task in tasks]
    tally: Counter[str] = Counter()
    faults = []
    told = answers("--sum", [f'{{"P": {P}, "Q": {Q}, "scale": "1"}}' for P, Q in pairs])
    for (family, index), (P, Q), said in zip(tasks, pairs, told, strict=True):
        name = f"{family} {index}"
        if why := _refusal(P) or _refusal(Q):
            tally[f"illegal: {why}"] += 1
            if said.get("verdict") != REFUSED or "polygons" in said:
                faults.append(f"{name}, {why}: taken")
            found = [by for part, by in WHYS.items() if part in said.get("why", "")]
            tally[f"refused: {found[0] if found else OTHERWISE}"] += 1
            continue
        first, second = (_core.PolygonSet.from_json(text) for text in (P, Q))
        ours = _core.minkowski_sum(first, second, "1")
        rings = sum(1 + len(each["holes"]) for text in (P, Q) for each in _polygons(text)) - 1
        tally["legal"] += 1
        tally[f"legal of {rings} ring{'s'[: rings > 1]}"] += 1
        expected = (digest(ours.region.canonical_json()), ours.components, ours.holes)
        if (said.get("digest"), said.get("components"), said.get("holes")) != expected:
            faults.append(f"{name}, legal: not answered as by the reference")
    return {"tally": tally, "faults": faults}


def _pair(family: str, index: int) -> tuple[str, str]:
    if family == INVALID:
        return invalid_pair(SEED, index)[1:]
    P, Q = drawn(index)
    return (P, Q) if index % 2 else (Q, P)


def _polygons(text: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(text)["polygons"]
    return found


def _refusal(text: str) -> str:
    """The code of the reference's refusal; empty if the operand is legal."""
    try:
        _core.PolygonSet.from_json(text).validate("an operand")
    except _core.BadInput as error:
        return str(error.code)
    return ""


def run(findings: Findings, size: Size) -> None:
    if is_absent(findings):
        return
    for family, what, count in (
        ("lists", "lists of one to three rings", size.of(LISTS)),
        (INVALID, "pairs of the family `invalid`", size.of(PAIRS)),
    ):
        tally: Counter[str] = Counter()
        faults: list[str] = []
        tasks = [(family, index) for index in range(count)]
        batches = [tasks[k : k + BATCH] for k in range(0, count, BATCH)]
        for found in in_processes(judge, batches, 20, f"batches of {BATCH} {what}"):
            tally += found["tally"]
            faults += found["faults"]
        findings.none(f"{what} on which the program and the reference differ ({SEED=})", faults)
        legal, illegal = tally["legal"], count - tally["legal"]
        if family == "lists":
            least = round(LEAST * count)
            for name, reached in (("legal", legal), ("illegal", illegal)):
                findings.law(f"{what}: {name}", reached >= least, f"{least:,}", f"{reached:,}")
        else:
            findings.equal(f"{what}: illegal", count, illegal)
        findings.none(f"{what}: refused {OTHERWISE}", tally[f"refused: {OTHERWISE}"])
        for kind in ("legal", "illegal", "refused"):
            kinds = [name for name in sorted(tally) if name.startswith((f"{kind}:", f"{kind} "))]
            if kinds:
                counts = ", ".join(
                    f"{tally[name]:,} {name[len(kind) + 1 :].strip()}" for name in kinds
                )
                findings.note(f"{what}: {kind}: {counts}")
