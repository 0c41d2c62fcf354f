"""Certificates with small changes: which of them the checkers still take for proofs."""

from __future__ import annotations

import itertools
import json
import random
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.certificate import Certificate
from minkref.fuzz.judges.certified_claims import Confirmation
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.certified_cases import cases, events
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import Mutant, mutants
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import CERTIFY, READERS, REFERENCE, Findings

SUBJECT = (
    "Certificates of sums, tight passages, events, degeneracies and points, each field of each "
    "rule and claim changed in each way that fits, and the case: both checkers on each mutant; "
    "what they still verify, put before the slow engine and computer algebra."
)
MINUTES = (10, None)
DEPENDS = (
    *REFERENCE, *READERS, *CERTIFY, "fuzz/families/*.py", "fuzz/judges/certified_claims.py",
    "oracle/slow/*.py",
)  # fmt: skip

SEED = 1973
LEAST = 2000
SUMS, EVENTS, DEGENERACIES = 8, 8, 4
EACH = 2  # mutants of a field and a way, of one certificate
BATCH = 100
TRUTHS = ("claims", "case", "certificate")  # nothing that they say may change


@dataclass
class Tally:
    whole: int = 0  # unchanged, verified and confirmed
    mutants: int = 0
    refused: Counter[str] = field(default_factory=Counter)  # by verdict
    fields: Counter[str] = field(default_factory=Counter)
    other_proofs: int = 0  # changed witnesses: the same claims, verified and confirmed
    other_truths: int = 0  # changed claims that are true as well, verified and confirmed
    false: list[str] = field(default_factory=list)  # verified, and not confirmed
    disagreements: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)


def run(findings: Findings, quick: bool) -> None:
    total, certified = Tally(), _certified()
    for tally in in_processes(_spoilt, list(enumerate(certified)), what="certificates"):
        total.add(tally)
    words = {1: "refuted", 2: "malformed", 4: "out of budget"}
    findings.target("mutants", total.mutants >= LEAST, f"at least {LEAST:,}", f"{total.mutants:,}")
    findings.none("mutants on which the checkers disagree", total.disagreements)
    findings.none("mutants that are verified and not confirmed", total.false)
    findings.equal(
        "unchanged certificates that are verified and confirmed", len(certified), total.whole
    )
    findings.figures["refused"] = {words[int(code)]: n for code, n in sorted(total.refused.items())}
    findings.figures["verified: the same claims by another proof, each confirmed"] = (
        total.other_proofs
    )
    findings.figures["verified: other claims, true as well, each confirmed"] = total.other_truths
    findings.figures["fields that were changed"] = len(total.fields)
    findings.figures["mutants by rule and claim"] = dict(sorted(_by_kind(total.fields).items()))


def _by_kind(fields: Counter[str]) -> Counter[str]:
    kinds: Counter[str] = Counter()
    for name, count in fields.items():
        parts = name.split("/")
        kinds[parts[1] or parts[0] if len(parts) > 1 else parts[0]] += count
    return kinds


def _certified() -> list[tuple[str, str, str]]:
    """Names, cases, certificates."""
    made = []
    for case in itertools.islice(filter(_has_passages, cases(SEED)), SUMS):
        certificate = Certificate(case.P, case.Q)
        certificate.sum(case.scale, passages=True)
        region = json.loads(_core.minkowski_sum(case.P, case.Q, case.scale).region.to_json())
        x, y = region["polygons"][0]["outer"][0]
        if case.P.is_region and case.Q.is_region:
            certificate.point(case.scale, (str(x), str(y)))
        made.append((case.name.text, certificate))
    for case, scale, before in itertools.islice(events(SEED, 1), EVENTS):
        certificate = Certificate(case.P, case.Q)
        certificate.event(scale, before)
        made.append((f"{case.name.text} at {scale}", certificate))
        if len(made) < SUMS + EVENTS + DEGENERACIES:
            certificate = Certificate(case.P, case.Q)
            certificate.degeneracy(scale)
            made.append((f"{case.name.text}, what meets at {scale}", certificate))
    return [(name, each.case(), each.text("it.case.json")) for name, each in made]


def _has_passages(case: Case) -> bool:
    sum_ = _core.minkowski_sum(case.P, case.Q, case.scale, tight_passages=True)
    return bool(sum_.tight_passages) and case.P.vertices + case.Q.vertices < 30


def _spoilt(numbered: tuple[int, tuple[str, str, str]]) -> Tally:
    number, (name, case, text) = numbered
    value = json.loads(text)
    dice = random.Random(f"{SEED}:{number}")
    confirmation, tally = Confirmation(case), Tally()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "it.case.json").write_text(case, encoding="utf-8")
        whole = Mutant("nothing", "unchanged", (), value)
        for batch in _batches([whole, *mutants(value, EACH, dice)]):
            files = [_write(Path(folder), i, mutant.value) for i, mutant in enumerate(batch)]
            ours, theirs = verdicts(in_python(), files), verdicts(in_cpp(), files)
            for mutant, first, second in zip(batch, ours, theirs, strict=True):
                told = f"{name} (seed {SEED}): {mutant.way} at {mutant.path}"
                if first.code != second.code:
                    tally.disagreements.append(f"{told}: {first.code}, {second.code}")
                _count(tally, told, mutant, first.code, value, confirmation)
    return tally


def _count(
    tally: Tally, told: str, mutant: Mutant, code: int, value: Any, confirmation: Confirmation
) -> None:
    true = not code and confirmation.all_hold(mutant.value["claims"])
    if not mutant.path:
        tally.whole += true
        return
    tally.mutants += 1
    tally.fields[mutant.field] += 1
    if code:
        tally.refused[str(code)] += 1
    elif not true or (mutant.path[0] in TRUTHS and mutant.value["claims"] == value["claims"]):
        tally.false.append(told)
    elif mutant.path[0] in TRUTHS:
        tally.other_truths += 1
    else:
        tally.other_proofs += 1


def _batches(all_: list[Mutant]) -> list[list[Mutant]]:
    return [all_[i : i + BATCH] for i in range(0, len(all_), BATCH)]


def _write(folder: Path, number: int, value: Any) -> Path:
    path = folder / f"{number}.cert.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    return path
