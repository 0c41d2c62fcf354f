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
from minkref.fuzz.geometry.plane import Ring, mapped, scale_factors
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import set_of, shape_of
from minkref.fuzz.plane.families.mutation import mutate
from minkref.fuzz.plane.families.probes import scale_probes
from minkref.fuzz.plane.laws import LAWS
from minkref.scaling import joined

MOST_PROBES = 12
MOST_BITS = 1000
AXIS_FACTORS = tuple(
    Fraction(n, d) for n, d in ((1, 3), (1, 2), (2, 3), (1, 1), (7, 5), (3, 2), (2, 1), (3, 1))
)
OTHER_FACTORS = (Fraction(1, 2), Fraction(3, 4), Fraction(1), Fraction(3, 2), Fraction(4))
SCALED = {"scaled-up": Fraction(2), "scaled-down": Fraction(1, 2)}
MOST_VERTICES = 2000  # most vertices requested by cutting a case's edges
ASKED = (UPDATE, EVENTS, PAIR_EVENTS)
WAYS = ("probe:K", "axes:K", "mutant:K", "grid:B", "scaled-up:B", "scaled-down:B", "cut:N", *ASKED)


def derived(base: Case, name: CaseName, operation: str, number: int | None) -> Case | None:
    """Returns the derived case, or None for an unknown operation; NoCase if it does not apply
    here."""
    if number is None:
        return _by_law(base, name, operation)
    if operation == "probe":
        probes = _probes(base)
        if number >= len(probes):
            raise NoCase(f"the pair has {len(probes)} scales to be probed")
        position, scale = probes[number]
        return replace(base, name=name, scale=scale, position=position)
    if operation == "axes":
        return _by_axes(base, name, number)
    if operation == "grid":
        return _on_grid(base, name, number)
    if operation in SCALED and number <= MOST_BITS:
        factor = str(SCALED[operation] ** number)
        return replace(base, name=name, P=base.P.scaled(factor), Q=base.Q.scaled(factor))
    if operation == "cut" and number <= MOST_VERTICES:
        return _cut(base, name, number)
    if operation == "mutant":
        return _mutant(base, name)
    return None


def _mutant(base: Case, name: CaseName) -> Case:
    """A pair close to the case. With a factor for each axis `S P` is changed, and scaled back."""
    dice = random.Random(f"minkref mutant {name.text}")
    operand, s = (base.P_json, base.scale) if base.is_uniform else (base.scaled_P_json, "1")
    P, Q, s = mutate(dice, operand, base.Q_json, s)
    first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
    if base.is_uniform:
        return Case(name, first, second, s, "P", "Q", base.family, "mutant")
    first = first.scaled(",".join(str(1 / factor) for factor in scale_factors(base.scale)))
    return Case(name, first, second, _times(base.scale, s), "P", "Q", base.family, "mutant")


def _by_axes(base: Case, name: CaseName, number: int) -> Case:
    """The case with a factor for each axis. For even numbers P is scaled back, so that `S P` is sP
    and what fits goes on to fit; for odd ones P stays."""
    dice = random.Random(f"minkref axes {name.text}")
    x, y = dice.sample(AXIS_FACTORS, 2)
    by = _times(f"{x},{y}", "1")
    if number % 2:
        return replace(base, name=name, scale=by, position="axes")
    back = f"{1 / x},{1 / y}"
    P = base.P.scaled(base.scale).scaled(back)
    return replace(base, name=name, P=P, scale=by, position="axes")


def _probes(base: Case) -> list[tuple[str, str]]:
    """Scales at, next to and between the events of the pair; with a factor for each axis, those of
    `S P` and Q, times S."""
    if base.is_uniform:
        return scale_probes(base.P_json, base.Q_json, MOST_PROBES)
    found = scale_probes(base.scaled_P_json, base.Q_json, MOST_PROBES)
    return [(position, _times(base.scale, s)) for position, s in found]


def _times(scale: str, s: str) -> str:
    return joined([str(factor * Fraction(s)) for factor in scale_factors(scale)])


def _by_law(base: Case, name: CaseName, operation: str) -> Case | None:
    if operation in LAWS:
        return replace(LAWS[operation].changed(base), name=name)
    if operation == UPDATE:
        return replace(base, name=name, scale=_other_scale(base, name), law=(UPDATE, base))
    if operation in (EVENTS, PAIR_EVENTS):
        if not base.is_uniform:
            raise NoCase("events are those of uniform scales")
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
    if not base.is_uniform:
        other = base.scale
        while other == base.scale:
            factors = scale_factors(base.scale)
            other = joined([str(factor * dice.choice(OTHER_FACTORS)) for factor in factors])
        return other
    others = [scale for _, scale in _probes(base) if scale != base.scale]
    if not others:
        raise NoCase("the pair has no other scale to be reached")
    return dice.choice(others)
