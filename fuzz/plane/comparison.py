"""Settles disagreements by points, decided from the definition, never by a vote."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Protocol

from minkref import _core
from minkref.fuzz.geometry.plane import Point, scale_factors
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.boundary_sum import decide_boundary
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.tolerance import grown, shrunk
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness


class WitnessRefuted(Exception):
    """The reference's own decision about a point does not stand the check in plain fractions."""


@dataclass
class Settlement:
    """Witnesses that refute the claim, or the truth. `reasons` say how the claim differs."""

    claim: Witness | None = None
    truth: Witness | None = None
    reasons: list[Reason] = field(default_factory=list)
    differ: bool = False


def decide(case: Case, point: tuple[str, str], boundary: bool = False) -> Witness:
    """Decides by pairs of triangles whether the point lies in the sum, checked again in plain
    fractions. A point where the operands only touch belongs to the closed sum. `boundary`: decides
    for the sum of boundaries."""
    if boundary:
        witness = decide_boundary(case, point)
        if not holds(case.P_json, case.Q_json, case.scale, witness):
            raise WitnessRefuted(f"the point ({point[0]}, {point[1]}) on {case.name.text}")
        return witness
    answer = _core.decide(case.P, case.Q, case.scale, point[0], point[1])
    inside = answer["contact"] != "empty"
    p, q = answer["p"], answer["q"]
    witness = Witness(
        point, inside, (p[0], p[1]) if inside else None, (q[0], q[1]) if inside else None
    )
    if not holds(case.P_json, case.Q_json, case.scale, witness):
        raise WitnessRefuted(f"the point ({point[0]}, {point[1]}) on {case.name.text}")
    return witness


def some_point(case: Case) -> Witness:
    """Returns a point of the sum, from two vertices. If the sum is empty, the origin, outside."""
    if case.P.is_empty or case.Q.is_empty:
        return decide(case, ("0", "0"))
    (a, b), (px, py), (qx, qy) = scale_factors(case.scale), _first(case.P), _first(case.Q)
    return decide(case, (str(a * px + qx), str(b * py + qy)))


def _first(operand: _core.PolygonSet) -> Point:
    """A vertex."""
    return shape_of(operand)[0][0][0]


class Definition(Protocol):
    """Decides points of a set from the definition of the set, and checks witnesses."""

    def decide(self, point: tuple[str, str]) -> Witness:
        """Raises WitnessRefuted."""

    def holds(self, witness: Witness) -> bool: ...


@dataclass(frozen=True)
class SumOf:
    """The sum of a case's operands, or of their boundaries."""

    case: Case
    boundary: bool = False

    def decide(self, point: tuple[str, str]) -> Witness:
        return decide(self.case, point, self.boundary)

    def holds(self, witness: Witness) -> bool:
        return holds(self.case.P_json, self.case.Q_json, self.case.scale, witness)


def settle(
    defined: Definition, truth: Region, claim: Region, half: Fraction = Fraction(0)
) -> Settlement:
    """Decides a point that only `truth` has and a point that only `claim` has, if such points
    exist. With `half` only points count whose whole square with this half side lies inside, or
    outside."""
    settled = Settlement()
    least, most = shrunk(truth.set, half), grown(truth.set, half)
    absent, surplus = _core.minus(least, claim.set), _core.minus(claim.set, most)
    for part, reason in ((absent, Reason.MISSING), (surplus, Reason.EXTRA)):
        point = _core.inner_point(part)
        if point is None:
            continue
        settled.differ = True
        witness = defined.decide(point)
        agrees = witness.in_truth == (reason is Reason.MISSING)
        if half and agrees:
            witness = replace(witness, tolerance=str(half))
            if not defined.holds(witness):
                continue  # its square would need too many cells
        if agrees:
            settled.claim = settled.claim or witness
            settled.reasons.append(reason)
        else:
            settled.truth = settled.truth or witness
    if settled.claim is not None:
        settled.reasons = _sharpen(settled.reasons, truth, claim, absent, surplus, least, most)
    return settled


def _sharpen(
    reasons: list[Reason],
    truth: Region,
    claim: Region,
    absent: _core.PolygonSet,
    surplus: _core.PolygonSet,
    least: _core.PolygonSet,
    most: _core.PolygonSet,
) -> list[Reason]:
    """Names lost and invented holes and components; omits `missing` and `extra` if these explain
    the whole difference. `least` and `most`: bounds for the result."""
    found: list[Reason] = []
    if Reason.EXTRA in reasons:
        if claim.holes < truth.holes:
            found.append(Reason.HOLE_LOST)
        elif claim.components > truth.components:
            found.append(Reason.COMPONENT)
        if not (found and _outers(surplus) <= _holes(most) | _outers(claim.set)):
            found.append(Reason.EXTRA)
    if Reason.MISSING in reasons:
        more: list[Reason] = []
        if claim.holes > truth.holes:
            more.append(Reason.HOLE_INVENTED)
        elif claim.components < truth.components:
            more.append(Reason.COMPONENT)
        if not (more and _outers(absent) <= _holes(claim.set) | _outers(least)):
            more.append(Reason.MISSING)
        found += [reason for reason in more if reason not in found]
    return found


def _outers(region: _core.PolygonSet) -> set[frozenset[Point]]:
    return {frozenset(outer) for outer, *_ in shape_of(region)}


def _holes(region: _core.PolygonSet) -> set[frozenset[Point]]:
    return {frozenset(hole) for _, *holes in shape_of(region) for hole in holes}
