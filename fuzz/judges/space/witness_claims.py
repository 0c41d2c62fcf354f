"""Certificates of witnesses about sums in space."""

from __future__ import annotations

from minkref import _core
from minkref.certify.space.solid_point_certificate import SolidPointCertificate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.claimed import Claimed, NoForm, place_text
from minkref.fuzz.run.worker import CaseResult
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


def _surface(body: Polyhedron) -> _core.Polyhedron:
    value = body.document()
    return _core.Polyhedron([(x, y, z) for x, y, z in value["vertices"]], value["faces"])
