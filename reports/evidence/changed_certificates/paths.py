"""Certificates of paths and traps with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random
from functools import partial

from minkref.certify.motion.path_certificate import PathCertificate
from minkref.degeneracies.catalogue import PATH_FAMILIES
from minkref.degeneracies.motion.case_document import DegeneratePath
from minkref.fuzz.judges.motion.certified_paths import PathConfirmation
from minkref.fuzz.judges.motion.trap_cases import trap_case
from minkref.fuzz.motion.path_cases import path_case
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

MINUTES = Minutes(0.1, 0.5, 2)

SEED = 1975
LEAST = Counts(20, 1000, 4000)
RANDOM = Counts(0, 2, 6)  # random paths, beside a member of each family
DOORS = Counts(1, 2, 6)  # traps with doors just shut: exits move with the scale
EACH = Counts(1, 4, 4)  # one certificate's mutants per field and way


def run(findings: Findings, size: Size) -> None:
    kinds = (ANOTHER_PROOF, OTHER_CLAIMS)
    spoil_all(findings, partial(_spoilt, size.of(EACH)), _certified(size), size.of(LEAST), kinds)


def _certified(size: Size) -> list[Certified]:
    families = list(PATH_FAMILIES.values())
    made: list[tuple[str, PathCertificate]] = []
    for family in families[:1] if size is Size.QUICK else families:
        one = DegeneratePath.of(family, SEED, 0)
        made.append((one.id, one.certificate))
    for index in range(size.of(RANDOM)):
        case = path_case(SEED, index)
        certificate = PathCertificate(case.part, case.obstacles, case.path)
        certificate.valid("forbidden")
        made.append((case.name, certificate))
    for index in range(size.of(DOORS)):
        door = trap_case(SEED, index)
        certificate = PathCertificate(door.part, door.obstacles, [door.at])
        certificate.trap("forbidden")
        made.append((door.name, certificate))
    return [(name, one.case(), one.text("it.case.json")) for name, one in made]


def _spoilt(each: int, numbered: tuple[int, Certified]) -> Tally:
    number, (name, case, text) = numbered
    value = json.loads(text)

    def kind_of(mutant: Mutant) -> str | None:
        if mutant.path[0] in ("case", "certificate"):
            return None
        return ANOTHER_PROOF if mutant.value["claims"] == value["claims"] else OTHER_CLAIMS

    confirmation = PathConfirmation(case)
    told = f"{name} (seed {SEED})"
    spoiling = Spoiling(told, case, value, each, confirmation.all_hold, kind_of)
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
