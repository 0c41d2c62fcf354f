"""Steps that make a plane case smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd, lcm

from minkref.fuzz.plane.smaller_operands import (
    Operand,
    fewer_holes,
    fewer_polygons,
    gaps,
    is_valid_operand,
    moved_operand,
    narrowed,
    plain_operand,
    ranked,
    read_operand_text,
    rounded_operand,
    scaled_operand,
    vertices_moved,
    vertices_of,
    with_denominators,
    without_runs,
    without_vertices,
)
from minkref.plane.scaling import PlaneScale, factors_of, read_plane_scale, text_of


@dataclass(frozen=True)
class PlaneCase:
    P: Operand
    Q: Operand
    scale: PlaneScale

    @cached_property
    def size(self) -> tuple[int, int, int, str]:
        """Vertices first; then holes and polygons; then the numbers' length, where a scale other
        than 1 counts more than its length."""
        text = self.literal
        rings = [ring for operand in (self.P, self.Q) for polygon in operand for ring in polygon]
        length = len(text) + (0 if self.scale == 1 else 40) + 2 * text.count("-")
        length += 20 * text.count("/")
        return (sum(len(ring) for ring in rings), len(rings), length, text)

    @cached_property
    def literal(self) -> str:
        value = {
            "P": plain_operand(self.P),
            "Q": plain_operand(self.Q),
            "scale": text_of(self.scale),
        }
        return json.dumps(value, separators=(",", ":"))

    @staticmethod
    def read(P_json: str, Q_json: str, scale: str) -> PlaneCase:
        return PlaneCase(
            read_operand_text(P_json), read_operand_text(Q_json), read_plane_scale(scale)
        )

    def valid(self) -> bool:
        return all(map(is_valid_operand, self.operands))

    def with_operand(self, which: int, operand: Operand) -> PlaneCase:
        P, Q = (self.P, operand) if which else (operand, self.Q)
        return PlaneCase(P, Q, self.scale)

    @property
    def operands(self) -> tuple[Operand, Operand]:
        return (self.P, self.Q)


def smaller_in_plane(case: PlaneCase) -> Iterator[PlaneCase]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and candidate.valid():
            yield candidate


def _simpler_scales(scale: PlaneScale) -> Iterator[PlaneScale]:
    """Whole numbers; given a factor for each axis, also either factor for both."""
    whole = [Fraction(round(factor) or 1) for factor in factors_of(scale)]
    yield whole[0] if whole[0] == whole[1] else (whole[0], whole[1])
    if isinstance(scale, tuple):
        yield from scale


def _candidates(case: PlaneCase) -> Iterator[PlaneCase]:
    if case.scale != 1:
        yield PlaneCase(case.P, case.Q, Fraction(1))
        yield PlaneCase(scaled_operand(case.P, case.scale), case.Q, Fraction(1))
        yield from (PlaneCase(case.P, case.Q, scale) for scale in _simpler_scales(case.scale))
    for which, operand in enumerate(case.operands):
        for fewer in (*fewer_polygons(operand), *fewer_holes(operand)):
            yield case.with_operand(which, fewer)
    for part in (2, 3, 4):
        for which, operand in enumerate(case.operands):
            for fewer in without_runs(operand, part):
                yield case.with_operand(which, fewer)
    for which, operand in enumerate(case.operands):
        for fewer in without_vertices(operand, 1):
            yield case.with_operand(which, fewer)
    yield from _simpler_numbers(case)
    for which, operand in enumerate(case.operands):
        for fewer in without_vertices(operand, 2):
            yield case.with_operand(which, fewer)
    for which, operand in enumerate(case.operands):
        for moved in vertices_moved(operand):
            yield case.with_operand(which, moved)


def _simpler_numbers(case: PlaneCase) -> Iterator[PlaneCase]:
    for which, operand in enumerate(case.operands):
        points = vertices_of(operand)
        if points:
            x, y = min(p[0] for p in points), min(p[1] for p in points)
            yield case.with_operand(which, moved_operand(operand, (-x, -y)))
    both = vertices_of(case.P) + vertices_of(case.Q)
    if both:
        denominator = lcm(*(number.denominator for point in both for number in point))
        divisor = gcd(*(int(number * denominator) for point in both for number in point))
        if divisor:
            factor = Fraction(denominator, divisor)
            yield PlaneCase(
                scaled_operand(case.P, factor), scaled_operand(case.Q, factor), case.scale
            )
        for unit in (8, 4, 2, 1):
            step = Fraction(unit)
            yield PlaneCase(
                rounded_operand(case.P, step), rounded_operand(case.Q, step), case.scale
            )
        for factor in (Fraction(1, 16), Fraction(1, 4), Fraction(1, 2)):
            P, Q = scaled_operand(case.P, factor), scaled_operand(case.Q, factor)
            yield PlaneCase(
                rounded_operand(P, Fraction(1)), rounded_operand(Q, Fraction(1)), case.scale
            )
    for most in (1, 2, 4, 8, 16, 64):
        yield PlaneCase(
            with_denominators(case.P, most), with_denominators(case.Q, most), case.scale
        )
        for which, operand in enumerate(case.operands):
            yield case.with_operand(which, with_denominators(operand, most))
    for which, operand in enumerate(case.operands):
        yield case.with_operand(which, ranked(operand))
        for axis in (0, 1):
            for gap in gaps(operand, axis):
                yield case.with_operand(which, narrowed(operand, axis, *gap))
