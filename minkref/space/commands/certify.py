"""`minkref certify P Q` of polyhedra: the sum at one scaling."""

from __future__ import annotations

from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.errors import Refusal
from minkref.space.operand import SpaceOperand, read_summand
from minkref.space.scaling import UNIT
from minkref.verbs.certificate_output import CertificateFiles
from minkref.verbs.certify import CertifyInSpace
from minkref.verbs.certify_answer import Proof, certify


def run(request: CertifyInSpace) -> None:
    files = CertificateFiles.of(request.output, "-o")
    certify(request, files, lambda: _proof(request))


def _proof(request: CertifyInSpace) -> Proof:
    """Convex polyhedra have a form of their own."""
    first, second = read_summand(request.P), read_summand(request.Q)
    for operand in (first, second):
        _refuse_thin(operand)

    def make() -> ConvexCertificate | SolidCertificate:
        convex = first.body is not None and second.body is not None
        form = ConvexCertificate if convex else SolidCertificate
        certificate = form(first.surface, second.surface)
        certificate.sum(UNIT if request.scale is None else request.scale)
        return certificate

    return Proof([first.file, second.file], make)


def _refuse_thin(operand: SpaceOperand) -> None:
    """Refuses an operand without volume, which has no certificate."""
    if not operand.is_solid:
        mend = "give a polyhedron by its faces"
        raise Refusal("the operand has no volume", operand.name, mend, "not-solid")
