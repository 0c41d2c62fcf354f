"""Certificates with small changes, and the ones that the checkers still accept as proofs."""

from __future__ import annotations

import itertools
import json
import random
from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.certified_cases import cases, events
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

MINUTES = Minutes(None, 1.5, 20)

SEED = 1973
LEAST = Counts(0, 200, 2000)
OF_EACH, DEGENERACIES = Counts(0, 1, 8), Counts(0, 1, 4)  # sums, and events
EACH = 2  # one certificate's mutants per field and way
TRUTHS = ("claims", "case", "certificate")  # their content must not change


def run(findings: Findings, size: Size) -> None:
    made = _certified(size.of(OF_EACH), size.of(DEGENERACIES))
    total = spoil_all(findings, _spoilt, made, size.of(LEAST), (ANOTHER_PROOF, OTHER_CLAIMS))
    findings.figures["mutants by rule and claim"] = dict(sorted(_by_kind(total.fields).items()))


def _by_kind(fields: Counter[str]) -> Counter[str]:
    kinds: Counter[str] = Counter()
    for name, count in fields.items():
        parts = name.split("/")
        kinds[parts[1] or parts[0] if len(parts) > 1 else parts[0]] += count
    return kinds


def _certified(each: int, degeneracies: int) -> list[Certified]:
    made = []
    for case in itertools.islice(filter(_has_passages, cases(SEED)), each):
        certificate = Certificate(case.P, case.Q)
        regions = case.P.is_region and case.Q.is_region
        certificate.sum(case.scale, passages=True, complete=regions)
        region = json.loads(_core.minkowski_sum(case.P, case.Q, case.scale).region.to_json())
        x, y = region["polygons"][0]["outer"][0]
        if regions:
            certificate.point(case.scale, (str(x), str(y)))
        certificate.outside(case.scale, (Fraction(x) - Fraction(1, 1000), str(y)))
        made.append((case.name.text, certificate))
    for case, scale, before in itertools.islice(events(SEED, 1), each):
        certificate = Certificate(case.P, case.Q)
        certificate.events(before, scale + (scale - before) / 3)
        made.append((f"{case.name.text} about {scale}", certificate))
        if len(made) < 2 * each + degeneracies:
            certificate = Certificate(case.P, case.Q)
            certificate.degeneracy(scale)
            made.append((f"{case.name.text}, what meets at {scale}", certificate))
    return [(name, one.case(), one.text("it.case.json")) for name, one in made]


def _has_passages(case: Case) -> bool:
    sum_ = _core.minkowski_sum(case.P, case.Q, case.scale, tight_passages=True)
    return bool(sum_.tight_passages) and case.P.vertices + case.Q.vertices < 30


def _spoilt(numbered: tuple[int, Certified]) -> Tally:
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
