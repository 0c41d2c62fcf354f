"""Valid scales of paths in space, and speed."""

from __future__ import annotations

import math
import random
import time
from collections import Counter
from fractions import Fraction
from typing import Any

import minkref
from minkref import _core
from minkref.fuzz.judges.motion.space_path_cases import SpacePathCase, space_path_case
from minkref.fuzz.judges.motion.space_path_collisions import StaticSum, by_slow_engine
from minkref.fuzz.space.exact_sum import core_polyhedron
from minkref.fuzz.space.generators.tube import wide_knot
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.8, 5)

SEED = 3300
CASES = Counts(2, 30, 210)
SLOW = Counts(1, 12, 84)
KNOT = Counts((31, 4), (62, 8), (62, 8))  # stretches, section
HAIR = Fraction(1, 1 << 20)
CONTACTS = ("allowed", "forbidden")
SLOW_SCALES = 4
TARGET_SECONDS = 2.0


def run(findings: Findings, size: Size) -> None:
    _cases(findings, size.of(CASES), size.of(SLOW))
    _speed(findings, size.of(KNOT))


def _cases(findings: Findings, count: int, slow: int) -> None:
    tally: Counter[str] = Counter()
    faults: list[str] = []
    tasks = [(index, index < slow) for index in range(count)]
    for found in in_processes(judge, tasks, 30, "paths in space"):
        tally.update(found["tally"])
        faults += found["faults"]
    findings.none("random paths in space: answers that differ", faults)
    findings.equal("random paths in space", count, tally["cases"])
    judged = tally["slow cases"]  # skips operands without volume
    findings.law("of them before the slow engine", judged * 2 > slow, f"half of {slow}", judged)
    findings.equal("scales that could not be decided", 0, tally["refused"])
    findings.note(
        f"{tally['cases']:,} random paths ({tally['degenerate']:,} degenerate, {tally['thin']:,} "
        f"with a point or a segment, seed {SEED}), contact allowed and forbidden: "
        f"{tally['ranges']:,} ranges, {tally['single']:,} single scales, {tally['bounds']:,} "
        f"bounds, at which {tally['vertex-face']:,} times a vertex and a face touch, "
        f"{tally['edge-edge']:,} times two edges; {tally['scales']:,} scales by static sums, "
        f"{tally['slow scales']:,} by the slow engine"
    )
    findings.figures["cases"] = dict(tally)


def judge(task: tuple[int, bool]) -> dict[str, Any]:
    """One case, with contact allowed and forbidden."""
    index, slowly = task
    case = space_path_case(SEED, index)
    tally: Counter[str] = Counter(cases=1)
    tally["degenerate"] += case.kind != "general"
    tally["thin"] += case.is_thin
    tally["slow cases"] += slowly and not case.is_thin
    part, obstacles = core_polyhedron(case.part), core_polyhedron(case.obstacles)
    faults = []
    for contact in CONTACTS:
        found = minkref.valid_scales(part, obstacles, case.path, contact)
        other = minkref.valid_scales(part, obstacles, case.path, contact, route="contacts")
        if other.ranges != found.ranges:
            faults.append(f"{case.name} ({case.kind}), {contact}: the routes differ")
        tally["ranges"] += len(found.ranges)
        tally["single"] += sum(one.low == one.high for one in found.ranges)
        tally["bounds"] += len(found.bounds)
        for bound in found.bounds:
            tally["-".join(sorted((bound.part.kind, bound.obstacle.kind), reverse=True))] += 1
        faults += _scales(case, contact, found, slowly, tally)
    tally["vertex-face"] = tally.pop("vertex-face", 0) + tally.pop("face-vertex", 0)
    return {"tally": tally, "faults": faults}


def _scales(
    case: SpacePathCase,
    contact: str,
    found: minkref.SpaceValidScales,
    slowly: bool,
    tally: Counter[str],
) -> list[str]:
    scales = {Fraction(1, 50), Fraction(1)}
    for bound in found.bounds:
        scales |= {bound.scale, bound.scale * (1 - HAIR), bound.scale * (1 + HAIR)}
    for one in found.ranges:
        scales.add((one.low + one.high) / 2 if one.high is not None else 2 * one.low + 1)
    faults = []
    for scale in sorted(scales):
        tally["scales"] += 1
        try:
            collides = StaticSum(case, scale, contact).meets(case.path)
        except minkref.LimitExceeded:
            tally["refused"] += 1
            continue
        if collides == (scale in found):
            faults.append(f"{case.name} ({case.kind}), {contact}: wrong at {scale}")
    if slowly and not case.is_thin:
        dice = random.Random(case.name)
        for scale in dice.sample(sorted(scales), min(SLOW_SCALES, len(scales))):
            tally["slow scales"] += 1
            if by_slow_engine(case, scale, contact) == (scale in found):
                faults.append(f"{case.name}, {contact}: the slow engine differs at {scale}")
    return faults


def _speed(findings: Findings, knot: tuple[int, int]) -> None:
    """Times two paths: a star-like part on 100 segments between balls in a grid; and a knot, where
    finding the convex pieces takes longest."""
    part, obstacles, path = among_balls()
    seconds, told, figures = _timed(part, obstacles, path)
    findings.target(
        f"a path of {len(path) - 1} segments among {obstacles.faces:,} faces, a part of "
        f"{part.faces}, on one core",
        seconds < TARGET_SECONDS, f"below {TARGET_SECONDS:g} s", f"{seconds:.2f} s",
    )  # fmt: skip
    findings.note(f"balls: {told}")
    findings.figures["balls"] = figures
    part, obstacles, path = through_a_knot(*knot)
    began = time.process_time()
    _core.convex_pieces(obstacles)
    pieces = time.process_time() - began
    seconds, told, figures = _timed(part, obstacles, path)
    findings.note(
        f"a knot of {obstacles.faces:,} faces, {len(path) - 1} segments: {seconds:.2f} s, of which "
        f"the convex pieces take {pieces:.2f} s; {told}"
    )
    findings.figures["knot"] = figures | {"pieces_seconds": pieces}


def _timed(
    part: minkref.Polyhedron, obstacles: minkref.Polyhedron, path: Path
) -> tuple[float, str, dict[str, Any]]:
    began = time.process_time()
    found = minkref.valid_scales(part, obstacles, path)
    seconds = time.process_time() - began
    counts = found.statistics
    told = (
        f"{counts['triples']:,} triples of {counts['pieces_of_part']} and "
        f"{counts['pieces_of_obstacles']} convex pieces, {counts['exact_triples']:,} of them "
        f"exact; valid: {', '.join(map(str, found.ranges))}"
    )
    return seconds, told, {"seconds": seconds, **counts}


Path = list[tuple[int, int, int]]
Mesh = tuple[Path, list[list[int]]]


def among_balls() -> tuple[minkref.Polyhedron, minkref.Polyhedron, Path]:
    dice = random.Random(SEED)
    part = minkref.Polyhedron(*_ball(8, 6, 1000, (0, 0, 0), dice))
    vertices: list[tuple[int, int, int]] = []
    faces: list[list[int]] = []
    for i in range(27):
        at = 10000 * (i // 9), 10000 * (i // 3 % 3), 10000 * (i % 3)
        ball = _ball(6, 4, 2000, at)
        faces += [[k + len(vertices) for k in face] for face in ball[1]]
        vertices += ball[0]
    path = [(5000 + k % 3 * 100, 5000 - k % 5 * 100, -8000 + 360 * k) for k in range(101)]
    return part, minkref.Polyhedron(vertices, faces), path


def through_a_knot(
    stretches: int, section: int
) -> tuple[minkref.Polyhedron, minkref.Polyhedron, Path]:
    """A part with two arms on a helix through the middle of a trefoil."""
    knot = wide_knot(2, 3, stretches, section, 1000)
    angle = minkref.Polyhedron(
        [(-2, -2, -1), (3, -2, -1), (3, 0, -1), (0, 0, -1), (0, 3, -1), (-2, 3, -1),
         (-2, -2, 1), (3, -2, 1), (3, 0, 1), (0, 0, 1), (0, 3, 1), (-2, 3, 1)],
        [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11], [0, 1, 7, 6], [1, 2, 8, 7], [2, 3, 9, 8],
         [3, 4, 10, 9], [4, 5, 11, 10], [5, 0, 6, 11]],
    )  # fmt: skip
    reach = max(abs(v[2]) for v in knot.vertices)
    path = [
        (
            round(float(reach) / 8 * math.cos(k / 4)),
            round(float(reach) / 8 * math.sin(k / 4)),
            round(float(reach) * (k - 25) / 12),
        )
        for k in range(51)
    ]
    return angle, core_polyhedron(knot), path


def _ball(
    around: int, high: int, radius: int, at: tuple[int, int, int], dice: random.Random | None = None
) -> Mesh:
    """Triangles between rings, each turned by half a step; with dice, of uneven radius."""

    def point(height: float, turn: float) -> tuple[int, int, int]:
        r = radius * (1 if dice is None else dice.uniform(0.75, 1.25))
        x, y = r * math.sin(height) * math.cos(turn), r * math.sin(height) * math.sin(turn)
        return at[0] + round(x), at[1] + round(y), at[2] + round(r * math.cos(height))

    points = [point(0, 0)]
    for i in range(1, high):
        for k in range(around):
            points.append(point(math.pi * i / high, 2 * math.pi * (k + i % 2 / 2) / around))
    points.append(point(math.pi, 0))

    def name(i: int, k: int) -> int:
        return 1 + (i - 1) * around + k % around

    faces = []
    last = len(points) - 1
    for k in range(around):
        faces.append([0, name(1, k), name(1, k + 1)])
        faces.append([last, name(high - 1, k + 1), name(high - 1, k)])
        for i in range(1, high - 1):
            a, b, c, d = name(i, k), name(i, k + 1), name(i + 1, k), name(i + 1, k + 1)
            faces += [[a, c, b], [b, c, d]] if i % 2 == 0 else [[a, c, d], [a, d, b]]
    return points, faces
