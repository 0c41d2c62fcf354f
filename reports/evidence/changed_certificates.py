"""Certificates with small changes: which of them the checkers still take for proofs."""

from __future__ import annotations

import itertools
import json
import random
from collections import Counter

from minkref import _core
from minkref.certify.certificate import Certificate
from minkref.fuzz.judges.certified_claims import Confirmation
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.certified_cases import cases, events
from minkref.reports.evidence.certificates.mutant_tally import (
    ANOTHER_PROOF,
    OTHER_CLAIMS,
    Spoiling,
    Tally,
)
from minkref.reports.evidence.certificates.mutants import Mutant
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
TRUTHS = ("claims", "case", "certificate")  # nothing that they say may change


def run(findings: Findings, quick: bool) -> None:
    total, certified = Tally(), _certified()
    for tally in in_processes(_spoilt, list(enumerate(certified)), what="certificates"):
        total.add(tally)
    total.tell(findings, len(certified), LEAST, (ANOTHER_PROOF, OTHER_CLAIMS))
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

    def kind_of(mutant: Mutant) -> str | None:
        if mutant.path[0] not in TRUTHS:
            return ANOTHER_PROOF
        return None if mutant.value["claims"] == value["claims"] else OTHER_CLAIMS

    confirmation = Confirmation(case)
    told = f"{name} (seed {SEED})"
    spoiling = Spoiling(told, case, value, EACH, confirmation.all_hold, kind_of)
    return spoiling.tally(random.Random(f"{SEED}:{number}"))
