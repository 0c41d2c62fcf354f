"""Drafts from a generator of polyhedra of any shape, and facts about them."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from minkref import _core
from minkref.degeneracies.family import Family
from minkref.degeneracies.solids.convolution import Convolution, sum_at
from minkref.degeneracies.solids.euler import euler_of_meeting
from minkref.degeneracies.solids.mesh import Mesh
from minkref.degeneracies.solids.ties import Predicates, Tie
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.meeting import Contact, Meeting
from minkref.fuzz.space.thin_meeting import ThinMeeting

WIDE = Fraction(1, 4)  # relative distance of the outer siblings
FINE = Fraction(1, 2**60)  # and of the nearest
ONE = Fraction(1)


@dataclass(frozen=True)
class Probe:
    """The point `s p + q`, at every scale s."""

    p: Point
    q: Point

    def at(self, s: Fraction) -> Point:
        return sum_at(self.p, self.q, s)


@dataclass(frozen=True)
class SolidDraft:
    """Two polyhedra, the degenerate scale, and points that show the degeneracy. `plain`: both
    polyhedra without details that change no sum, if the family is about such details."""

    P: Polyhedron
    Q: Polyhedron
    scale: Fraction = ONE
    probes: tuple[Probe, ...] = ()
    plain: tuple[Polyhedron, Polyhedron] | None = None


@dataclass(frozen=True)
class SolidFacts:
    """A draft as the reference sees it. All exact, computed when asked for."""

    P: Mesh
    Q: Mesh
    scale: Fraction
    probes: tuple[Probe, ...]
    plain: tuple[Polyhedron, Polyhedron] | None
    _sums: dict[Fraction, _core.PolyhedralSet] = field(default_factory=dict, compare=False)
    _contacts: dict[Probe, list[Contact]] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, draft: SolidDraft) -> SolidFacts:
        """Raises _core.BadInput if an operand is invalid."""
        P, Q = Mesh(draft.P), Mesh(draft.Q)
        P.certify("P")
        Q.certify("Q")
        return cls(P, Q, draft.scale, draft.probes, draft.plain)

    @cached_property
    def scales(self) -> list[Fraction]:
        """The scale; two below it, and two above."""
        steps = (-WIDE, -FINE, WIDE, FINE)
        return [self.scale, *(self.scale * (1 + step) for step in steps)]

    @cached_property
    def convolution(self) -> Convolution:
        return Convolution(self.P, self.Q)

    @cached_property
    def predicates(self) -> Predicates:
        return Predicates(self.P, self.Q, self.convolution)

    def signs(self, tie: Tie) -> list[int]:
        """Signs at each scale."""
        return [self.predicates.value(tie, s) for s in self.scales]

    def contacts(self, probe: Probe) -> list[Contact]:
        """At each of the scales, how sP meets `x - Q`."""
        if probe not in self._contacts:
            thin = self.P.given.is_thin or self.Q.given.is_thin
            kind = ThinMeeting if thin else Meeting
            self._contacts[probe] = [
                kind(self.P.given, self.Q.given, s).decide(probe.at(s)).contact for s in self.scales
            ]
        return self._contacts[probe]

    def euler(self, probe: Probe) -> int | None:
        """The Euler characteristic of the intersection of sP and `x - Q` at the scale, for
        polycubes: it equals the full convolution's winding number around x. None for other
        solids."""
        return euler_of_meeting(self.P.given, self.Q.given, self.scale, probe.at(self.scale))

    def sum(self, s: Fraction) -> _core.PolyhedralSet:
        """By edges."""
        if s not in self._sums:
            self._sums[s] = _core.edge_sum_in_space(self.P.surface, self.Q.surface, (str(s),) * 3)
        return self._sums[s]


class SolidFamily(Family[SolidDraft, SolidFacts]):
    """A family of polyhedra of any shape: `belongs` gives some ties."""

    def look(self, draft: SolidDraft) -> SolidFacts:
        return SolidFacts.of(draft)
