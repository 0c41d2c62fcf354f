"""A listed event compared with the truth at its place: the place singled out by its features, the
distance, all nearest points, the kind."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from .boundary import Boundary, Foot, Place, are_opposite, surround, ways
from .single_out import NotSingled, places_of
from .surd import Surd

NEAR = 1e-9  # relative: picks the listed place among all places that features single out


@dataclass(frozen=True)
class Found:
    """An event at its exact place."""

    at: Place
    square: Surd
    feet: list[Foot]
    kind: str


def event_faults(boundary: Boundary, row: Mapping[str, Any]) -> tuple[Found | None, list[str]]:
    """Find the event for a JSON row from `minkref events P disc`, and the row's faults. The event
    is None if the features single out no place near the listed place. Exact. Raises ValueError if
    an edge has an irrational length."""
    try:
        found = _found(boundary, row)
    except NotSingled as why:
        return None, [f"{_told(row)}: {why}"]
    return found, [f"{_told(row)}: {fault}" for fault in _faults(boundary, row, found)]


def _found(boundary: Boundary, row: Mapping[str, Any]) -> Found:
    candidates = []
    for place in places_of(boundary, row["features"]):
        away = max(abs(float(c) - listed) for c, listed in zip(place, row["place"], strict=True))
        size = max(1.0, *(abs(float(c)) for c in place))
        candidates.append((away / size, place))
    if not candidates:
        raise NotSingled("no place is as far from its features")
    away, place = min(candidates, key=lambda each: each[0])
    if away > NEAR:
        told = ", ".join(f"{float(c):.9g}" for c in place)
        raise NotSingled(f"its features single out ({told}) instead")
    square, feet = boundary.nearest(place)
    return Found(place, square, feet, kind_of(place, feet))


def kind_of(place: Place, feet: list[Foot]) -> str:
    """Tell the kind by docs/disc.md, from the directions towards the nearest points."""
    seen = ways(place, feet)
    if surround(seen):
        return "maximum"
    if any(are_opposite(u, v) for u in seen for v in seen):
        is_tip = any(foot.vertex is not None and not foot.square for foot in feet)
        return "saddle" if len(feet) == 2 and is_tip else "ridge"
    names = [foot.names()[0] for foot in feet]
    has_joint = any(len(each) > 1 for each in names)
    return "joint" if has_joint and sum(map(len, names)) == 3 else "corner"


def _faults(boundary: Boundary, row: Mapping[str, Any], found: Found) -> Iterator[str]:
    if found.square.sign() <= 0 or not boundary.is_outside(found.at):
        yield "it is no place outside of the set"
    if row["kind"] != found.kind:
        yield f"it is a {found.kind}"
    named = _named(row)
    rest = set(named)
    for foot in found.feet:
        told = foot.names()
        fits = [names for names in told if names <= rest]
        if not fits:
            yield f"as near is {_texts(told[0])}"
            continue
        rest -= fits[0]
    if rest or len(named) != len(set(named)):
        yield f"not as near, or twice: {_texts(rest)}"
    if len(found.feet) < 2 or (len(found.feet) == 2 and not _is_event_of_two(found)):
        yield "nothing changes there"
    for axis, own, listed in zip("xy", found.at, row["place"], strict=True):
        unit = Fraction(math.ulp(listed))
        off = own - Surd(Fraction(listed))
        if (off - Surd(unit)).sign() > 0 or (off + Surd(unit)).sign() < 0:
            yield f"its {axis} is off by more than one unit in the last place"
    yield from _radius_faults(row, found.square)


def _is_event_of_two(found: Found) -> bool:
    """Tell whether two nearest points make the event: opposite each other, or one where an edge
    meets its end."""
    u, v = ways(found.at, found.feet)
    return are_opposite(u, v) or any(len(foot.names()[0]) > 1 for foot in found.feet)


def _radius_faults(row: Mapping[str, Any], square: Surd) -> Iterator[str]:
    rational = None if square.rational is None else str(square.rational)
    if row["squared_radius"] != rational:
        yield f"its squared radius is {rational or float(square)}"
    value = Surd(Fraction(0))
    for coefficient in reversed(row["polynomial"]):
        value = value * square + Surd(Fraction(coefficient))
    if value.sign() != 0:
        yield "its squared radius is no root of the polynomial"
    low, high = (Fraction(row["radius"][end]) for end in ("low", "high"))
    if (Surd(low * low) - square).sign() > 0 or (Surd(high * high) - square).sign() < 0:
        yield "its radius is not within the bounds"


def _named(row: Mapping[str, Any]) -> list[tuple[object, ...]]:
    return [
        ("edge", *each["edge"]) if "edge" in each else ("vertex", *map(Fraction, each["vertex"]))
        for each in row["features"]
    ]


def _texts(names: set[tuple[object, ...]]) -> str:
    return ", ".join(sorted(" ".join(map(str, name)) for name in names)) or "nothing more"


def _told(row: Mapping[str, Any]) -> str:
    x, y = row["place"]
    return f"{row['kind']} at ({x:.9g}, {y:.9g}), radius {row['radius']['low']:.9g}"
