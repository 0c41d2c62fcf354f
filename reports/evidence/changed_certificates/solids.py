"""Certificates for sums of solids with small changes, and the ones that the checkers still accept
as proofs."""

from __future__ import annotations

import json
import random
from functools import partial

from minkref.fuzz.judges.space.certified_solids import SolidConfirmation
from minkref.reports.evidence.certificates.mutant_tally import (
    ANOTHER_PROOF,
    Certified,
    Spoiling,
    Tally,
    spoil_all,
)
from minkref.reports.evidence.certificates.solid_cases import certified, solid_pairs
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.6, 8)

SEED = 1974
LEAST = Counts(20, 800, 4000)
CERTIFICATES = Counts(1, 3, 13)
MOST_BYTES = 6000  # the largest certificate to change
EACH = Counts(1, 4, 8)  # one certificate's mutants per field and way
REWRITTEN = "the same claims, otherwise written, each confirmed"


def run(findings: Findings, size: Size) -> None:
    made, kinds = _certified(size.of(CERTIFICATES)), (ANOTHER_PROOF, REWRITTEN)
    total = spoil_all(findings, partial(_spoilt, size.of(EACH)), made, size.of(LEAST), kinds)
    findings.figures["mutants by field"] = dict(sorted(total.fields.items()))


def _certified(count: int) -> list[Certified]:
    made = []
    for pair in solid_pairs(SEED):
        certificate = certified(pair)
        text = certificate.text("it.case.json")
        if len(text) <= MOST_BYTES:
            made.append((pair.name, certificate.case(), text))
        if len(made) == count:
            break
    return made


def _spoilt(each: int, numbered: tuple[int, Certified]) -> Tally:
    number, (name, case, text) = numbered
    confirmation = SolidConfirmation(json.loads(case))
    spoiling = Spoiling(
        f"{name} (seed {SEED})", case, json.loads(text), each, confirmation.all_hold,
        lambda mutant: ANOTHER_PROOF if mutant.path[0] == "proof" else REWRITTEN,
    )  # fmt: skip
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
