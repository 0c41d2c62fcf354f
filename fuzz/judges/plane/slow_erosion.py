"""Judges erosions: all routes by the slow engine, single places by the definition."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.judges.plane.slow_operands import slow_operands, slow_scale
from minkref.fuzz.judges.ruling import Ruling, dice_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle import slow
from minkref.oracle.slow.containment import lies_within
from minkref.oracle.slow.erosion import erosion

Place = tuple[Fraction, Fraction]
Passages = list[list[Place]]
PLACES = 24  # of each kind, at most
NEAR = Fraction(1, 1 << 40)


def judge(case: Case, places: int = PLACES) -> Ruling:
    """Compare regions, components, holes and remnants by the routes paper, winding, definition and
    index; then vertices, points beside edges on both sides, remnants, and random places."""
    ruling = Ruling()
    P, Q = slow_operands(case)
    scale = slow_scale(case)
    truth = erosion(P, Q, scale)
    expected = (truth.digest, truth.components, truth.holes)
    for route in _core.ROUTES:
        ours = _core.erosion(case.P, case.Q, case.scale, route)
        found = digest(ours.region.canonical_json()), ours.components, ours.holes
        ruling.compare(f"{case.name.text}, route {route}", found, expected, Reason.MISSING)
        _remnants(ruling, case, ours, truth)
    _by_index(ruling, case, expected)
    _places(ruling, case, P, Q, ours, places)
    return ruling


def _remnants(ruling: Ruling, case: Case, ours: _core.Sum, truth: object) -> None:
    assert hasattr(truth, "remnants")
    ruling.compare(
        f"{case.name.text}, remnants", remnants_of(ours), truth.remnants, Reason.PASSAGE_MISSED
    )


def _by_index(ruling: Ruling, case: Case, expected: tuple[str, int, int]) -> None:
    """Compare with an index made for this scale alone."""
    least = _core.least_scale_with_room(case.P, case.Q)
    if least is None or Fraction(case.scale) < Fraction(least):
        return
    window = (case.scale, case.scale)
    index = _core.ScaleIndex(_core.Outside(case.P).set, _core.negated(case.Q), *window)
    region, components, holes = _core.inside_out(index.sum(case.scale).region)
    found = digest(region.canonical_json()), components, holes
    ruling.compare(f"{case.name.text}, index", found, expected, Reason.MISSING)


def remnants_of(ours: _core.Sum) -> Passages:
    return [[(Fraction(x), Fraction(y)) for x, y in points] for points, _ in ours.passage_rows()]


def _places(
    ruling: Ruling, case: Case, P: slow.Operand, Q: slow.Operand, ours: _core.Sum, most: int
) -> None:
    scale = slow_scale(case)
    dice = dice_of(case)
    remnants = remnants_of(ours)
    bare = [_core.PolygonSet.from_json(_text(a, b)) for r in remnants for a, b in _ways(r)]
    for kind, places in candidates(case, ours, remnants, dice).items():
        for x in dice.sample(places, min(most, len(places))):
            held = x in ours.region or any(x in one for one in bare)
            what = f"{case.name.text}, {kind} ({x[0]}, {x[1]})"
            ruling.compare(what, held, lies_within(P, Q, x, scale), Reason.MISSING)


def candidates(
    case: Case, ours: _core.Sum, remnants: Passages, dice: object
) -> dict[str, list[Place]]:
    """List places to decide, by kind."""
    rings = [ring for polygon in ours.region.rings() for ring in polygon]
    sides = [side for ring in rings for side in zip(ring, [*ring[1:], ring[0]], strict=True)]
    ways = [way for points in remnants for way in pairwise(points)]
    ends = [point for points in remnants for point in points]
    return {
        "a vertex": [point for ring in rings for point in ring],
        "beside an edge": [x for side in sides for x in _around(*side)],
        "a remnant": ends + [_middle(*way) for way in ways],
        "beside a remnant": [x for a in ends for x in _around(a, (a[0] + 1, a[1] + 1))[:4]]
        + [x for way in ways for x in _around(*way)],
        "at random": _random(case, ours, dice),
    }


def _around(a: Place, b: Place) -> list[Place]:
    """Make an edge's middle, and points beside and along."""
    (x, y), ux, uy = _middle(a, b), b[0] - a[0], b[1] - a[1]
    return [
        (x, y),
        *((x + k * NEAR * uy, y - k * NEAR * ux) for k in (-1, 1)),
        *((x + k * NEAR * ux, y + k * NEAR * uy) for k in (-1, 1)),
    ]


def _middle(a: Place, b: Place) -> Place:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def _random(case: Case, ours: _core.Sum, dice: object) -> list[Place]:
    """Draw places where Q's box lies near the scaled P's box."""
    assert hasattr(dice, "randrange")
    points = [p for polygon in case.P.scaled(case.scale).rings() for p in polygon[0]]
    own = [p for polygon in case.Q.rings() for p in polygon[0]]
    low, high = (
        tuple(pick(p[k] for p in points) - pick(q[k] for q in own) for k in (0, 1))
        for pick in (min, max)
    )
    wide, tall = high[0] - low[0], high[1] - low[1]
    steps = [Fraction(dice.randrange(-8, 73), 64) for _ in range(2 * PLACES)]
    pairs = zip(steps[::2], steps[1::2], strict=True)
    return [(low[0] + s * wide, low[1] + t * tall) for s, t in pairs]


def _ways(points: list[Place]) -> list[tuple[Place, Place]]:
    return [(points[0], points[0])] if len(points) == 1 else list(pairwise(points))


def _text(a: Place, b: Place) -> str:
    ring = [[str(x) for x in point] for point in dict.fromkeys((a, b))]
    return json.dumps({"polygons": [{"outer": ring, "holes": []}]})
