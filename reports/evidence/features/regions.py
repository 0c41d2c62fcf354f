"""Regions of features, the alpha-shape and rest material: their laws on random sets, half of them
with several events at one radius."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations, pairwise

from minkref import _core
from minkref.disc.feature_regions import RegionsAt
from minkref.disc.features import Features
from minkref.fuzz.features.place_draws import KINDS, drawn_set, set_of
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.5, 20)

SEED = 1282
SETS = Counts(12, 40, 2000)
GAPS = 20  # at most, of one set
TILED = (Fraction(5, 4), Fraction(5, 2), Fraction(13, 2))  # many feet are rational there
SHARES = (Fraction(1, 5), Fraction(1, 2), Fraction(4, 5))  # of the way between two events
BATCH = 4
Number = Fraction | int
Corner = tuple[Number, Number]


@dataclass
class Looked:
    """Counts of checked laws, and faults."""

    counts: Counter[str] = field(default_factory=Counter)
    wrong: list[str] = field(default_factory=list)

    def law(self, what: str, holds: bool, where: str) -> None:
        self.counts[what] += 1
        if not holds:
            self.wrong.append(f"{what}: {where}")


def batch(first: int) -> Looked:
    looked = Looked()
    for number in range(first, first + BATCH):
        name, shape = drawn_set(SEED, number)
        P = set_of(shape)
        try:
            features = Features(P)
            _counts(name, P, features, number, looked)
            _at_infinity(name, P, features, looked)
            _disjoint(name, P, features, looked)
        except Exception as error:  # noqa: BLE001 a fault too
            looked.wrong.append(f"{name}: {type(error).__name__}: {error}")
    return looked


def _counts(
    name: str, P: _core.PolygonSet, features: Features, number: int, looked: Looked
) -> None:
    """Compares counts at three radii in gaps between events; the rest grows with the radius."""
    radii = _core.disc_index(P).radii()
    looked.counts["sets with several events at one radius"] += len(radii) < len(
        _core.disc_index(P).kinds()
    )
    bounds = [Fraction(0), *(Fraction(low) for low, _ in radii)]
    bounds.append(bounds[-1] * 2 + 1)
    gaps = [(low, high) for low, high in pairwise(bounds) if high - low > high / 2**40]
    dice = random.Random(f"{SEED} {number}")
    last = 0.0
    for low, high in sorted(dice.sample(gaps, min(GAPS, len(gaps)))):
        for share in SHARES:
            radius = (low + share * (high - low)).limit_denominator(10**12)
            where = f"{name} at {radius}"
            found, sum_ = features.regions(2 * radius), _core.offset(P, str(radius**2))
            looked.law("components are those of the closed sum",
                       found.components == sum_.components, where)  # fmt: skip
            looked.law("holes are those of the closed sum", found.holes == sum_.holes, where)
            last = _rest(found, last, where, looked)


def _rest(found: RegionsAt, last: float, where: str, looked: Looked) -> float:
    """Checks the rest material against the regions, and against that of a smaller radius."""
    low, high = found.rest_area
    looked.law("the rest grows", high >= last, where)
    for feature, rest in zip(found.features, found.rest, strict=True):
        looked.law("the rest keeps within its region", rest.area[0] <= feature.area[1], where)
        looked.law(
            "a rest with an area has components", (rest.components > 0) == (rest.area[1] > 0), where
        )
        looked.counts["components of the rest"] += rest.components
        looked.counts["regions without an area"] += feature.area == (0, 0)
    return low


def _at_infinity(name: str, P: _core.PolygonSet, features: Features, looked: Looked) -> None:
    terms = [feature.terms for feature in features.regions().features]
    is_rational = all(set(each) <= {""} for each in terms)
    looked.law("areas at infinity are rational", is_rational, name)
    filled = sum((each.get("", Fraction(0)) for each in terms), Fraction(P.area()))
    looked.law("at infinity regions fill the convex hull", filled == _hull_area(P), name)


def _hull_area(P: _core.PolygonSet) -> Fraction:
    """Twice around: the lower chain, then the upper one (Andrew)."""
    points = sorted({(Fraction(x), Fraction(y)) for polygon in P.rings() for x, y in polygon[0]})
    hull: list[Corner] = []
    for chain in (points, points[::-1]):
        base = len(hull)
        for p in chain:
            while len(hull) >= base + 2 and _turn(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        hull.pop()
    closed = [*hull, hull[0]]
    return Fraction(sum(p[0] * q[1] - p[1] * q[0] for p, q in pairwise(closed))) / 2


def _turn(a: Corner, b: Corner, c: Corner) -> Number:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _disjoint(name: str, P: _core.PolygonSet, features: Features, looked: Looked) -> None:
    """Intersects regions with rational corners and simple rings with each other and with P."""
    for radius in TILED:
        found = features.regions(2 * radius)
        sets = [P]
        for number, feature in enumerate(found.features):
            shape = _simple(found.corners(number))
            if shape is None or feature.area == (0, 0):
                continue
            looked.law("areas are those of the rings", Fraction(shape.area()) == feature.terms[""],
                       f"{name} at {radius}")  # fmt: skip
            sets.append(shape)
        for a, b in combinations(sets, 2):
            looked.law("regions are disjoint", _core.combined("intersection", [a, b])[0].is_empty,
                       f"{name} at {radius}")  # fmt: skip


def _simple(rings: list[list[tuple[str, str]]]) -> _core.PolygonSet | None:
    """The region as a valid set, unless a corner is irrational or a ring touches itself."""
    if any("sqrt" in value for ring in rings for point in ring for value in point):
        return None
    found: list[list[Corner]] = []
    for ring in rings:
        corners: list[Corner] = [(Fraction(x), Fraction(y)) for x, y in reversed(ring)]
        found.append(
            [p for p, q in zip(corners, [*corners[1:], corners[0]], strict=True) if p != q]
        )
    outer = [ring for ring in found if _doubled(ring) > 0]
    if len(outer) != 1:
        return None
    holes = [ring for ring in found if ring is not outer[0]]
    shape = set_of([[outer[0], *holes]])
    try:
        shape.validate("region")
    except _core.BadInput:
        return None
    return shape


def _doubled(ring: list[Corner]) -> Fraction:
    return Fraction(sum(p[0] * q[1] - p[1] * q[0] for p, q in pairwise([*ring, ring[0]])))


def run(findings: Findings, size: Size) -> None:
    count = size.of(SETS)
    looked = Looked()
    for one in in_processes(batch, range(0, count, BATCH), each=60):
        looked.counts.update(one.counts)
        looked.wrong += one.wrong
    findings.none("laws of regions and rest material that do not hold", looked.wrong)
    tied = looked.counts["sets with several events at one radius"]
    findings.law("sets with several events at one radius", tied * 2 >= count, "half", tied)
    compared = looked.counts["regions are disjoint"]
    findings.law(
        "compared pairs of a region and P, or of regions", compared > count, count, compared
    )
    findings.figures = {"counts": dict(looked.counts), "sets": count, "kinds": len(KINDS)}
    findings.note(
        f"seed {SEED}: {count:,} sets; counts at "
        f"{looked.counts['holes are those of the closed sum']:,} radii, "
        f"{looked.counts['components of the rest']:,} components of the rest, "
        f"{looked.counts['regions without an area']:,} regions without an area, {compared:,} "
        f"intersections"
    )
