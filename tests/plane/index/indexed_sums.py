"""Pairs of operands to be indexed, scales to ask about, the exact numbers of an answer."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy
from minkref import _core
from minkref.fuzz.plane.families.random_pairs import random_pair
from minkref.plane.operand import read_operand
from numpy.typing import NDArray
from pairs_of_texts import ISLANDS, RING_OF_SQUARES, SEVERAL_COMPONENTS, TRIANGLE
from thoroughness import draws

Index = _core.ScaleIndex
Rings = _core.IndexRings
Point = tuple[Fraction, Fraction]

FORMS = ("double", "homogeneous", "rational", "track")
NUMBERS = {"double": ("x", "y"), "homogeneous": ("homogeneous",), "rational": ("rational",),
           "track": ("tracks",)}  # fmt: skip

TEXTS = {
    "islands": ISLANDS,
    "several components": SEVERAL_COMPONENTS,
    "touching": (RING_OF_SQUARES, TRIANGLE),
    "a point": ("POINT(-3 5)", RING_OF_SQUARES),
    "a segment": ("POLYGON((0 0,3 0,3 3,2 3,2 1,0 3,0 0))", "LINESTRING(-1 2,3 -1)"),
    "a segment past touching rings": (
        "LINESTRING(0 0,2 0)",
        "POLYGON((0 7,-5 -3,1 0,0 7),(-3 1,0 1,0 0,-3 1))",
    ),
    "nothing": ("POLYGON EMPTY", TRIANGLE),
}
MODELS = {"letters": ("g1", "g2"), "right angles": ("g3", "g1")}
NAMES = (*TEXTS, *MODELS, "huge and tiny", *(f"random {k}" for k in range(draws(3, 6))))
# A pair whose boundary needs integers longer than a word.
LONG = "huge and tiny"


def operands(name: str) -> tuple[_core.PolygonSet, _core.PolygonSet]:
    if name in TEXTS:
        P, Q = TEXTS[name]
        return _core.read_text(P, "wkt"), _core.read_text(Q, "wkt")
    if name in MODELS:
        P, Q = MODELS[name]
        return read_operand(P).set, read_operand(Q).set
    if name == LONG:
        P, Q = operands("several components")
        tiny = str(Fraction(1, 3**50))
        return P.translated("-" + tiny, tiny), Q.translated("1" + 40 * "0", "-1" + 40 * "0")
    pair = random_pair(40, 97 * int(name.split()[1]))
    return _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)


def window_of(name: str) -> tuple[str | None, str | None]:
    return ("1/3", "5") if name in ("letters", "random 1") else (None, None)


def scales(index: Index, most: int = draws(6, 12)) -> list[str]:
    """Event scales, topology events first, and scales between them, beyond them, and at the
    window's ends."""
    low, high = index.window
    events = sorted(
        s for s in index.event_scales() if (low is None or s >= low) and (high is None or s <= high)
    )
    topology = list(dict.fromkeys(Fraction(row[0]) for row in index.topology_events()))
    chosen = topology[: most // 3] + events[:: 1 + len(events) // most]
    ends = [low or (events[0] if events else high or Fraction(1)) / 2]
    ends += [high or 2 * (events[-1] if events else ends[0])]
    middles = [(a + b) / 2 for a, b in pairwise(events) if a in chosen and a < b]
    return [str(s) for s in dict.fromkeys([*ends, (ends[0] + ends[1]) / 2, *chosen, *middles])]


def integers(words: NDArray[numpy.uint64]) -> Any:
    """Nested lists of integers, or a single integer, from an array whose last axis holds the words
    of an integer."""
    if words.ndim > 1:
        return [integers(part) for part in words]
    data = words.astype("<u8").tobytes()
    return int.from_bytes(data, "little", signed=True)


def exact_tracks(index: Index) -> list[tuple[Point, Point]]:
    return [
        ((Fraction(a[0]), Fraction(a[1])), (Fraction(b[0]), Fraction(b[1])))
        for a, b in index.tracks()
    ]


def points(index: Index, rings: Rings) -> list[Point]:
    """The rings' points, from any exact form."""
    if rings.form == "homogeneous":
        return [(Fraction(x, w), Fraction(y, w)) for x, y, w in integers(rings.homogeneous)]
    if rings.form == "rational":
        return [(Fraction(a, b), Fraction(c, d)) for a, b, c, d in integers(rings.rational)]
    s, tracks = Fraction(rings.scale), exact_tracks(index)
    return [
        (a[0] + s * b[0], a[1] + s * b[1]) for a, b in (tracks[track] for track in rings.tracks)
    ]


def arrays(rings: Rings) -> Iterator[tuple[str, NDArray[Any]]]:
    for name in ("ring_ends", "edges", *NUMBERS[rings.form]):
        yield name, getattr(rings, name)
