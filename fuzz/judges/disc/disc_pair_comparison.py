"""Events of two features of an offset polygon: minkref's `disc_pair` against the symbolic oracle,
which solves every condition over sums of square roots and tests by definition whether its place is
on both features.

compare(seed, count) draws `count` pairs of each kind; compare_printed those of the Appendix as it
stands, against its formulas set up afresh (`appendix_formulas.py`). Run it: `python -m
minkref.fuzz.judges.disc.disc_pair_comparison SEED COUNT` prints the table as JSON, and exits with 1
if there is a difference.
"""

from __future__ import annotations

import json
import math
import random
import sys
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.appendix_formulas import printed_events
from minkref.fuzz.judges.disc.disc_pair_draws import KINDS, Drawn, Feature, draw
from minkref.oracle.symbolic.disc.disc import Arc, Offset
from minkref.oracle.symbolic.disc.disc_contact import DiscEvent, pair_disc_events
from minkref.oracle.symbolic.disc.radicals import Radical, number
from minkref.oracle.symbolic.rational import Rational, rationals

#: whose end, which; as minkref names them, in the order of the oracle's conditions
SLOTS = (("a", 0), ("a", 1), ("b", 0), ("b", 1), ("", 0))
NEAR = 1e-9
#: of the Appendix, taken as they stand
SENTENCES = ["rejected", "number", "radical", "line", "parallel"]


@dataclass
class Table:
    """Counts and differences of a comparison."""

    seed: int
    pairs: Counter[str] = field(default_factory=Counter)
    relations: Counter[str] = field(default_factory=Counter)
    contacts: Counter[str] = field(default_factory=Counter)
    changes: Counter[str] = field(default_factory=Counter)
    degrees: Counter[int] = field(default_factory=Counter)
    differences: list[str] = field(default_factory=list)


def symbolic_feature(feature: Feature) -> Offset | Arc:
    points = [rationals(point) for point in feature]
    edges = [Offset((p[0], p[1]), (q[0], q[1])) for p, q in pairwise(points)]
    return edges[0] if len(edges) == 1 else Arc(*edges)


def texts(feature: Feature) -> list[tuple[str, str]]:
    """Converts a feature for the extension module."""
    return [(str(x), str(y)) for x, y in feature]


def compare(seed: int, count: int) -> Table:
    """The same seed and count give the same table."""
    rng = random.Random(f"minkref disc pairs {seed}")
    table = Table(seed)
    for kind in KINDS:
        for _ in range(count):
            compare_one(draw(rng, kind), table)
    return table


def compare_printed(seed: int, count: int) -> Table:
    """For discs of the radii 1, 2 and 1/3 at the scale 1. The same seed and count give the same
    table."""
    rng = random.Random(f"minkref printed disc pairs {seed}")
    table = Table(seed)
    for kind in KINDS:
        for _ in range(count):
            drawn, r = draw(rng, kind), rng.choice([Rational(1), Rational(2), Rational(1, 3)])
            table.pairs[drawn.kind] += 1
            table.relations[drawn.relation] += 1
            told = printed_events(symbolic_feature(drawn.a), symbolic_feature(drawn.b), r)
            rows = _core.disc_pair(texts(drawn.a), texts(drawn.b), SENTENCES, r == 1)
            found = {
                (of, end): (radius, meets)
                for _, radius, _, contacts in rows
                for _, of, end, meets, _ in contacts
            }
            for change, _, _, contacts in rows:
                table.changes[change] += 1
                table.contacts.update(name for name, *_ in contacts)
            faults = [f"{slot}: only one of the two" for slot in told.keys() ^ found.keys()]
            for slot in told.keys() & found.keys():
                (scale, is_met), (radius, meets) = told[slot], found[slot]
                faults += _faults_of_radius(scale * r, radius)
                if is_met != meets:
                    faults.append(f"{slot} meets: {meets}")
            table.differences += [f"{drawn}, r = {r}: {fault}" for fault in faults]
    return table


def compare_one(drawn: Drawn, table: Table) -> None:
    table.pairs[drawn.kind] += 1
    table.relations[drawn.relation] += 1
    a, b = symbolic_feature(drawn.a), symbolic_feature(drawn.b)
    found = pair_disc_events(a, b, Rational(1))
    theirs = {SLOTS[k]: event for k, event in enumerate(found) if event.meet}
    rows = _core.disc_pair(texts(drawn.a), texts(drawn.b))
    faults: list[str] = []
    ours: set[tuple[str, int]] = set()
    for change, radius, shared, contacts in rows:
        table.changes[change] += 1
        table.degrees[len(radius[1]) - 1] += 1
        places = set()
        for name, of, end, meets, place in contacts:
            table.contacts[name] += 1
            ours.add((of, end))
            event = theirs.get((of, end))
            if event is None:
                faults.append(f"{name} {of}{end} at {radius[2]} is none")
                continue
            places.add(event.at)
            if event.name != name or not meets:
                faults.append(f"{name} {of}{end} is {event.name}, meets: {meets}")
            faults += _faults_of_numbers(event, radius, place)
        is_tangent = any(not of for _, of, _, _, _ in contacts)
        faults += _faults_of_counts(change, shared, len(places), is_tangent)
    faults += [f"{theirs[slot].name} {slot} is missing" for slot in theirs if slot not in ours]
    faults += _faults_of_order([row[1][2] for row in rows], [row[2] for row in rows])
    table.differences += [f"{drawn}: {fault}" for fault in faults]


def _faults_of_numbers(event: DiscEvent, radius: Any, place: tuple[float, float]) -> list[str]:
    """Checks that the oracle's radius equals the row's, and that its place lies near."""
    value, at = event.scale.value, event.at
    if value is None or at is None:
        raise AssertionError("a contact that meets has a radius")
    faults = _faults_of_radius(value, radius)
    for x, y in zip(place, at, strict=True):
        near = float(Fraction(str(y.bounds(80)[0])))
        if not math.isclose(x, near, rel_tol=NEAR, abs_tol=NEAR):
            faults.append(f"the place {place} is not {near}")
    return faults


def _faults_of_radius(value: Radical, radius: Any) -> list[str]:
    """Checks that the polynomial has the squared value as a root, and the bounds contain the
    value."""
    _, polynomial, (low, high) = radius
    square, total = value * value, number(0)
    for coefficient in reversed(polynomial):
        total = total * square + number(Rational(coefficient))
    faults = []
    if total.sign() != 0:
        faults.append(f"{polynomial} has not the root {square}")
    if (value - _exact(low)).sign() < 0 or (_exact(high) - value).sign() < 0:
        faults.append(f"{value} is not between {low} and {high}")
    return faults


def _exact(value: float) -> Radical:
    return number(Rational(*value.as_integer_ratio()))


def _faults_of_counts(
    change: str, shared: tuple[int, int, int], places: int, is_tangent: bool
) -> list[str]:
    """Checks the number of common points at the radius: one per place, plus points that stay; two
    points that begin at a tangent count once."""
    before, at, after = shared
    wanted = {
        "birth": after > before and (at >= after or (is_tangent and shared == (0, 1, 2))),
        "death": after < before and at >= before,
        "touch": before == after and at == before + 1,
        "swap": before == after == 1 and at == 2,
        "overlap": shared == (0, -1, 0) and places >= 2,
    }
    if not wanted[change] or (at >= 0 and at < places) or max(before, after) > 2:
        return [f"{change} with {shared} and {places} places"]
    return []


def _faults_of_order(
    radii: list[tuple[float, float]], shared: list[tuple[int, int, int]]
) -> list[str]:
    if any(x[0] > y[0] for x, y in pairwise(radii)):
        return [f"not ascending: {radii}"]
    return [f"{x} is followed by {y}" for x, y in pairwise(shared) if x[2] != y[0]]


def main(arguments: list[str]) -> int:
    seed, count = map(int, arguments)
    tables = {"corrected": compare(seed, count), "printed": compare_printed(seed, count)}
    print(json.dumps({name: vars(table) for name, table in tables.items()}, indent=1))
    return 1 if any(table.differences for table in tables.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
