"""Certificates of unions with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random
from functools import partial

from minkref.degeneracies.catalogue import UNION_FAMILIES
from minkref.degeneracies.unions.case_document import DegenerateUnion
from minkref.fuzz.judges.plane.certified_unions import UnionConfirmation
from minkref.reports.evidence.certificates.mutant_tally import (
    ANOTHER_PROOF,
    OTHER_CLAIMS,
    Certified,
    Spoiling,
    Tally,
    spoil_all,
)
from minkref.reports.evidence.certificates.mutants import Mutant
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.2, 1)

SEED = 1976
LEAST = Counts(40, 500, 2000)
OF_EACH = Counts(1, 1, 8)  # members of a family
EACH = Counts(1, 4, 4)  # one certificate's mutants per field and way


def run(findings: Findings, size: Size) -> None:
    kinds = (ANOTHER_PROOF, OTHER_CLAIMS)
    spoil_all(findings, partial(_spoilt, size.of(EACH)), _certified(size), size.of(LEAST), kinds)


def _certified(size: Size) -> list[Certified]:
    families = list(UNION_FAMILIES.values())
    made = [
        DegenerateUnion.of(family, SEED, index)
        for family in (families[:2] if size is Size.QUICK else families)
        for index in range(size.of(OF_EACH))
    ]
    return [(one.id, one.certificate.case(), one.certificate.text("it.case.json")) for one in made]


def _spoilt(each: int, numbered: tuple[int, Certified]) -> Tally:
    number, (name, case, text) = numbered
    value = json.loads(text)

    def kind_of(mutant: Mutant) -> str | None:
        if mutant.path[0] in ("case", "certificate"):
            return None
        return ANOTHER_PROOF if mutant.value["claims"] == value["claims"] else OTHER_CLAIMS

    confirmation = UnionConfirmation(case)
    spoiling = Spoiling(f"{name} (seed {SEED})", case, value, each, confirmation.all_hold, kind_of)
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
