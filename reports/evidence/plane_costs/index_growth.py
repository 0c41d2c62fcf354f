"""The index of all scales as the convolution grows: combs, stars, spirals."""

from __future__ import annotations

import json
import math
import multiprocessing
import random
import tempfile
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from statistics import fmean
from typing import Any

from minkref import _core
from minkref.output.documents import replacing
from minkref.reports.bench.index import query_scales
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.index_growth_plot import draw

MINUTES = Minutes(None, 1, 15)
ALONE = True

WINDOW = ("1/2", "2")
PLOT = Path("reports/evidence/index_growth.svg")
WANTED_EDGES = Counts(0, 10_000, 1_000_000)
LONGEST = Counts(0.0, 3.0, 100.0)  # build seconds after which a family ends
QUERIES, PASSES = 20, 5
SIZES = (8, 16, 24, 36, 52, 76, 110, 160, 240, 350, 580)
# Edges; above this count the arrangement exceeds memory, so points are tried.
MOST_STATIC = 6000
POINTS = 60


def shape(points: list[tuple[float, float]]) -> _core.PolygonSet:
    ring = [[str(round(x)), str(round(y))] for x, y in points]
    return _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": ring, "holes": []}]}))


def star(spikes: int, seed: int) -> _core.PolygonSet:
    dice = random.Random(seed)
    points = []
    for k in range(2 * spikes):
        angle = math.pi * k / spikes + seed / 10
        reach = 10**6 * ((0.5 if k % 2 else 1) + dice.uniform(-0.03, 0.03))
        points.append((reach * math.cos(angle), reach * math.sin(angle)))
    return shape(points)


def comb(teeth: int, seed: int) -> _core.PolygonSet:
    """Upright for an even seed."""
    dice = random.Random(seed)
    width = 10**6 / (2 * teeth)
    points: list[tuple[float, float]] = []
    for k in range(teeth):
        x, height = 2 * k * width, 10**6 * (0.6 + dice.uniform(-0.05, 0.05))
        shifts = [dice.uniform(-0.1, 0.1) * width for _ in range(4)]
        points += [
            (x + shifts[0], 0),
            (x + 0.2 * width + shifts[1], height),
            (x + 0.8 * width + shifts[2], height * 1.01),
            (x + width + shifts[3], 0),
        ]
    ring = [(-width, -(10**5)), (10**6, -(10**5)), (10**6, 0), *points[::-1], (-width, 0)]
    return shape([(-y, x) for x, y in ring] if seed % 2 == 0 else ring)


def spiral(steps: int, seed: int) -> _core.PolygonSet:
    """A band with three turns."""
    outer: list[tuple[float, float]] = []
    inner: list[tuple[float, float]] = []
    for k in range(4 * steps):
        share = k / (4 * steps - 1)
        angle = 6 * math.pi * share + seed
        reach = 10**6 * (0.1 + 0.9 * share)
        for ring, side in ((outer, 1), (inner, -1)):
            own = reach + side * 4e4
            ring.append((own * math.cos(angle), own * math.sin(angle)))
    return shape(outer + inner[::-1])


FAMILIES: dict[str, Callable[[int, int], _core.PolygonSet]] = {
    "combs": comb,
    "stars": star,
    "spirals": spiral,
}


def difference(
    index: _core.ScaleIndex, P: _core.PolygonSet, Q: _core.PolygonSet, scale: str
) -> str:
    """The scale, if the sum differs from the static sum, or, for large sums, if points near the
    boundary contradict the operands' collision; else an empty text."""
    counts = index.counts()
    if counts["s_edges"] + counts["t_edges"] <= MOST_STATIC:
        return str(index.first_difference([scale]))
    region = index.sum(scale).region
    ring = json.loads(region.to_json())["polygons"][0]["outer"]
    dice = random.Random(scale)
    rows = []
    for _ in range(POINTS):
        k = dice.randrange(len(ring))
        (ax, ay), (bx, by) = ((Fraction(x), Fraction(y)) for x, y in (ring[k - 1], ring[k]))
        off = Fraction(dice.choice((-1, 1)), 10 ** dice.randrange(2, 7))
        rows.append((str((ax + bx) / 2 + off * (by - ay)), str((ay + by) / 2 - off * (bx - ax))))
    own = _core.decide_many(region, shape([(0, 0)]), "1", rows)
    return "" if own == _core.decide_many(P, Q, scale, rows) else scale


def look(task: tuple[str, int]) -> dict[str, Any]:
    family, size = task
    make = FAMILIES[family]
    P, Q = make(size, 1), make(size, 2)
    index = _core.ScaleIndex(P, Q, *WINDOW)
    scales = [s for s in query_scales(1, 4 * QUERIES) if 0.5 <= _near(s) <= 2][:QUERIES]
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "index")
        index.save(path)
        timed = _core.timed_index_queries(path, scales, PASSES)
    counts = dict(index.counts())
    return {
        "family": family,
        "size": size,
        "edges": counts["s_edges"] + counts["t_edges"],
        "boundary_events": counts["boundary_events"],
        "build_seconds": index.seconds,
        "bytes": counts["bytes"],
        "vertices": fmean(row[2] for row in timed["double"]),
        "query_seconds": fmean(row[0] for row in timed["double"]),
        "wrong": difference(index, P, Q, scales[0]),
    }


def _near(scale: str) -> float:
    num, _, den = scale.partition("/")
    return int(num) / int(den or 1)


def run(findings: Findings, size: Size) -> None:
    rows: list[dict[str, Any]] = []
    longest = size.of(LONGEST)
    for family in FAMILIES:
        for number in SIZES:
            with multiprocessing.get_context("spawn").Pool(1) as pool:
                try:
                    row = pool.apply_async(look, ((family, number),)).get(timeout=3 * longest)
                except multiprocessing.TimeoutError:
                    findings.note(f"{family} of size {number}: not built in {3 * longest:.0f} s")
                    break
            print(json.dumps(row), flush=True)
            rows.append(row)
            if row["build_seconds"] > longest:
                break
    wrong = [f"{row['family']} {row['size']} at {row['wrong']}" for row in rows if row["wrong"]]
    findings.none("sums that differ", wrong)
    findings.note(
        f"at one scale each, from the static sum up to {MOST_STATIC:,} edges; beyond, {POINTS} "
        "points next to the boundary are decided by triangles of the operands"
    )
    for family in FAMILIES:
        own = [row for row in rows if row["family"] == family]
        most = max(own, key=lambda row: row["edges"])
        wanted = size.of(WANTED_EDGES)
        findings.target(
            f"{family}: edges of the convolution",
            most["edges"] >= wanted,
            f"{wanted:,}",
            f"{most['edges']:,} in {most['build_seconds']:.0f} s",
        )
        first = own[max(0, len(own) - 3)]
        if most["edges"] > first["edges"]:
            power = math.log(most["build_seconds"] / first["build_seconds"]) / math.log(
                most["edges"] / first["edges"]
            )
            findings.note(
                f"{family}: the build grows as the {power:.2f}th power of the edges at the end"
            )
    findings.figures = {"rows": rows}
    if size is Size.FULL:
        with replacing(PLOT) as temporary:
            draw(rows, temporary)
