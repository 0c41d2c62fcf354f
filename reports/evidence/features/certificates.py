"""Bridge certificates: both checkers verify all, changed claims only if true."""

from __future__ import annotations

import json
import random
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from minkref.fuzz.judges.disc.certified_bridges import drawn_certificate, is_true, made
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.certificates.mutants import mutants
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.3, 6)

SEED = 815
CERTIFICATES = Counts(12, 60, 1000)
MUTANTS = Counts(40, 200, 1000)
OF_ONE = 40  # mutants of one certificate, at most
CHANGED = ("claims", "square")


def run(findings: Findings, size: Size) -> None:
    wanted, counts = size.of(CERTIFICATES), Counter[str]()
    given: list[tuple[Any, Any]] = []
    number = 0
    while len(given) < wanted:
        certificate = drawn_certificate(SEED, number)
        number += 1
        if certificate is not None:
            given.append(made(certificate))
            counts.update(claim["claim"] for claim in certificate.claims)
            counts["left out"] += certificate.declined.total()
    codes = _codes(given)
    refused = [k for k, pair in enumerate(codes) if pair != (0, 0)]
    findings.none(f"of {wanted:,} certificates, not verified by both checkers", refused)
    dice = random.Random(SEED)
    changed = _changed(given, size.of(MUTANTS), dice)
    verdict = _codes(changed)
    apart = [k for k, (one, other) in enumerate(verdict) if one != other]
    findings.none(f"of {len(changed):,} changed claims, checkers of two minds", apart)
    accepted = [k for k, pair in enumerate(verdict) if 0 in pair]
    false = [k for k in accepted if not is_true(*changed[k])]
    findings.none("verified although not so", false)
    findings.note(
        f"seed {SEED}: {number:,} sets, {counts['bridge']:,} bridges, {counts['touch']:,} discs "
        f"that touch more; {counts['left out']:,} claims left out; {len(accepted):,} of "
        f"{len(changed):,} changed claims are verified: another box around the same centre"
    )
    findings.figures = {"counts": dict(counts), "verified changes": len(accepted)}


def _changed(
    given: list[tuple[Any, Any]], wanted: int, dice: random.Random
) -> list[tuple[Any, Any]]:
    found: list[tuple[Any, Any]] = []
    for certificate, case in given:
        own = [m.value for m in mutants(certificate, 1, dice) if m.path[0] in CHANGED]
        found += [(value, case) for value in dice.sample(own, min(len(own), OF_ONE))]
        if len(found) >= wanted:
            break
    return found[:wanted]


def _codes(given: list[tuple[Any, Any]]) -> list[tuple[int, int]]:
    with TemporaryDirectory() as place:
        files = []
        for number, (certificate, case) in enumerate(given):
            folder = Path(place) / str(number)
            folder.mkdir()
            (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")
            files.append(folder / "it.cert.json")
            files[-1].write_text(json.dumps(certificate), encoding="utf-8")
        python, cpp = verdicts(in_python(), files), verdicts(in_cpp(), files)
    return [(one.code, other.code) for one, other in zip(python, cpp, strict=True)]
