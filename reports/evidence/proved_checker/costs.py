"""Costs of sums by the extracted program as both operands grow, beside the reference: stars,
combs, random polygons, and plates with holes and stars."""

from __future__ import annotations

import json
import math
import random
import resource
import time
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core, proved_program
from minkref.exact import digest
from minkref.fuzz.geometry.plane import Ring, box
from minkref.fuzz.plane.families import outlines
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.fuzz.plane.families.integer_rings import scattered, untangled
from minkref.output.documents import replacing
from minkref.reports.evidence.certificates.certified_cases import star
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.proved_checker.sums import is_absent
from minkref.reports.proved_cost_plot import draw

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(None, 0.5, 8)
ALONE = True

SEED = 1133
SCALE = "7/5"
SIZES = (8, 12, 20, 28, 40, 60, 80)  # corners of each of both operands
MOST, LONGEST = Counts(0, 4, 7), 60.0  # sizes; seconds after which a family ends
WANTED = Counts(0, 28, 60)
SHORT, AGAIN = 0.5, 5  # a sum in fewer seconds is timed so often, and the least is told
PLOT = ROOT / "docs" / "proved-costs.svg"


def comb(corners: int, seed: int) -> _core.PolygonSet:
    """Teeth and gaps of different widths; upright for an even seed."""
    dice = random.Random(seed)
    widths, gaps = ([Fraction(dice.randint(4, 9), 3) for _ in range(corners // 4)] for _ in "ab")
    ring = outlines.comb(dice, widths, gaps[1:])
    return _set([[(-y, x) for x, y in ring] if seed % 2 else ring])


def plate(corners: int, seed: int) -> _core.PolygonSet:
    """A square with square holes in rows, or for an even seed a star that leaves them open."""
    if seed % 2 == 0:
        return star(corners, seed)
    holes = corners // 4 - 1
    side = math.isqrt(max(holes - 1, 0)) + 1
    cells = [(6000 * (k % side), 6000 * (k // side)) for k in range(holes)]
    outer = box(0, 0, 6000 * side, 6000 * side)
    return _set([outer, *(box(x + 1000, y + 1000, 4000, 4000) for x, y in cells)])


def scribble(corners: int, seed: int) -> _core.PolygonSet:
    """Random points of the grid, joined to a ring that does not meet itself."""
    dice = random.Random(seed)
    while True:
        ring = untangled(scattered(dice, corners, 10 * corners, 10 * corners))
        if ring is not None and len(ring) == corners:
            return _set([[*ring]])


def _set(rings: list[Ring]) -> _core.PolygonSet:
    return _core.read_text(shape_text([rings]), "json", "an operand")


FAMILIES: dict[str, Callable[[int, int], _core.PolygonSet]] = {
    "stars": star,
    "combs": comb,
    "random": scribble,
    "holes": plate,
}


def look(family: str, corners: int) -> dict[str, Any]:
    """Seconds of processor: the program's from start to end, the reference's for the sum alone."""
    P, Q = (FAMILIES[family](corners, SEED + k) for k in (0, 1))
    first, second = P.to_json(), Q.to_json()
    program, theirs = _least(lambda: proved_program.whole_sum(first, second, SCALE), _of_children)
    reference, ours = _least(lambda: _core.minkowski_sum(P, Q, SCALE), time.process_time)
    expected = (digest(ours.region.canonical_json()), ours.components, ours.holes)
    return {
        "family": family,
        "corners": corners,
        "program": program,
        "reference": reference,
        "components": ours.components,
        "holes": ours.holes,
        "same": (theirs["digest"], theirs["components"], theirs["holes"]) == expected,
    }


def _of_children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _least(answer: Callable[[], Any], clock: Callable[[], float]) -> tuple[float, Any]:
    times: list[float] = []
    while not times or (len(times) < AGAIN and min(times) < SHORT):
        began = clock()
        found = answer()
        times.append(clock() - began)
    return min(times), found


def run(findings: Findings, size: Size) -> None:
    if is_absent(findings):
        return
    rows: list[dict[str, Any]] = []
    for family in FAMILIES:
        for corners in SIZES[: size.of(MOST)]:
            rows.append(look(family, corners))
            print(json.dumps(rows[-1]), flush=True)
            if rows[-1]["program"] > LONGEST:
                break
    wrong = [f"{row['family']} of {row['corners']}" for row in rows if not row["same"]]
    findings.none("sums on which the program and the reference differ", wrong)
    for family in FAMILIES:
        own = [row for row in rows if row["family"] == family]
        last, wanted = own[-1], size.of(WANTED)
        findings.target(
            f"{family}: corners of each operand", last["corners"] >= wanted, wanted, last["corners"]
        )
        power = _power(own[-3], last)
        findings.figures[f"{family}: the cost grows at the end as the power of the corners"] = (
            f"{power:.1f}"
        )
        for row in own:
            findings.note(
                f"{family} of {row['corners']} x {row['corners']} corners, {row['holes']} holes: "
                f"{row['program']:.2f} s, the reference {row['reference']:.4f} s"
            )
    if size is Size.FULL:
        with replacing(PLOT) as temporary:
            draw(rows, temporary)


def _power(first: dict[str, Any], last: dict[str, Any]) -> float:
    growth = math.log(last["corners"] / first["corners"])
    return math.log(last["program"] / first["program"]) / growth
