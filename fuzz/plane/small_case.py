"""Steps that make a plane case smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial

from minkref.fuzz.plane.smaller_operands import (
    Operand,
    is_valid_operand,
    plain_operand,
    ranked,
    read_operand_text,
    rounded_operand,
    scaled_operand,
    with_denominators,
)
from minkref.fuzz.plane.smaller_sets import (
    LIMITS,
    Change,
    bold_steps,
    counts_of,
    fine_steps,
    length_of,
    narrowings,
    to_the_axes,
    whole_factor,
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
        length = length_of(text) + (0 if self.scale == 1 else 40)
        return (*counts_of(self.operands), length, text)

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

    def changed(self, change: Change) -> PlaneCase:
        """Changes both operands."""
        return PlaneCase(change(self.P), change(self.Q), self.scale)

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
    for P, Q in bold_steps(case.operands):
        yield PlaneCase(P, Q, case.scale)
    yield from _simpler_numbers(case)
    for P, Q in fine_steps(case.operands):
        yield PlaneCase(P, Q, case.scale)


def _simpler_numbers(case: PlaneCase) -> Iterator[PlaneCase]:
    for which, operand in enumerate(case.operands):
        move = to_the_axes(operand)
        if move is not None:
            yield case.with_operand(which, move(operand))
    both = case.P + case.Q
    if both:
        factor = whole_factor(both)
        if factor is not None:
            yield case.changed(partial(scaled_operand, factor=factor))
        for unit in map(Fraction, (8, 4, 2, 1)):
            yield case.changed(partial(rounded_operand, step=unit))
        for less in (Fraction(1, 16), Fraction(1, 4), Fraction(1, 2)):
            smaller = case.changed(partial(scaled_operand, factor=less))
            yield smaller.changed(partial(rounded_operand, step=Fraction(1)))
    for most in LIMITS:
        yield case.changed(partial(with_denominators, most=most))
        for which, operand in enumerate(case.operands):
            yield case.with_operand(which, with_denominators(operand, most))
    for which, operand in enumerate(case.operands):
        yield case.with_operand(which, ranked(operand))
        for narrowing in narrowings(operand):
            yield case.with_operand(which, narrowing(operand))
