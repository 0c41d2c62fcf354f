"""Pair events of whole polygons: minkref's `disc_pair_events` against all pairs of features by the
symbolic oracle."""

from __future__ import annotations

import math
import random
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.plane import cross, minus
from minkref.fuzz.plane.families.small_operands import Corner, as_set, random_rings
from minkref.oracle.symbolic.disc.disc import Offset
from minkref.oracle.symbolic.disc.disc_contact import DiscEvent, Feature, polygon_events
from minkref.oracle.symbolic.rational import Rational, text

#: an edge by the number of its first corner, an arc by its vertex
Name = tuple[str, str, str]
#: two features, and a condition
Key = tuple[Name, Name, str]
NEAR = 1e-12


@dataclass
class PolygonTable:
    polygons: int = 0
    events: Counter[str] = field(default_factory=Counter)
    differences: list[str] = field(default_factory=list)


def compare_polygons(seed: int, count: int) -> PolygonTable:
    """Compares `count` random polygons with one ring. Equal seed and count give equal tables."""
    rng = random.Random(f"minkref disc pairs of polygons {seed}")
    table = PolygonTable()
    while table.polygons < count:
        rings = random_rings(rng, rng.choice([2, 4, 60]))
        if len(rings) > 1 or not _has_corners(rings[0]):
            continue
        try:
            P = as_set(rings)
        except _core.BadInput:
            continue
        table.polygons += 1
        _compare(rings[0], P, table)
    return table


def _has_corners(ring: list[Corner]) -> bool:
    """Whether the ring turns at each corner; the reference leaves straight corners out."""
    around = [ring[-1], *ring, ring[0]]
    turns = [
        cross(minus(b, a), minus(c, b))
        for a, b, c in zip(around, around[1:], around[2:], strict=False)
    ]
    return len(ring) >= 3 and all(turns)


def _compare(ring: list[Corner], P: _core.PolygonSet, table: PolygonTable) -> None:
    found = _core.disc_pair_events(P)
    ours: dict[Key, list[tuple[float, float]]] = defaultdict(list)
    corners = {(str(x), str(y)): k for k, (x, y) in enumerate(ring)}
    for _, _, features, (change, radius, _, contacts) in found.rows(0, len(found)):
        table.events[change] += 1
        first, second = sorted(features)
        for name, *_ in contacts:
            ours[first, second, name].append(radius[2])
    theirs: dict[Key, list[float]] = defaultdict(list)
    for event in polygon_events(ring, Rational(1)):
        first, second = sorted(_name(each, corners) for each in (event.first, event.second))
        theirs[first, second, event.name].append(_radius(event))
    faults = [f"{key}: only one of the two" for key in ours.keys() ^ theirs.keys()]
    for key in ours.keys() & theirs.keys():
        low_and_high, radii = sorted(ours[key]), sorted(theirs[key])
        near = len(radii) == len(low_and_high) and all(
            math.isclose(low, radius, rel_tol=NEAR)
            for (low, _), radius in zip(low_and_high, radii, strict=True)
        )
        if not near:
            faults.append(f"{key}: {low_and_high}, by the oracle {radii}")
    rows = [row[3][1][2] for row in found.rows(0, len(found))]
    if any(x[0] > y[1] for x, y in pairwise(rows)):
        faults.append("not ascending")
    table.differences += [f"{ring}: {fault}" for fault in faults]


def _name(feature: Feature, corners: dict[tuple[str, str], int]) -> Name:
    if isinstance(feature, Offset):
        return "edge", "0", str(corners[text(feature.p[0]), text(feature.p[1])])
    return "vertex", text(feature.centre[0]), text(feature.centre[1])


def _radius(event: DiscEvent) -> float:
    if event.scale.value is None:
        raise AssertionError("an event that meets has a radius")
    low, _ = event.scale.value.bounds(80)
    return int(low.numerator) / int(low.denominator)
