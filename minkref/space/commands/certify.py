"""`minkref certify P Q` of polyhedra: the sum at one scaling, or a point."""

from __future__ import annotations

from minkref.certify.plane.certificate import NoProof
from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.certify.space.solid_point_certificate import SolidPointCertificate
from minkref.errors import Refusal
from minkref.scaling import Scaling
from minkref.space.operand import SpaceOperand, read_summand
from minkref.space.scaling import UNIT
from minkref.verbs.certificate_output import CertificateFiles
from minkref.verbs.certify import CertifyInSpace
from minkref.verbs.certify_answer import Proof, certify


def run(request: CertifyInSpace) -> None:
    files = CertificateFiles.of(request.output, "-o")
    certify(request, files, lambda: _proof(request))


def _proof(request: CertifyInSpace) -> Proof:
    """Sums of convex polyhedra have a form of their own, and so have points."""
    first, second = read_summand(request.P), read_summand(request.Q)
    for operand in (first, second):
        _refuse_thin(operand)

    scaling = UNIT if request.scale is None else request.scale

    def make() -> ConvexCertificate | SolidCertificate | SolidPointCertificate:
        if request.point is not None:
            return _of_point(SolidPointCertificate(first.surface, second.surface), scaling, request)
        convex = first.body is not None and second.body is not None
        form = ConvexCertificate if convex else SolidCertificate
        certificate = form(first.surface, second.surface)
        certificate.sum(scaling)
        return certificate

    return Proof([first.file, second.file], make)


def _of_point(
    certificate: SolidPointCertificate, scaling: Scaling, request: CertifyInSpace
) -> SolidPointCertificate:
    """In the sum, or not."""
    assert request.point is not None
    try:
        certificate.outside(scaling, request.point)
    except NoProof:
        certificate.point(scaling, request.point)
    return certificate


def _refuse_thin(operand: SpaceOperand) -> None:
    """Refuses an operand without volume, which has no certificate."""
    if not operand.is_solid:
        mend = "give a polyhedron by its faces"
        raise Refusal("the operand has no volume", operand.name, mend, "not-solid")
