"""Certificates of sums of solids with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random

from minkref.fuzz.judges.certified_solids import SolidConfirmation
from minkref.reports.evidence.certificates.mutant_tally import ANOTHER_PROOF, Spoiling, Tally
from minkref.reports.evidence.certificates.solid_cases import certified, solid_pairs
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import CERTIFY, COMPARISON, REFERENCE, Findings

SUBJECT = (
    "Certificates of sums of polyhedra of any shape, each field of pieces, planes, entries and "
    "claims changed in each way that fits: both checkers on each mutant; what they still verify, "
    "put before the slow engine."
)
MINUTES = (8, 0.8)
DEPENDS = (*REFERENCE, *COMPARISON, *CERTIFY, "fuzz/judges/certified_solids.py", "oracle/slow/*.py")

SEED = 1974
LEAST, QUICK_LEAST = 4000, 400
CERTIFICATES, QUICK_CERTIFICATES = 13, 2
MOST_BYTES = 6000  # of a certificate that is changed
EACH = 8  # mutants of a field and a way, of one certificate
REWRITTEN = "the same claims, otherwise written, each confirmed"


def run(findings: Findings, quick: bool) -> None:
    total, certificates = Tally(), _certified(QUICK_CERTIFICATES if quick else CERTIFICATES)
    for tally in in_processes(_spoilt, list(enumerate(certificates)), what="certificates"):
        total.add(tally)
    least = QUICK_LEAST if quick else LEAST
    total.tell(findings, len(certificates), least, (ANOTHER_PROOF, REWRITTEN))
    findings.figures["mutants by field"] = dict(sorted(total.fields.items()))


def _certified(count: int) -> list[tuple[str, str, str]]:
    """Names, cases, certificates."""
    made = []
    for pair in solid_pairs(SEED):
        certificate = certified(pair)
        text = certificate.text("it.case.json")
        if len(text) <= MOST_BYTES:
            made.append((pair.name, certificate.case(), text))
        if len(made) == count:
            break
    return made


def _spoilt(numbered: tuple[int, tuple[str, str, str]]) -> Tally:
    number, (name, case, text) = numbered
    confirmation = SolidConfirmation(json.loads(case))
    spoiling = Spoiling(
        f"{name} (seed {SEED})", case, json.loads(text), EACH, confirmation.all_hold,
        lambda mutant: ANOTHER_PROOF if mutant.path[0] == "proof" else REWRITTEN,
    )  # fmt: skip
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
