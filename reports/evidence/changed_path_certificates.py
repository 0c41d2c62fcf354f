"""Certificates of paths and traps with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.certify.path_certificate import PathCertificate
from minkref.degeneracies.catalogue import PATH_FAMILIES
from minkref.degeneracies.paths.case_document import DegeneratePath
from minkref.fuzz.judges.certified_paths import PathConfirmation
from minkref.fuzz.judges.path_cases import path_case
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import Mutant, mutants
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
MINUTES = (1, 0.1)
DEPENDS = (*REFERENCE, *READERS, *COMPARISON, *CERTIFY, *DEGENERACIES)

SEED = 1975
LEAST, QUICK_LEAST = 4000, 100
RANDOM = 6  # random paths, beside a member of each family
EACH = 4  # mutants of a field and a way, of one certificate
BATCH = 100


@dataclass
class Tally:
    whole: int = 0  # unchanged, verified and confirmed
    mutants: int = 0
    refused: Counter[str] = field(default_factory=Counter)  # by verdict
    fields: Counter[str] = field(default_factory=Counter)
    other_proofs: int = 0  # verified: the same claims by another proof
    other_truths: int = 0  # verified: other claims, true as well
    false: list[str] = field(default_factory=list)  # verified, and not confirmed
    disagreements: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)


def run(findings: Findings, quick: bool) -> None:
    total, certificates = Tally(), _certified(quick)
    for tally in in_processes(_spoilt, list(enumerate(certificates)), what="certificates"):
        total.add(tally)
    least = QUICK_LEAST if quick else LEAST
    words = {1: "refuted", 2: "malformed", 4: "out of budget"}
    findings.target("mutants", total.mutants >= least, f"at least {least:,}", f"{total.mutants:,}")
    findings.none("mutants on which the checkers disagree", total.disagreements)
    findings.none("mutants that are verified and not confirmed", total.false)
    findings.equal(
        "unchanged certificates that are verified and confirmed", len(certificates), total.whole
    )
    findings.figures["refused"] = {words[int(code)]: n for code, n in sorted(total.refused.items())}
    findings.figures["verified: the same claims by another proof, each confirmed"] = (
        total.other_proofs
    )
    findings.figures["verified: other claims, true as well, each confirmed"] = total.other_truths
    findings.figures["fields that were changed"] = len(total.fields)


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
    return [(name, one.case(), one.text("it.case.json")) for name, one in made]


def _spoilt(numbered: tuple[int, tuple[str, str, str]]) -> Tally:
    number, (name, case, text) = numbered
    value = json.loads(text)
    dice = random.Random(f"{SEED}:{number}")
    confirmation, tally = PathConfirmation(case), Tally()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "it.case.json").write_text(case, encoding="utf-8")
        whole = Mutant("nothing", "unchanged", (), value)
        every = [whole, *mutants(value, EACH, dice)]
        for first in range(0, len(every), BATCH):
            batch = every[first : first + BATCH]
            files = [_write(Path(folder), i, mutant.value) for i, mutant in enumerate(batch)]
            ours, theirs = verdicts(in_python(), files), verdicts(in_cpp(), files)
            for mutant, one, other in zip(batch, ours, theirs, strict=True):
                told = f"{name} (seed {SEED}): {mutant.way} at {mutant.path}"
                if one.code != other.code:
                    tally.disagreements.append(f"{told}: {one.code}, {other.code}")
                _count(tally, told, mutant, one.code, value, confirmation)
    return tally


def _count(
    tally: Tally, told: str, mutant: Mutant, code: int, value: Any, confirmation: PathConfirmation
) -> None:
    true = not code and confirmation.all_hold(mutant.value["claims"])
    if not mutant.path:
        tally.whole += true
        return
    tally.mutants += 1
    tally.fields[mutant.field] += 1
    if code:
        tally.refused[str(code)] += 1
    elif not true or mutant.path[0] in ("case", "certificate"):
        tally.false.append(told)
    elif mutant.value["claims"] == value["claims"]:
        tally.other_proofs += 1
    else:
        tally.other_truths += 1


def _write(folder: Path, number: int, value: Any) -> Path:
    path = folder / f"{number}.cert.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    return path
