"""The options --certify and --point of `sum` with a disc: a proof of the sum."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal
from minkref.output.terminal import escaped
from minkref.verbs.certificate_output import CertificateFiles, Checked

MEND = "leave out --certify"


def check_point(certify: object, point: tuple[str, str] | None) -> None:
    """Refuses a point without a proof that could tell about it."""
    if point is not None and certify is None:
        mend = "add --certify FILE.cert.json"
        raise Refusal("points are told in certificates", "--point", mend)


def proved_sum(
    files: CertificateFiles,
    names: str,
    P: _core.PolygonSet,
    square: Fraction,
    known: tuple[int, str],
    point: tuple[str, str] | None,
) -> tuple[Checked, DiscSumCertificate]:
    """The proof, checked and not written yet. `known`: the sum's holes and canonical form. Refuses
    a set that is no region, and a boundary too fine for decimals."""
    try:
        certificate = DiscSumCertificate(P, square)
        certificate.sum(known)
        if point is not None:
            certificate.point(point)
    except NoProof as error:
        mend = error.mend or MEND
        raise Refusal(str(error), names, mend, "no-proof") from error
    return files.checked(certificate, escaped(names), True), certificate
