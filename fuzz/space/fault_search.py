"""Searches one result for wrong points, each proven by a witness."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.known_sum import known_sum
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness


@dataclass
class FaultSearch:
    """With a tolerance, only points count whose whole cube with this half side lies inside the sum,
    or outside. `refuted` says that a witness failed its check: the fault is ours."""

    pair: SpacePair
    whole: Polyhedron  # the result with pairs of faces that cancel
    result: Polyhedron  # without, by the same vertices
    tolerance: Fraction
    reasons: list[Reason] = field(default_factory=list)
    witness: Witness | None = None
    points: int = 0
    refuted: str | None = None
    unproven: Point | None = None  # the sum has the cube around it, but no p and q were found

    def __post_init__(self) -> None:
        self.surface = Surface(self.result)
        self.known = known_sum(self.pair)

    def test(self, x: Point) -> Reason | None:
        """Returns MISSING or EXTRA at its first discovery; None if the result is right at the
        point, or nothing can be said."""
        self.points += 1
        winding = self.surface.winding(x)
        if winding is None:
            return None
        reason = Reason.EXTRA if winding > 0 else Reason.MISSING
        if reason in self.reasons:
            return None
        return self._extra(x) if winding > 0 else self._missing(x)

    def test_inside(self, p: Point, q: Point) -> Reason | None:
        """Tests scale p + q for points of the operands with a cube around scale p in sP, or around
        q in Q."""
        self.points += 1
        s = self.pair.meeting.scale
        x = (s[0] * p[0] + q[0], s[1] * p[1] + q[1], s[2] * p[2] + q[2])
        winding = self.surface.winding(x)
        if winding is None or winding > 0 or Reason.MISSING in self.reasons:
            return None
        return self._found(Reason.MISSING, inside(x, p, q))

    def _extra(self, x: Point) -> Reason | None:
        clear = (
            not self.known.contains(x)
            if self.tolerance == 0
            else self.known.clear_of(x, self.tolerance)
        )
        return self._found(Reason.EXTRA, outside(x)) if clear else None

    def _missing(self, x: Point) -> Reason | None:
        if self.tolerance == 0:
            if not self.known.contains(x):
                return None
            place = self.pair.meeting.place(x)
            if place is None:
                self.refuted = f"the point {_text(x)} is in the sum and is not"
                return None
            decision = self.pair.meeting.decision("touch", place, x)
        else:
            if not self.known.may_cover(x, self.tolerance):
                return None
            found = self.pair.meeting.deep(x, self.tolerance)
            if found is None:
                self.unproven = x
                return None
            decision = found
        assert decision.p is not None and decision.q is not None
        return self._found(Reason.MISSING, inside(x, decision.p, decision.q))

    def _found(self, reason: Reason, witness: Witness) -> Reason | None:
        pair = self.pair
        witness = replace(witness, tolerance=str(self.tolerance))
        if not holds(pair.P, pair.Q, pair.scale, witness):
            self.refuted = f"the witness ({', '.join(witness.point)}) does not hold"
            return None
        self.reasons.append(reason)
        self.witness = self.witness or witness
        return reason


def decided(pair: SpacePair, x: Point) -> Witness:
    """Whether the point lies in the closed sum."""
    place = pair.meeting.place(x)
    if place is None:
        return outside(x)
    decision = pair.meeting.decision("touch", place, x)
    assert decision.p is not None and decision.q is not None
    return inside(x, decision.p, decision.q)


def inside(x: Point, p: Point, q: Point) -> Witness:
    return Witness(_text(x), True, _text(p), _text(q))


def outside(x: Point) -> Witness:
    return Witness(_text(x), False)


def _text(point: Point) -> tuple[str, ...]:
    return tuple(str(number) for number in point)
