"""The options --certify and --point of `sum` with a disc: a proof of the sum."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal
from minkref.output.terminal import escaped
from minkref.verbs.certificate_output import CertificateFiles, Checked

MEND = "leave out --certify"


def check_points(certify: object, points: object) -> None:
    """Refuses points without a proof that could tell about them."""
    if points and certify is None:
        mend = "add --certify FILE.cert.json"
        raise Refusal("points are told in certificates", "--point", mend)


def proved_sum(
    files: CertificateFiles,
    names: str,
    P: _core.PolygonSet,
    square: Fraction,
    known: tuple[int, str],
    points: Sequence[tuple[str, str]],
) -> tuple[Checked, DiscSumCertificate]:
    """The proof, checked and not written yet. `known`: the sum's holes and canonical form. A point
    given twice is claimed once. Refuses a set that is no region, and a boundary too fine for
    decimals."""
    try:
        certificate = DiscSumCertificate(P, square)
        certificate.sum(known)
        for point in dict.fromkeys(points):
            certificate.point(point)
    except NoProof as error:
        mend = error.mend or MEND
        raise Refusal(str(error), names, mend, "no-proof") from error
    return files.checked(certificate, escaped(names), True), certificate
