"""Certificates of paths and traps with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random

from minkref.certify.path_certificate import PathCertificate
from minkref.degeneracies.catalogue import PATH_FAMILIES
from minkref.degeneracies.paths.case_document import DegeneratePath
from minkref.fuzz.judges.certified_paths import PathConfirmation
from minkref.fuzz.judges.path_cases import path_case
from minkref.fuzz.judges.trap_cases import trap_case
from minkref.reports.evidence.certificates.mutant_tally import (
    ANOTHER_PROOF,
    OTHER_CLAIMS,
    Spoiling,
    Tally,
)
from minkref.reports.evidence.certificates.mutants import Mutant
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import (
    CERTIFY,
    COMPARISON,
    DEGENERACIES,
    READERS,
    REFERENCE,
    Findings,
)

SUBJECT = (
    "Certificates of paths and traps, each field of pieces, codes, hits, ways, rings and claims "
    "changed in each way that fits: both checkers on each mutant; what they still verify, held "
    "against the valid scales and traps of the reference at all scales."
)
MINUTES = (2, 0.2)
DEPENDS = (*REFERENCE, *READERS, *COMPARISON, *CERTIFY, *DEGENERACIES)

SEED = 1975
LEAST, QUICK_LEAST = 4000, 100
RANDOM = 6  # random paths, beside a member of each family
DOORS = 6  # traps whose doors just shut: ways out that move with the scale
EACH = 4  # mutants of a field and a way, of one certificate


def run(findings: Findings, quick: bool) -> None:
    total, certificates = Tally(), _certified(quick)
    for tally in in_processes(_spoilt, list(enumerate(certificates)), what="certificates"):
        total.add(tally)
    least = QUICK_LEAST if quick else LEAST
    total.tell(findings, len(certificates), least, (ANOTHER_PROOF, OTHER_CLAIMS))


def _certified(quick: bool) -> list[tuple[str, str, str]]:
    """Names, cases, certificates."""
    families = list(PATH_FAMILIES.values())
    made: list[tuple[str, PathCertificate]] = []
    for family in families[:1] if quick else families:
        one = DegeneratePath.of(family, SEED, 0)
        made.append((one.id, one.certificate))
    for index in range(0 if quick else RANDOM):
        case = path_case(SEED, index)
        certificate = PathCertificate(case.part, case.obstacles, case.path)
        certificate.valid("forbidden")
        made.append((case.name, certificate))
    for index in range(1 if quick else DOORS):
        door = trap_case(SEED, index)
        certificate = PathCertificate(door.part, door.assembly, [door.at])
        certificate.trap("forbidden")
        made.append((door.name, certificate))
    return [(name, one.case(), one.text("it.case.json")) for name, one in made]


def _spoilt(numbered: tuple[int, tuple[str, str, str]]) -> Tally:
    number, (name, case, text) = numbered
    value = json.loads(text)

    def kind_of(mutant: Mutant) -> str | None:
        if mutant.path[0] in ("case", "certificate"):
            return None
        return ANOTHER_PROOF if mutant.value["claims"] == value["claims"] else OTHER_CLAIMS

    confirmation = PathConfirmation(case)
    told = f"{name} (seed {SEED})"
    spoiling = Spoiling(told, case, value, EACH, confirmation.all_hold, kind_of)
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
