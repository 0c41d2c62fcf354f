"""Certifies witnesses about sums and unions."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.fuzz.judges.claimed import Claimed, NoForm, place_text
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Witness


def claimed(case: CaseResult, witness: Witness) -> Claimed:
    """Claims where the point lies. Raises NoForm, or NoProof without a proof."""
    return _sum(case, witness) if case.union is None else _union(case.union, witness)


def is_true(case: Any, claim: Any) -> bool:
    """Asks the slow engine about a claim `point` or `outside`."""
    return Confirmation(json.dumps(case)).holds(claim, [claim])


def _sum(case: CaseResult, witness: Witness) -> Claimed:
    if witness.boundary:
        raise NoForm("the sum of the boundaries is meant")
    assert case.P is not None and case.Q is not None
    scale = witness.scale or case.scale
    axes = scale.split(",") if "," in scale else None
    operands = _core.PolygonSet.from_json(case.P), _core.PolygonSet.from_json(case.Q)
    certificate = Certificate(*operands, axes)
    claim = certificate.point if witness.in_truth else certificate.outside
    claim("1" if axes else scale, (witness.point[0], witness.point[1]))
    side = "inside" if witness.in_truth else "outside"
    return Claimed(f"{place_text(witness)} is {side} the sum at {scale}", certificate)


def _union(literal: str, witness: Witness) -> Claimed:
    sets = [_core.PolygonSet.from_json(json.dumps(one)) for one in json.loads(literal)["sets"]]
    if any(one.rings() and not one.is_region for one in sets):
        raise NoForm("a set is a point or a segment")
    certificate = UnionCertificate(sets)
    certificate.point(witness.point)
    (claim,) = certificate.claims
    holders = [*claim["inside"], *claim["on"]]
    if bool(holders) != witness.in_truth:
        raise RuntimeError("the certificate says otherwise")
    whose = f"in set {holders[0]}" if holders else "in none of the sets"
    return Claimed(f"{place_text(witness)} is {whose}", certificate)
