"""Certificates of sums of solids with small changes: which the checkers still take for proofs."""

from __future__ import annotations

import json
import random
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.fuzz.judges.certified_solids import SolidConfirmation
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import Mutant, mutants
from minkref.reports.evidence.certificates.solid_cases import certified, solid_pairs
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import CERTIFY, COMPARISON, REFERENCE, Findings

SUBJECT = (
    "Certificates of sums of polyhedra of any shape, each field of pieces, planes, entries and "
    "claims changed in each way that fits: both checkers on each mutant; what they still verify, "
    "put before the slow engine."
)
MINUTES = (8, 1)
DEPENDS = (*REFERENCE, *COMPARISON, *CERTIFY, "fuzz/judges/certified_solids.py", "oracle/slow/*.py")

SEED = 1974
LEAST, QUICK_LEAST = 4000, 400
CERTIFICATES, QUICK_CERTIFICATES = 13, 2
MOST_BYTES = 6000  # of a certificate that is changed
EACH = 8  # mutants of a field and a way, of one certificate
BATCH = 100


@dataclass
class Tally:
    whole: int = 0  # unchanged, verified and confirmed
    mutants: int = 0
    refused: Counter[str] = field(default_factory=Counter)  # by verdict
    fields: Counter[str] = field(default_factory=Counter)
    other_proofs: int = 0  # verified: the same claims by another proof
    rewritten: int = 0  # verified: the same claims, otherwise written
    false: list[str] = field(default_factory=list)  # verified, and not confirmed
    disagreements: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)


def run(findings: Findings, quick: bool) -> None:
    total, certificates = Tally(), _certified(QUICK_CERTIFICATES if quick else CERTIFICATES)
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
    findings.figures["verified: the same claims by another proof"] = total.other_proofs
    findings.figures["verified: the same claims, otherwise written"] = total.rewritten
    findings.figures["fields that were changed"] = len(total.fields)
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
    value = json.loads(text)
    dice = random.Random(f"{SEED}:{number}")
    confirmation, tally = SolidConfirmation(json.loads(case)), Tally()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "it.case.json").write_text(case, encoding="utf-8")
        all_ = [Mutant("nothing", "unchanged", (), value), *mutants(value, EACH, dice)]
        for batch in (all_[i : i + BATCH] for i in range(0, len(all_), BATCH)):
            files = [_write(Path(folder), i, mutant.value) for i, mutant in enumerate(batch)]
            ours, theirs = verdicts(in_python(), files), verdicts(in_cpp(), files)
            for mutant, first, second in zip(batch, ours, theirs, strict=True):
                told = f"{name} (seed {SEED}): {mutant.way} at {mutant.path}"
                if first.code != second.code:
                    tally.disagreements.append(f"{told}: {first.code}, {second.code}")
                _count(tally, told, mutant, first.code, confirmation)
    return tally


def _count(
    tally: Tally, told: str, mutant: Mutant, code: int, confirmation: SolidConfirmation
) -> None:
    true = not code and confirmation.all_hold(mutant.value["claims"])
    if not mutant.path:
        tally.whole += true
        return
    tally.mutants += 1
    tally.fields[mutant.field] += 1
    if code:
        tally.refused[str(code)] += 1
    elif not true:
        tally.false.append(told)
    elif mutant.path[0] == "proof":
        tally.other_proofs += 1
    else:
        tally.rewritten += 1


def _write(folder: Path, number: int, value: Any) -> Path:
    path = folder / f"{number}.cert.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    return path
