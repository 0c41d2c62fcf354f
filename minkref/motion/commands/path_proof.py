"""The option --certify of `path`, `hold` and `trap`: a proof of the whole answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal
from minkref.output.terminal import counted, escaped
from minkref.verbs.certificate_output import CHECKED, CertificateFiles, Checked

OPTION = "--certify"


def proof_files(
    certify: Path | None, operands: Sequence[Path], output: Path | None = None
) -> CertificateFiles | None:
    """Refuses what cannot be written, and two files of one name."""
    if certify is None:
        return None
    files = CertificateFiles.of(certify, OPTION)
    files.refuse(operands)
    if output is not None and output.resolve() in (files.output.resolve(), files.case.resolve()):
        raise Refusal("two outputs have one name", f"-o {output}", "give -o another name")
    return files


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


def proof_document(proof: tuple[Checked, PathCertificate] | None) -> dict[str, Any] | None:
    if proof is None:
        return None
    checked, certificate = proof
    return {
        "output": str(checked.files.output),
        "case": str(checked.files.case),
        "bytes": checked.size,
        "claims": len(certificate.claims),
        "verified": checked.verified,
    }


def proof_rows(value: dict[str, Any]) -> list[tuple[str, str]]:
    """The rows about the certificate for the terminal."""
    told = value.get("certificate")  # none in space
    return [] if told is None else [("certificate", certificate_text(told))]


def certificate_text(told: dict[str, Any]) -> str:
    text = f"{told['output']}, {counted(told['claims'], 'claim')}, {told['bytes']:,} bytes"
    return f"{text}; {CHECKED[told['verified']]}"
