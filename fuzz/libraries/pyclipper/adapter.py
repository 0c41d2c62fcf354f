"""Clipper 1 (the Python package pyclipper): sums of two rings, unions, offsets. The argument is
boundary, union or inflate.

All run on a grid of 30 bits; the library takes 62. A vertex is rounded by a unit, and another where
an intersection moves into its scanbeam; with slivers left out, four units. Arcs: the tolerance is a
thousandth of the radius, but steps of an arc are rounded to the nearest number, so one step may
stand for one and a half: 1.5^2 times as much.
"""

from __future__ import annotations

import math
import sys
from importlib.metadata import version
from typing import Any

import pyclipper  # type: ignore[import-not-found,unused-ignore]
from adapter_protocol import Set, Skipped, serve  # type: ignore[import-not-found,unused-ignore]

BITS = 30
ALL = ["plane", "non-convex", "holes", "components", "touching", "empty"]
OFFSETS = (
    "offset", "inset", "line-offset", "join-mitre", "join-square", "cap-flat", "cap-square",
)  # fmt: skip
JOINS = {"round": pyclipper.JT_ROUND, "mitre": pyclipper.JT_MITER, "square": pyclipper.JT_SQUARE}
ENDS = {
    "round": pyclipper.ET_OPENROUND,
    "flat": pyclipper.ET_OPENBUTT,
    "square": pyclipper.ET_OPENSQUARE,
}
NAMES = {"boundary": "pyclipper", "union": "pyclipper-union", "inflate": "pyclipper-inflate"}


def rings_of(*sets: Set) -> list[list[list[float]]]:
    return [r for each in sets for p in each["polygons"] for r in (p["outer"], *p["holes"])]


def largest(*sets: Set) -> float:
    return max((abs(x) for ring in rings_of(*sets) for p in ring for x in p), default=0.0)


class Grid:
    """Sizes have at most 30 bits (integer_grid.hpp)."""

    def __init__(self, size: float) -> None:
        if not math.isfinite(size):
            raise Skipped("coordinates exceed the doubles")
        self.shift = BITS - (math.frexp(size)[1] if size else 0)

    def path(self, ring: list[list[float]]) -> list[list[int]]:
        return [[round(math.ldexp(x, self.shift)) for x in p] for p in ring]

    def rings(self, paths: list[list[list[int]]]) -> dict[str, Any]:
        back = [[[math.ldexp(x, -self.shift) for x in p] for p in path] for path in paths]
        return {"rings": back}


def sum_of(sP: Set, Q: Set) -> dict[str, Any]:
    p, q = rings_of(sP), rings_of(Q)
    if len(p) != 1 or len(q) != 1:
        raise Skipped("one ring each only")
    grid = Grid(largest(sP) + largest(Q))
    return grid.rings(pyclipper.MinkowskiSum(grid.path(p[0]), grid.path(q[0]), True))


def union_of(sets: list[Set]) -> dict[str, Any]:
    grid, one = Grid(largest(*sets)), pyclipper.Pyclipper()
    rings = rings_of(*sets)
    if not rings:
        return {"rings": []}
    one.AddPaths([grid.path(ring) for ring in rings], pyclipper.PT_SUBJECT, True)
    rule = pyclipper.PFT_NONZERO
    return grid.rings(one.Execute(pyclipper.CT_UNION, rule, rule))


def offset_of(P: Set, radius: float, how: dict[str, Any] | None = None) -> dict[str, Any]:
    how = how or {}
    rings, end = P.get("lines"), ENDS[how.get("cap", "round")]
    if rings is None:
        rings, end = rings_of(P), pyclipper.ET_CLOSEDPOLYGON
        if any(len(ring) < 3 for ring in rings):
            raise Skipped("no points or segments")
    if not rings:
        return {"rings": []}
    grid = Grid(max(abs(x) for ring in rings for p in ring for x in p) + abs(radius))
    delta = math.ldexp(radius, grid.shift)
    one = pyclipper.PyclipperOffset(how.get("limit", 2.0), abs(delta) / 1000)
    one.AddPaths([grid.path(ring) for ring in rings], JOINS[how.get("join", "round")], end)
    return grid.rings(one.Execute(delta))


def main(mode: str) -> None:
    hello: dict[str, Any] = {
        "name": NAMES[mode],
        "version": version("pyclipper"),
        "language": "C++",
        "arithmetic": "integer-grid",
        "numbers": "double",
        "grid": {"bits": BITS - 2},
        "tolerance": {"absolute": "0", "relative": "1/134217728"},
        "sum": "none",
        "capabilities": ALL,
    }
    if mode == "boundary":
        serve({**hello, "sum": "boundary", "capabilities": ["plane", "non-convex"]}, sum_of)
    elif mode == "union":
        serve({**hello, "capabilities": [*ALL, "union"]}, None, union_of=union_of)
    else:
        hello["tolerance"]["radius"] = "0.0025"
        serve({**hello, "capabilities": [*ALL, *OFFSETS]}, None, offset_of=offset_of)


if __name__ == "__main__":
    main(sys.argv[1])
