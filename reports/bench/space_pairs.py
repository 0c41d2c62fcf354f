"""Pairs of arbitrary polyhedra for timing sums, all our own, with integer vertices, and two
families that grow.

Q is moved around the origin, because Manifold needs the origin inside; the sum only moves along.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators.machined import plate
from minkref.fuzz.space.generators.placed import around_origin
from minkref.fuzz.space.generators.round import clutch, geodesic_sphere, triangulated_torus
from minkref.fuzz.space.generators.tube import knot_tube, wide_knot
from minkref.fuzz.space.generators.workshop import (
    bored_plate,
    hollow_block,
    rounded_bracket,
    spur_gear,
)

SEED = 2012
Solids = tuple[Polyhedron, Polyhedron]


@dataclass(frozen=True)
class TimedPair:
    """`seconds` and `ratio` are optional targets: our time at most, and Nef's time relative to
    ours."""

    name: str
    make: Callable[[], Solids]
    seconds: float | None = None
    ratio: float | None = None
    quick: bool = False

    def solids(self) -> Solids:
        P, Q = self.make()
        return P, around_origin(Q)


@cache
def _clutch(around: int, teeth: int) -> Polyhedron:
    return clutch(random.Random(f"minkref clutch {SEED}"), around, teeth, 1000)


@cache
def _knot(around: int, section: int) -> Polyhedron:
    return wide_knot(2, 3, around, section, 1000)


PAIRS = (
    TimedPair(
        "clutch 352 + torus 200",
        lambda: (_clutch(44, 11), triangulated_torus(20, 5, 3000, 1000)),
        1.5,
        150,
    ),
    TimedPair(
        "knot 248 + icosahedron 20",
        lambda: (_knot(31, 4), geodesic_sphere(0, 700)),
        ratio=100,
        quick=True,
    ),
    TimedPair(
        "knot 992 + geodesic sphere 320", lambda: (_knot(62, 8), geodesic_sphere(2, 700)), 1.5
    ),
    TimedPair("knot 992 + clutch 1,944", lambda: (_knot(62, 8), _clutch(243, 27)), 10),
    TimedPair(
        "gear of 30 teeth + gear of 12",
        lambda: (spur_gear(30, 3600, 1000, 24), spur_gear(12, 1600, 1000, 12)),
        20,
    ),
    TimedPair(
        "bracket with three bores + pin",
        lambda: (rounded_bracket(8, 0, 120), plate(20, 16, 10)),
        ratio=2,
        quick=True,
    ),
    TimedPair(
        "plate with two bores + block",
        lambda: (bored_plate(2, 12, 100), plate(9, 9, 9)),
        ratio=2,
        quick=True,
    ),
    TimedPair(
        "plate with six bores + bracket",
        lambda: (bored_plate(6, 8, 100), rounded_bracket(0, 0, 12)),
        ratio=2,
    ),
    TimedPair(
        "rounded bracket with three bores + geodesic sphere 80",
        lambda: (rounded_bracket(16, 4, 120), geodesic_sphere(1, 20)),
        ratio=2,
    ),
    TimedPair(
        "cube minus a geodesic sphere 80 + geodesic sphere 80",
        lambda: (hollow_block(1, 300), geodesic_sphere(1, 100)),
        ratio=2,
    ),
)


def _knots(stretches: int) -> Solids:
    dice = random.Random(f"minkref knots {SEED} {stretches}")
    return knot_tube(dice, 2, 3, stretches, 4, 1000), geodesic_sphere(0, 300)


def _gears(teeth: int) -> Solids:
    return spur_gear(teeth, 3600, 1000, 12), around_origin(spur_gear(5, 800, 400))


#: Pairs for the paper's own update, which looks at all pairs of facets, the largest last.
UPDATE_PAIRS = (
    TimedPair("clutch 64 + icosahedron 20", lambda: (_clutch(8, 2), geodesic_sphere(0, 700))),
    TimedPair("knot 96 + icosahedron 20", lambda: (_knot(12, 4), geodesic_sphere(0, 700))),
    TimedPair("knot 96 + clutch 64", lambda: (_knot(12, 4), _clutch(8, 2))),
    TimedPair("knot 248 + icosahedron 20", lambda: (_knot(31, 4), geodesic_sphere(0, 700))),
)

#: Pairs for event searches, the largest last.
EVENT_PAIRS = (
    TimedPair("knot 992 + geodesic sphere 320", lambda: (_knot(62, 8), geodesic_sphere(2, 700))),
    TimedPair(
        "clutch 352 + torus 200", lambda: (_clutch(44, 11), triangulated_torus(20, 5, 3000, 1000))
    ),
    TimedPair("knot 992 + clutch 352", lambda: (_knot(62, 8), _clutch(44, 11))),
    TimedPair("knot 992 + clutch 1,944", lambda: (_knot(62, 8), _clutch(243, 27))),
)

GROWING: dict[str, Callable[[int], Solids]] = {
    "knot + icosahedron": _knots,
    "gear + small gear": _gears,
}
SIZES = {
    "knot + icosahedron": (16, 24, 36, 54, 80, 120, 180, 270, 400, 600),
    "gear + small gear": (4, 6, 9, 14, 20, 30, 45, 70, 100, 150),
}
