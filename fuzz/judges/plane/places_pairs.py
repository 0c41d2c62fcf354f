"""Judges no-fit place by place; puts cut-out pieces back into containers."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.plane import Ring, box
from minkref.fuzz.judges.plane.erosion_pairs import erosion_case
from minkref.fuzz.judges.plane.slow_erosion import candidates, remnants_of
from minkref.fuzz.judges.plane.slow_operands import slow_operand
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.fuzz.plane.families.integer_rings import counter_clockwise, scattered, untangled
from minkref.oracle import slow

Place = tuple[Fraction, Fraction]
PLACES = 6  # of each kind, at most


def place_faults(seed: int, index: int) -> tuple[int, list[str]]:
    """Decide places of B as apart, touching or overlapping: count them, and list differences of
    no_fit from the slow engine, which compares pairs of convex pieces."""
    case = erosion_case(seed, index)
    dice = Dice(f"minkref places {seed} {index}")
    B = _core.negated(case.Q)
    found = _core.minkowski_sum(case.P, case.Q, case.scale, "paper", "rational", True)
    fits = remnants_of(found)
    bare = [_core.PolygonSet.from_json(_text(*way)) for fit in fits for way in _ways(fit)]
    P, Q = slow_operand(case.P_json), slow_operand(_core.negated(B).to_json())
    faults, compared = [], 0
    for kind, places in candidates(case, found, fits, dice).items():
        for x in dice.sample(places, min(PLACES, len(places))):
            meeting = slow.witness(P, Q, Fraction(case.scale), x)
            fit = any(x in one for one in bare)
            inside = x in found.region
            touching = fit or (inside and x in Boundary(found.region))
            ours = "apart" if not inside else "touching" if touching else "overlapping"
            compared += 1
            if ours != told(meeting):
                faults.append(f"{case.name.text}, {kind} ({x[0]}, {x[1]}): {ours}")
    return compared, faults


class Boundary:
    """A region's boundary points."""

    def __init__(self, region: _core.PolygonSet) -> None:
        rings = [ring for polygon in region.rings() for ring in polygon]
        self.sides = [way for ring in rings for way in pairwise([*ring, ring[0]])]

    def __contains__(self, x: Place) -> bool:
        return any(
            (b[0] - a[0]) * (x[1] - a[1]) == (b[1] - a[1]) * (x[0] - a[0])
            and min(a[0], b[0]) <= x[0] <= max(a[0], b[0])
            and min(a[1], b[1]) <= x[1] <= max(a[1], b[1])
            for a, b in self.sides
        )


def told(meeting: slow.Meeting) -> str:
    return {"disjoint": "apart"}.get(meeting.contact, meeting.contact)


def jigsaw(seed: int, index: int) -> tuple[_core.PolygonSet, _core.PolygonSet, Place]:
    """Draw a piece, perhaps with a hole, and a container: the piece moved to a place, beside a room
    too small for anything. The piece fits at this place alone."""
    dice = Dice(f"minkref jigsaw {seed} {index}")
    while True:
        ring = untangled(scattered(dice, dice.randint(4, 10), 12, 12))
        if ring is None:
            continue
        polygon: list[Ring] = [[*counter_clockwise(ring)]]
        if dice.random() < 0.5:
            x, y = dice.randint(1, 10), dice.randint(1, 10)
            polygon.append(box(x, y, 1, 1)[::-1])
        piece = _core.PolygonSet.from_json(shape_text([polygon]))
        at = (Fraction(dice.randint(-30, 30), 7), Fraction(dice.randint(-30, 30), 5))
        room = piece.translated(str(at[0]), str(at[1]))
        closet = _core.PolygonSet([box(40, 40, 1, 1)])
        try:
            piece.validate("piece")
        except _core.BadInput:
            continue
        return _core.combined("union", [room, closet])[0], piece, at


def _ways(points: list[Place]) -> list[tuple[Place, Place]]:
    return [(points[0], points[0])] if len(points) == 1 else list(pairwise(points))


def _text(a: Place, b: Place) -> str:
    ring = [[str(x) for x in point] for point in dict.fromkeys((a, b))]
    return json.dumps({"polygons": [{"outer": ring, "holes": []}]})
