"""Cases of verb `offset`: a plane set or lines, a disc radius, and perhaps joins and caps.

The radius is a rational number. A set grows by a radius above 0, and a radius below 0 erodes it: it
keeps the points whose distance from its outside is the radius or more. Lines only grow.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.verbs import INSET, LINES, OFFSET, SHARP_INSET
from minkref.fuzz.offsets.curves import NOTHING, form_of
from minkref.fuzz.offsets.distance import Distances, Exact, OutsideDistances
from minkref.fuzz.offsets.event_window import event_within
from minkref.fuzz.offsets.exchange import IN_CURVES
from minkref.fuzz.offsets.hole_points import far_points
from minkref.fuzz.offsets.lines import Line, lines_value, read_lines
from minkref.fuzz.offsets.manner import ROUND, SHARP, Manner, read_manner
from minkref.fuzz.offsets.set_and_radius import SetAndRadius, read_radius, read_set_and_radius


@dataclass(frozen=True)
class AskedOffset(SetAndRadius):
    """`lines`, if any, are sent instead of `set`, which then has their segments."""

    family: str = OFFSET
    lines: tuple[Line, ...] = ()
    manner: Manner = Manner()  # noqa: RUF009 a frozen value

    verb = OFFSET
    exchange = IN_CURVES

    @property
    def inward(self) -> bool:
        return self.radius < 0

    @property
    def is_nothing(self) -> bool:
        """Whether the answer has no interior whatever the radius is."""
        return self.set.is_empty or (self.inward and not self.set.is_region)

    @property
    def Q_name(self) -> str:
        end = ", to erode by" if self.inward else ""
        return f"a disc of radius {abs(self.radius)}{end}" + (
            "" if self.manner.is_round else f", with {self.manner}"
        )

    @cached_property
    def needs(self) -> frozenset[str]:
        if self.lines:
            alone = {"plane", self.verb, LINES, *(super().needs & {"rational"})}
            return frozenset(alone) | self.manner.needs
        if self.manner.join == SHARP:  # targets may have no other offsets
            inward = {SHARP_INSET} if self.inward else set()
            return (super().needs - {self.verb}) | self.manner.needs | inward
        return super().needs | self.manner.needs | ({INSET} if self.inward else set())

    @cached_property
    def asked_json(self) -> str:
        """The set, or the lines, as they are sent."""
        return json.dumps(lines_value(self.lines)) if self.lines else self.P_json

    @cached_property
    def literal(self) -> str:
        value = {self.verb: json.loads(self.asked_json), "radius": str(self.radius)}
        return json.dumps({**value, **self.manner.members()}, separators=(",", ":"))

    @cached_property
    def expected(self) -> _core.Offset:
        """The sum, or the erosion, by the reference."""
        return self.by_disc(self.radius)

    @cached_property
    def form(self) -> str:
        """The truth in curves, as `read_curves` writes them."""
        return NOTHING if self.is_nothing else form_of(self.expected.canonical_json())

    @cached_property
    def counts(self) -> tuple[int, int]:
        """Components and holes of the truth."""
        return self.expected.components, self.expected.holes

    @cached_property
    def near(self) -> Distances:
        """Distances from the set or, to erode, from its outside."""
        return OutsideDistances(self.shape) if self.inward else Distances(self.shape)

    def by_disc(self, radius: Fraction, *route: Any) -> _core.Offset:
        """Grows or erodes the set. `route`: threads and the name of a route."""
        of = _core.inset if self.inward else _core.offset
        return of(self.set, str(radius**2), *route)

    def beyond(self, radius: Fraction) -> list[Exact]:
        """Finds a point farther than a radius in each hole of the grown set or, to erode, in each
        component of what is left, exactly."""
        return far_points(self.by_disc(radius), self.near, radius, outer=self.inward)

    def has_event(self, half: Fraction) -> bool:
        """Whether an event has a radius that differs by at most `half`."""
        P, middle = self.set, abs(self.radius)
        return event_within(
            _core.Outside(P).set if self.inward else P, middle - half, middle + half
        )


def named_offset(name: CaseName, value: dict[str, Any], where: str) -> AskedOffset:
    """Returns the case that a JSON value describes. Refuses other values."""
    given = value[OFFSET]
    is_line = isinstance(given, dict) and "lines" in given
    manner = read_manner(value, is_line, where)
    if is_line:
        lines, segments = read_lines(given["lines"], where)
        if manner.cap != ROUND and any(len(line) == 1 for line in lines):
            raise Refusal("a point has no ends", where, 'leave out "cap", or the point')
        mend = 'write {"offset":{"lines":[...]},"radius":"7/5"}'
        radius = read_radius(value.get("radius"), where, mend, inward=False)
        return AskedOffset(name, segments, radius, lines=lines, manner=manner)
    inward = manner.is_round or manner.join == SHARP
    P, radius = read_set_and_radius(value, OFFSET, where, inward=inward)
    return AskedOffset(name, P, radius, manner=manner)
