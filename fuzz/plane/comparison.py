"""A disagreement is settled by points that are decided from the definition, never by a vote."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from fractions import Fraction

from minkref import _core
from minkref.fuzz.plane.boundary_sum import decide_boundary
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.region import Region, inner_point, minus
from minkref.fuzz.plane.tolerance import grown, shrunk
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness


class WitnessRefuted(Exception):
    """The reference's own decision about a point does not stand the check in plain fractions."""


@dataclass
class Settlement:
    """Which of two results is refuted, each by a witness. `reasons` tell how the claim differs."""

    claim: Witness | None = None
    truth: Witness | None = None
    reasons: list[Reason] = field(default_factory=list)
    differ: bool = False


def decide(case: Case, point: tuple[str, str], boundary: bool = False) -> Witness:
    """Whether the point lies in the sum, by pairs of triangles, checked again in plain fractions.
    A point where the operands only touch belongs to the sum: it is closed. `boundary`: in the sum
    of the boundaries."""
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
    """A point of the sum: that of two vertices. Of the empty sum the origin, which is outside."""
    corners = [json.loads(text)["polygons"] for text in (case.scaled_P_json, case.Q_json)]
    if not all(corners):
        return decide(case, ("0", "0"))
    (px, py), (qx, qy) = (polygons[0]["outer"][0] for polygons in corners)
    return decide(case, (str(Fraction(px) + Fraction(qx)), str(Fraction(py) + Fraction(qy))))


def settle(
    case: Case, truth: Region, claim: Region, half: Fraction = Fraction(0), boundary: bool = False
) -> Settlement:
    """Decides a point that only `truth` has and one that only `claim` has, where there are such.
    With `half` only points count whose whole square of that half side lies inside, or outside.
    `boundary`: the sum of the boundaries is meant."""
    settled = Settlement()
    least, most = shrunk(truth.json, half), grown(truth.json, half)
    absent, surplus = minus(least, claim.json), minus(claim.json, most)
    for part, reason in ((absent, Reason.MISSING), (surplus, Reason.EXTRA)):
        point = inner_point(part)
        if point is None:
            continue
        settled.differ = True
        witness = decide(case, point, boundary)
        agrees = witness.in_truth == (reason is Reason.MISSING)
        if half and agrees:
            witness = replace(witness, tolerance=str(half))
            if not holds(case.P_json, case.Q_json, case.scale, witness):
                continue  # its square is cut into too many cells
        if witness.in_truth == (reason is Reason.MISSING):
            settled.claim = settled.claim or witness
            settled.reasons.append(reason)
        else:
            settled.truth = settled.truth or witness
    if settled.claim is not None:
        settled.reasons = _sharpen(
            settled.reasons, truth, claim, absent, surplus, _outers(least), _holes(most)
        )
    return settled


def _sharpen(
    reasons: list[Reason],
    truth: Region,
    claim: Region,
    absent: _core.PolygonSet,
    surplus: _core.PolygonSet,
    outers: set[frozenset[tuple[str, str]]],
    holes: set[frozenset[tuple[str, str]]],
) -> list[Reason]:
    """Names lost and invented holes and components; `missing` and `extra` are left out where these
    explain all of the difference. `outers` and `holes` are rings of what the result may be at
    least, and at most."""
    found: list[Reason] = []
    if Reason.EXTRA in reasons:
        if claim.holes < truth.holes:
            found.append(Reason.HOLE_LOST)
        elif claim.components > truth.components:
            found.append(Reason.COMPONENT)
        if not (found and _pieces(surplus) <= holes | _outers(claim.json)):
            found.append(Reason.EXTRA)
    if Reason.MISSING in reasons:
        more: list[Reason] = []
        if claim.holes > truth.holes:
            more.append(Reason.HOLE_INVENTED)
        elif claim.components < truth.components:
            more.append(Reason.COMPONENT)
        if not (more and _pieces(absent) <= _holes(claim.json) | outers):
            more.append(Reason.MISSING)
        found += [reason for reason in more if reason not in found]
    return found


def _key(ring: list[list[str]]) -> frozenset[tuple[str, str]]:
    return frozenset((x, y) for x, y in ring)


def _pieces(region: _core.PolygonSet) -> set[frozenset[tuple[str, str]]]:
    polygons = json.loads(region.canonical_json())["polygons"]
    return {_key(polygon["outer"]) for polygon in polygons}


def _outers(text: str) -> set[frozenset[tuple[str, str]]]:
    return {_key(polygon["outer"]) for polygon in json.loads(text)["polygons"]}


def _holes(text: str) -> set[frozenset[tuple[str, str]]]:
    polygons = json.loads(text)["polygons"]
    return {_key(hole) for polygon in polygons for hole in polygon["holes"]}
