"""Intervals of random pairs of moving edges, each checked at single scales by orientation signs."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Vector, segments_meet
from minkref.reports.evidence.framework.part import REFERENCE, Findings

SUBJECT = (
    "100,000 random pairs of edges of each type (SS, ST, TT), a third of them degenerate by "
    "construction: at every bound exactly, between the bounds, and just outside, whether they "
    "meet, by orientation signs in plain Python."
)
MINUTES = (2, 0.1)
DEPENDS = (*REFERENCE, "fuzz/geometry/plane.py")

COUNT, QUICK_COUNT = 100_000, 5_000
BATCH = 10_000
SEED = 42
GRID = 6
TYPES = ("SS", "ST", "TT")
HAIR = Fraction(1, 1 << 60)
Numbers = tuple[int, int, int, int, int, int]  # p, q, d
Edge = tuple[str, Numbers]
Place = Vector[Fraction]


def random_edge(source: random.Random, kind: str) -> Edge:
    def grid() -> int:
        return source.randint(-GRID, GRID)

    while (direction := (grid(), grid())) == (0, 0):
        pass
    return kind, (grid(), grid(), grid(), grid(), *direction)


def random_pair(source: random.Random, kinds: str) -> tuple[Edge, Edge, str]:
    """The pair, and what is degenerate about it."""
    a, b = random_edge(source, kinds[0]), random_edge(source, kinds[1])
    if source.randrange(3):
        return a, b, "general"
    px, py, qx, qy, dx, dy = a[1]
    ox, oy, _, _, ex, ey = b[1]
    m, n, k = (source.randint(-3, 3) for _ in range(3))
    k = k or 1
    on_line = (px + m * dx, py + m * dy, qx + n * dx, qy + n * dy)
    which = source.choice(("parallel", "one line", "common end", "touching", "end on line", "same"))
    if which == "parallel":
        numbers = (*b[1][:4], k * dx, k * dy)
    elif which == "one line":
        numbers = (*on_line, k * dx, k * dy)
    elif which == "common end":
        end = (px + dx, py + dy, qx, qy) if a[0] == "S" else (px, py, qx + dx, qy + dy)
        numbers = (*source.choice(((px, py, qx, qy), end)), ex, ey)
    elif which == "touching":  # at the scale s0 the start of b is the start or the end of a
        s0, t = source.randint(1, 6), source.randint(0, 1)
        step = t * (s0 if a[0] == "S" else 1)
        start = (s0 * px + qx + step * dx - s0 * ox, s0 * py + qy + step * dy - s0 * oy)
        numbers = (ox, oy, *start, *source.choice(((ex, ey), (k * dx, k * dy))))
    elif which == "end on line":
        numbers = (*on_line, ex, ey)
    else:
        numbers = (px, py, qx, qy, dx, dy)
    return a, (b[0], numbers), which


def ends(edge: Edge, s: Fraction) -> tuple[Place, Place]:
    kind, (px, py, qx, qy, dx, dy) = edge
    first = (s * px + qx, s * py + qy)
    length = s if kind == "S" else 1
    return first, (first[0] + length * dx, first[1] + length * dy)


def expectations(
    empty: bool, lower: Fraction | None, upper: Fraction | None
) -> list[tuple[Fraction, bool]]:
    """Scales, and whether the edges should meet there."""
    if empty:
        return [
            (Fraction(n, d), False) for n, d in ((1, 9), (1, 2), (1, 1), (5, 3), (3, 1), (17, 1))
        ]
    asked: list[tuple[Fraction, bool]] = []
    if lower is not None:
        asked += [(lower, True), (lower * (1 - HAIR), False), (lower / 2, False)]
    if upper is not None:
        asked += [(upper, True), (upper * (1 + HAIR), False), (upper * 2, False)]
    low = lower or (upper / 64 if upper else Fraction(1, 64))
    high = upper or 64 * low
    return [*asked, ((low + high) / 2, True), ((15 * low + high) / 16, True)]


def run(findings: Findings, quick: bool) -> None:
    count = QUICK_COUNT if quick else COUNT
    for kinds in TYPES:
        source = random.Random(f"{SEED} {kinds}")
        decisions = wrong = 0
        seen: Counter[str] = Counter()
        first_wrong = ""
        for begin in range(0, count, BATCH):
            drawn = [random_pair(source, kinds) for _ in range(min(BATCH, count - begin))]
            rows = _core.pair_intervals([(a, b) for a, b, _ in drawn])
            for (a, b, which), (case, empty, low, high) in zip(drawn, rows, strict=True):
                lower = Fraction(low) if low else None
                upper = Fraction(high) if high else None
                point = " point" if not empty and lower is not None and lower == upper else ""
                seen[f"{case}{' empty' if empty else point}"] += 1
                seen[f"built {which}"] += 1
                for s, expected in expectations(empty, lower, upper):
                    decisions += 1
                    if segments_meet(*ends(a, s), *ends(b, s)) != expected:
                        wrong += 1
                        first_wrong = first_wrong or f"{a} {b} at {s}"
        findings.figures[kinds] = {"pairs": count, "decisions": decisions, **dict(seen)}
        findings.law(
            f"{kinds}: intervals that a scale refutes", wrong == 0, 0, wrong or first_wrong or 0
        )
        degenerate = count - seen["built general"]
        findings.target(
            f"{kinds}: pairs, degenerate ones", degenerate * 10 >= count * 3,
            f"{count}, a third", f"{count}, {degenerate}",
        )  # fmt: skip
        findings.target(
            f"{kinds}: point intervals seen", seen["meeting point"] > 0, "some",
            seen["meeting point"],
        )  # fmt: skip
