"""The option --certify of `features`: a proof of the bridges at one alpha."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.certify.disc.bridge_certificate import BridgeCertificate
from minkref.errors import Refusal
from minkref.output.terminal import counted, escaped
from minkref.plane.operand import Operand
from minkref.verbs.certificate_output import CertificateFiles, Checked


@dataclass(frozen=True)
class ProvedBridges:
    """`warnings`: bridges without a claim."""

    proof: tuple[Checked, BridgeCertificate]
    warnings: list[str]


def proved_bridges(
    files: CertificateFiles, operand: Operand, radius: Fraction, found: _core.Features
) -> ProvedBridges:
    """The proof, checked and not written yet. Refuses a radius at which nothing can be claimed."""
    certificate = BridgeCertificate(operand.set, radius)
    certificate.bridges(found)
    certificate.touches()
    title = escaped(operand.name)
    declined = [
        f"{counted(count, 'claim')} left out: {why}"
        for why, count in sorted(certificate.declined.items())
    ]
    if not certificate.claims:
        what = "; ".join(declined) or "there is no bridge at this alpha"
        raise Refusal(what, title, "leave out --certify, or give another --alpha A", "no-proof")
    return ProvedBridges((files.checked(certificate, title, True), certificate), declined)
