"""The option --certify of commands: a proof of the answer, beside it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.output.terminal import counted
from minkref.verbs.certificate_output import CHECKED, CertificateFiles, Checked, Claiming

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


def proof_document(proof: tuple[Checked, Claiming] | None) -> dict[str, Any] | None:
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
