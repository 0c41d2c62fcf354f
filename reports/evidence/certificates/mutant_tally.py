"""Verdicts of the checkers on a certificate's mutants: refused, or verified, and then confirmed."""

from __future__ import annotations

import json
import random
import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import Mutant, mutants
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Findings

ANOTHER_PROOF = "the same claims by another proof, each confirmed"
OTHER_CLAIMS = "other claims, true as well, each confirmed"
BATCH = 100
Certified = tuple[str, str, str]  # name, case, certificate
WORDS = {1: "refuted", 2: "malformed", 4: "out of budget"}


@dataclass
class Tally:
    whole: int = 0  # unchanged, verified and confirmed
    mutants: int = 0
    refused: Counter[str] = field(default_factory=Counter)  # by verdict
    fields: Counter[str] = field(default_factory=Counter)
    verified: Counter[str] = field(default_factory=Counter)  # and confirmed, by kind
    false: list[str] = field(default_factory=list)  # verified, and not confirmed
    disagreements: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)

    def tell(self, findings: Findings, certificates: int, least: int, kinds: Sequence[str]) -> None:
        """`certificates`: how many were changed; `kinds`: what a verified mutant may be."""
        findings.target("mutants", self.mutants >= least, f"at least {least:,}",
                        f"{self.mutants:,}")  # fmt: skip
        findings.none("mutants on which the checkers disagree", self.disagreements)
        findings.none("mutants that are verified and not confirmed", self.false)
        findings.equal(
            "unchanged certificates that are verified and confirmed", certificates, self.whole
        )
        refused = sorted(self.refused.items())
        findings.figures["refused"] = {WORDS[int(code)]: count for code, count in refused}
        for kind in kinds:
            findings.figures[f"verified: {kind}"] = self.verified[kind]
        findings.figures["fields that were changed"] = len(self.fields)


def spoil_all(
    findings: Findings, spoilt: Callable[[tuple[int, Certified]], Tally],
    certificates: list[Certified], least: int, kinds: tuple[str, ...],
) -> Tally:  # fmt: skip
    """Judges all mutants of all certificates, and records the findings."""
    total = Tally()
    for tally in in_processes(spoilt, list(enumerate(certificates)), what="certificates"):
        total.add(tally)
    total.tell(findings, len(certificates), least, kinds)
    return total


@dataclass
class Spoiling:
    """A certificate, and how to judge its mutants. `confirms` tells whether claims hold, without
    the checkers; `kind_of` gives the kind of a verified and confirmed mutant, or None if checkers
    should still have refused the mutant."""

    name: str
    case: str
    value: Any
    each: int  # mutants for each field and way
    confirms: Callable[[Any], bool]
    kind_of: Callable[[Mutant], str | None]

    def tally(self, dice: random.Random) -> Tally:
        found = Tally()
        every = [Mutant("nothing", "unchanged", (), self.value)]
        every += mutants(self.value, self.each, dice)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "it.case.json").write_text(self.case, encoding="utf-8")
            for first in range(0, len(every), BATCH):
                self._judge(every[first : first + BATCH], Path(folder), found)
        return found

    def _judge(self, batch: Sequence[Mutant], folder: Path, found: Tally) -> None:
        files = [folder / f"{number}.cert.json" for number in range(len(batch))]
        for file, mutant in zip(files, batch, strict=True):
            file.write_text(json.dumps(mutant.value), encoding="utf-8")
        ours, theirs = verdicts(in_python(), files), verdicts(in_cpp(), files)
        for mutant, one, other in zip(batch, ours, theirs, strict=True):
            told = f"{self.name}: {mutant.way} at {mutant.path}"
            if one.code != other.code:
                found.disagreements.append(f"{told}: {one.code}, {other.code}")
            self._count(found, told, mutant, one.code)

    def _count(self, found: Tally, told: str, mutant: Mutant, code: int) -> None:
        is_true = not code and self.confirms(mutant.value["claims"])
        if not mutant.path:
            found.whole += is_true
            return
        found.mutants += 1
        found.fields[mutant.field] += 1
        if code:
            found.refused[str(code)] += 1
            return
        kind = self.kind_of(mutant) if is_true else None
        if kind is None:
            found.false.append(told)
        else:
            found.verified[kind] += 1
