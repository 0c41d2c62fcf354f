"""Puts certificates before the checker that shares nothing with their producer."""

from __future__ import annotations

from minkref.oracle.checker import check as checker
from minkref.output.documents import scratch_folder
from minkref.verbs.check import WORDS

LIMITS = 600.0, 1e10, 2.0**30  # of seconds, of tests, of bytes


class Refuted(RuntimeError):
    """The checker does not take the certificate for a proof: a fault of minkref."""


def is_verified(certificate: str, case: str, name: str) -> bool:
    """Whether the checker in Python (oracle/checker) verifies a certificate; False where its budget
    does not suffice. `name`: of the operands, for messages. Raises Refuted where it is no proof.
    Costs about what making it did."""
    with scratch_folder() as folder:
        path, beside = folder / "it.cert.json", folder / "it.case.json"
        path.write_text(certificate, encoding="utf-8")
        beside.write_text(case, encoding="utf-8")
        code, why, _ = checker.verdict(path, beside, LIMITS, checker.FILES)
    if WORDS[code] in ("verified", "out of budget"):
        return WORDS[code] == "verified"
    raise Refuted(
        f"minkref made a certificate of {name} that is no proof, and has not written it: {why}"
    )
