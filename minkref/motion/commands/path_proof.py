"""The option --certify of `path`, `hold` and `trap`: a proof of the whole answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal
from minkref.output.terminal import escaped
from minkref.verbs.certificate_output import CertificateFiles, Checked


def proved(
    files: CertificateFiles | None,
    names: tuple[str, str],
    sets: tuple[_core.PolygonSet, _core.PolygonSet],
    path: Sequence[Sequence[str]],
    claim: Callable[[PathCertificate], int],
) -> tuple[Checked, PathCertificate] | None:
    """The proof of a claim, checked and not written yet; None where none was asked for."""
    if files is None:
        return None
    certificate = PathCertificate(*sets, path)
    title = f"{escaped(names[0])} among {escaped(names[1])}"
    try:
        claim(certificate)
    except NoProof as error:
        mend = "leave out --certify, or give a window in which it can be proven (--from, --to)"
        raise Refusal(str(error), title, error.mend or mend, "no-proof") from error
    return files.checked(certificate, title, True), certificate
