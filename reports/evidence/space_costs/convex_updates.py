"""The cost of an update of a convex sum, against errors mended and against size."""

from __future__ import annotations

import random
from fractions import Fraction
from statistics import fmean, median
from typing import Any

from minkref import _core
from minkref.reports.convex_cost_plot import draw
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.space.operand import read_space_operand
from minkref.space.scaling import Scaling

MINUTES = Minutes(None, 0.3, 4)
ALONE = True
SIZES = (100, 200, 500, 1000, 2000, 5000, 10_000, 20_000)
MOST = Counts(0, 6, 8)  # of the sizes
STEPS = (1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0)
COUNT = 40
SIDES = 82  # of the rod
TURNED = ((3, -1, 1), (1, 4, -1), (-1, 1, 5))  # what makes the second body no copy of the first

Row = dict[str, Any]


def run(findings: Findings, size: Size) -> None:
    P, Q = (_barrel(2000, turned) for turned in (False, True))
    by_errors = sorted((_row(P, Q, step) for step in STEPS), key=lambda row: row["errors"])
    by_size = []
    for facets in SIZES[: size.of(MOST)]:
        P, Q = (_barrel(facets, turned) for turned in (False, True))
        by_size.append(_row(P, Q, 0.01))
        print(by_size[-1], flush=True)
    findings.figures = {"against errors": by_errors, "against size": by_size}
    largest, wanted = by_size[-1], SIZES[: size.of(MOST)][-1]
    findings.law("facets of the largest operands", largest["facets"] >= wanted, wanted,
                 largest["facets"])  # fmt: skip
    wrong = sum(row["differences"] for row in (*by_errors, *by_size))
    findings.none("updates that end in another state than from scratch", wrong)
    for row in by_errors:
        findings.note(f"{row['errors']:,.1f} errors: {_told(row)}")
    for row in by_size:
        findings.note(f"{row['facets']:,} facets each: {row['errors']:.1f} errors, {_told(row)}")
    if size is Size.FULL:
        draw(by_errors, by_size, ROOT / "reports" / "evidence" / "convex_costs.svg")


def _told(row: Row) -> str:
    return (
        f"update {row['update'] * 1e6:,.1f} µs, coordinates {row['coordinates'] * 1e6:,.1f}, from "
        f"scratch {row['traversal'] * 1e6:,.1f}"
    )


def _row(P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, step: float) -> Row:
    scalings = _walk(step)
    walk = dict(_core.timed_convex_walk(P, Q, scalings))
    errors = walk["fv_errors"] + walk["vf_errors"] + walk["ee_errors"]
    return {
        "facets": P.facets,
        "step": step,
        "errors": errors / COUNT,
        "vertex_pairs": fmean(walk["vertex_pairs"]),
        "update": median(walk["update_seconds"]),
        "coordinates": median(walk["coordinate_seconds"]),
        "traversal": median(walk["traversal_seconds"]),
        "differences": walk["differences"],
    }


def _walk(step: float) -> list[Scaling]:
    dice = random.Random(1)
    factors, scalings = [1.3, 0.9, 1.1], []
    for _ in range(COUNT + 1):
        x, y, z = (str(Fraction(round(f * 10**7), 10**7)) for f in factors)
        scalings.append((x, y, z))
        factors = [min(10, max(0.1, f * (1 + step) ** dice.uniform(-1, 1))) for f in factors]
    return scalings


def _barrel(facets: int, turned: bool) -> _core.ConvexPolyhedron:
    """Homothetic rings of a polygon of the rod, on a parabola: planar trapezoids and two caps."""
    rod = read_space_operand("rod").surface.points()
    top = max(Fraction(z) for *_, z in rod)
    polygon = [(int(x), int(y)) for x, y, z in rod if Fraction(z) == top]
    keep = min(SIDES, max(8, round(facets**0.5 / 2) * 2))
    polygon = sorted(polygon, key=_angle)
    polygon = [polygon[k * len(polygon) // keep] for k in range(keep)]
    half = max(1, -(-facets // keep) // 2)
    heights = range(-half, half + 1)
    rise = 2 * half + 2
    corners = [
        (x * (rise**2 - h**2), y * (rise**2 - h**2), 40_000 * rise * h)
        for h in heights
        for x, y in polygon
    ]
    if turned:
        corners = [_applied(corner) for corner in corners]
    rings = []
    for row in range(0, (len(heights) - 1) * keep, keep):
        for k in range(keep):
            after = (k + 1) % keep
            rings.append([row + k, row + after, row + keep + after, row + keep + k])
    last = (len(heights) - 1) * keep
    rings += [list(range(keep))[::-1], [last + k for k in range(keep)]]
    points = [(str(x), str(y), str(z)) for x, y, z in corners]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, rings))


def _angle(point: tuple[int, int]) -> tuple[int, Fraction]:
    """Ascending around the origin, exactly: the half plane, then the slope."""
    x, y = point
    upper = y > 0 or (y == 0 and x > 0)
    return (0 if upper else 1, Fraction(-x, y) if y else Fraction(-(10**9)))


def _applied(corner: tuple[int, int, int]) -> tuple[int, int, int]:
    """A linear map of positive determinant: convex stays convex, and planes stay planes."""
    x, y, z = (sum(a * c for a, c in zip(row, corner, strict=True)) for row in TURNED)
    return (x, y, z)
