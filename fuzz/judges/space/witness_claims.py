"""Certifies witnesses about sums in space."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.space.solid_point_certificate import SolidPointCertificate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.claimed import Claimed, NoForm, place_text
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Witness
from minkref.scaling import read_scaling


def claimed(case: CaseResult, witness: Witness) -> Claimed:
    """Claims where the point lies. Raises NoForm for operands without volume, Refusal for too many
    convex pieces."""
    if witness.boundary:
        raise NoForm("the sum of the boundaries is meant")
    assert case.P is not None and case.Q is not None
    bodies = Polyhedron.from_json(case.P), Polyhedron.from_json(case.Q)
    if not all(body.faces for body in bodies):
        raise NoForm("an operand has no volume")
    certificate = SolidPointCertificate(*map(_surface, bodies))
    scale = witness.scale or case.scale
    claim = certificate.point if witness.in_truth else certificate.outside
    x, y, z = witness.point
    claim(read_scaling(scale), (x, y, z))
    side = "inside" if witness.in_truth else "outside"
    return Claimed(f"{place_text(witness)} is {side} the sum at {scale}", certificate)


def is_true(case: Any, claim: Any) -> bool:
    """Tests all pairs of faces, of S P and of the point less Q."""
    P, Q = (Polyhedron.from_document(case[name]) for name in "PQ")
    x, y, z = map(Fraction, claim["scaling"])
    is_outside = holds(P, Q, (x, y, z), Witness(tuple(claim["point"]), False))
    return bool(is_outside == (claim["claim"] == "outside"))


def _surface(body: Polyhedron) -> _core.Polyhedron:
    value = body.document()
    return _core.Polyhedron([(x, y, z) for x, y, z in value["vertices"]], value["faces"])
