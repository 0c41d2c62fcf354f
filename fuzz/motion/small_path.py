"""Steps that make a path case smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

from minkref.fuzz.plane.small_case import PlaneCase, smaller_in_plane
from minkref.fuzz.plane.smaller_operands import Point, plain_operand, scaled_operand, vertices_of


@dataclass(frozen=True)
class SmallPath:
    """`operands`: part and obstacles, at the scale 1. `window`: bounds on scales, or None."""

    operands: PlaneCase
    path: tuple[Point, ...]
    contact: str
    scales: tuple[Fraction, ...]
    window: tuple[Fraction, Fraction] | None

    @staticmethod
    def read(literal: str) -> SmallPath:
        value = json.loads(literal)
        part, obstacles = (json.dumps(value[word]) for word in ("part", "obstacles"))
        window = (Fraction(value["from"]), Fraction(value["to"])) if "from" in value else None
        return SmallPath(
            PlaneCase.read(part, obstacles, "1"),
            tuple((Fraction(x), Fraction(y)) for x, y in value["path"]),
            value["contact"],
            tuple(map(Fraction, value.get("scales", ()))),
            window,
        )

    @cached_property
    def size(self) -> tuple[int, int, int, int, str]:
        """Counts vertices, including the path's; rings; scales; the numbers' length."""
        vertices, rings, *_ = self.operands.size
        text = self.literal
        length = len(text) + 2 * text.count("-") + 20 * text.count("/")
        return (vertices + len(self.path), rings, len(self.scales), length, text)

    @cached_property
    def literal(self) -> str:
        value: dict[str, Any] = {
            "part": plain_operand(self.operands.P),
            "obstacles": plain_operand(self.operands.Q),
            "path": [[str(x), str(y)] for x, y in self.path],
            "contact": self.contact,
        }
        if self.window is None:
            value["scales"] = list(map(str, self.scales))
        else:
            value |= {"from": str(self.window[0]), "to": str(self.window[1])}
        return json.dumps(value, separators=(",", ":"))


def smaller_paths(case: SmallPath) -> Iterator[SmallPath]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.path and candidate.size < case.size:
            yield candidate


def _candidates(case: SmallPath) -> Iterator[SmallPath]:
    if len(case.scales) > 1:
        for scale in case.scales:
            yield replace(case, scales=(scale,))
    path = case.path
    if len(path) > 1:
        yield from (replace(case, path=(point,)) for point in path)
    if len(path) > 2:
        yield from (replace(case, path=path[k : k + 2]) for k in range(len(path) - 1))
        yield from (replace(case, path=path[:k] + path[k + 1 :]) for k in range(len(path)))
    if len(case.scales) == 1 and case.scales[0] != 1:
        part = scaled_operand(case.operands.P, case.scales[0])
        operands = replace(case.operands, P=part)
        if operands.valid():
            yield replace(case, operands=operands, scales=(Fraction(1),))
    yield from (replace(case, operands=fewer) for fewer in smaller_in_plane(case.operands))
    yield from _simpler_numbers(case)


def _simpler_numbers(case: SmallPath) -> Iterator[SmallPath]:
    numbers = [axis for point in case.path for axis in point]
    P, Q = case.operands.P, case.operands.Q
    numbers += [axis for operand in (P, Q) for point in vertices_of(operand) for axis in point]
    factor = Fraction(lcm(*(number.denominator for number in numbers)))
    if factor != 1:
        operands = replace(case.operands, P=scaled_operand(P, factor), Q=scaled_operand(Q, factor))
        path = tuple((factor * x, factor * y) for x, y in case.path)
        yield replace(case, operands=operands, path=path)
    for most in (1, 2, 4):
        path = tuple((x.limit_denominator(most), y.limit_denominator(most)) for x, y in case.path)
        yield replace(case, path=path)
    for scale in case.scales if len(case.scales) == 1 else ():
        for most in (1, 2, 4, 8):
            near = scale.limit_denominator(most)
            if near > 0:
                yield replace(case, scales=(near,))
