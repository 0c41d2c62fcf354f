"""Cases in the plane derived from others (see `fuzz/run/naming.py` for names)."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import EVENTS, PAIR_EVENTS, UPDATE
from minkref.fuzz.geometry.plane import Ring, mapped
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import set_of, shape_of
from minkref.fuzz.plane.families.mutation import mutate
from minkref.fuzz.plane.families.probes import scale_probes
from minkref.fuzz.plane.laws import LAWS

MOST_PROBES = 12
MOST_BITS = 1000
SCALED = {"scaled-up": Fraction(2), "scaled-down": Fraction(1, 2)}
MOST_VERTICES = 2000  # most vertices requested by cutting a case's edges
ASKED = (UPDATE, EVENTS, PAIR_EVENTS)
WAYS = ("probe:K", "mutant:K", "grid:B", "scaled-up:B", "scaled-down:B", "cut:N", *ASKED)


def derived(base: Case, name: CaseName, operation: str, number: int | None) -> Case | None:
    """Returns the derived case, or None for an unknown operation; NoCase if it does not apply
    here."""
    if number is None:
        return _by_law(base, name, operation)
    if operation == "probe":
        probes = scale_probes(base.P_json, base.Q_json, MOST_PROBES)
        if number >= len(probes):
            raise NoCase(f"the pair has {len(probes)} scales to be probed")
        position, scale = probes[number]
        return replace(base, name=name, scale=scale, position=position)
    if operation == "grid":
        return _on_grid(base, name, number)
    if operation in SCALED and number <= MOST_BITS:
        factor = str(SCALED[operation] ** number)
        return replace(base, name=name, P=base.P.scaled(factor), Q=base.Q.scaled(factor))
    if operation == "cut" and number <= MOST_VERTICES:
        return _cut(base, name, number)
    if operation == "mutant":
        dice = random.Random(f"minkref mutant {name.text}")
        P, Q, scale = mutate(dice, base.P_json, base.Q_json, base.scale)
        first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
        return Case(name, first, second, scale, "P", "Q", base.family, "mutant")
    return None


def _by_law(base: Case, name: CaseName, operation: str) -> Case | None:
    if operation in LAWS:
        return replace(LAWS[operation].changed(base), name=name)
    if operation == UPDATE:
        return replace(base, name=name, scale=_other_scale(base, name), law=(UPDATE, base))
    if operation in (EVENTS, PAIR_EVENTS):
        return replace(base, name=name, law=(operation, base))
    return None


def _cut(base: Case, name: CaseName, fewest: int) -> Case:
    """The same sets with vertices along their edges: each edge in the same number of parts, a power
    of two, so that doubles stay doubles."""
    regions = [operand for operand in (base.P, base.Q) if operand.is_region]
    there = sum(operand.vertices for operand in regions)
    if not there:
        raise NoCase("there are no edges to be cut")
    parts = 1
    while parts * there < fewest:
        parts *= 2

    def refined(operand: _core.PolygonSet) -> _core.PolygonSet:
        if not operand.is_region:
            return operand
        cut = [[_in_parts(ring, parts) for ring in polygon] for polygon in shape_of(operand)]
        return set_of(cut)

    return replace(base, name=name, P=refined(base.P), Q=refined(base.Q))


def _in_parts(ring: Ring, parts: int) -> Ring:
    made: Ring = []
    for (x, y), (u, v) in zip(ring, ring[1:] + ring[:1], strict=True):
        steps = [Fraction(k, parts) for k in range(parts)]
        made += [(x + (u - x) * t, y + (v - y) * t) for t in steps]
    return made


def _on_grid(base: Case, name: CaseName, bits: int) -> Case:
    """The case with sP and Q rounded to integers of so many bits times a power of two, at scale 1:
    what an implementation on a grid takes as it is."""
    largest = max(map(abs, base.coordinates), default=Fraction(0))
    if not 1 <= bits <= MOST_BITS or not largest:
        raise NoCase("there is nothing to round")
    unit = unit_for(largest, bits)
    operands = []
    for exact in (base.P.scaled(base.scale), base.Q):
        operand = set_of(
            mapped(shape_of(exact), lambda p: (rounded(p[0], unit), rounded(p[1], unit)))
        )
        try:
            operand.validate("rounded")
        except _core.BadInput as error:
            raise NoCase(f"rounded it is no operand: {error}") from error
        operands.append(operand)
    return replace(base, name=name, P=operands[0], Q=operands[1], scale="1")


def _other_scale(base: Case, name: CaseName) -> str:
    """At, next to or between the events of the pair."""
    dice = random.Random(f"minkref update {name.text}")
    scales = [scale for _, scale in scale_probes(base.P_json, base.Q_json, MOST_PROBES)]
    others = [scale for scale in scales if scale != base.scale]
    if not others:
        raise NoCase("the pair has no other scale to be reached")
    return dice.choice(others)
