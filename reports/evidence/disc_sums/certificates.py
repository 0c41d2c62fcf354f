"""Certificates of sums with a disc: both checkers verify all, and no false one."""

from __future__ import annotations

import json
import random
from collections import Counter
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from minkref.degeneracies.certified_disc_sums import drawn_certificate, false_certificates, made
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.4, 30)

SEED = 817
CERTIFICATES = Counts(8, 24, 1000)
SPOILT = Counts(4, 8, 400)  # certificates that are made false, in all ways
LEAST = Counts(20, 60, 5000)  # false ones
BATCH = 10
Pair = tuple[int, int]
Named = tuple[str, Pair]  # codes of both checkers


def run(findings: Findings, size: Size) -> None:
    wanted = size.of(CERTIFICATES)
    batches = [range(k, min(k + BATCH, wanted)) for k in range(0, wanted, BATCH)]
    true, false = list[Named](), list[Named]()
    for some, others in in_processes(partial(_judged, size.of(SPOILT)), batches, what="sets"):
        true += some
        false += others
    refused = [name for name, codes in true if codes != (0, 0)]
    findings.none(f"of {wanted:,} certificates, not verified by both checkers", refused)
    apart = [name for name, (one, other) in (*true, *false) if one != other]
    findings.none("checkers of two minds", apart)
    least = size.of(LEAST)
    findings.target("false certificates", len(false) >= least, f"at least {least:,}",
                    f"{len(false):,}")  # fmt: skip
    findings.none("false ones that a checker verifies", [name for name, c in false if 0 in c])
    kinds = Counter(name.split(": ")[1] for name, _ in false)
    findings.note(f"seed {SEED}: a quarter are members of families of degenerate cases, another "
                  "quarter other sets at radii of events")  # fmt: skip
    findings.figures = {"false ones by kind": dict(sorted(kinds.items()))}


def _judged(spoilt: int, numbers: range) -> tuple[list[Named], list[Named]]:
    """The verdicts on certificates, and on false ones."""
    true, false = list[tuple[str, Any, Any]](), list[tuple[str, Any, Any]]()
    for number in numbers:
        value, case = made(drawn_certificate(SEED, number))
        true.append((str(number), value, case))
        if number < spoilt:
            dice = random.Random(f"{SEED}:{number}")
            every = false_certificates(value, dice)
            false += [(f"{number}: {kind}", changed, case) for kind, changed in every]
    codes = _codes([*true, *false])
    names = [name for name, _, _ in (*true, *false)]
    named = list(zip(names, codes, strict=True))
    return named[: len(true)], named[len(true) :]


def _codes(given: list[tuple[str, Any, Any]]) -> list[Pair]:
    with TemporaryDirectory() as place:
        files = []
        for number, (_, certificate, case) in enumerate(given):
            folder = Path(place) / str(number)
            folder.mkdir()
            (folder / "case.json").write_text(json.dumps(case), encoding="utf-8")
            files.append(folder / "it.cert.json")
            files[-1].write_text(json.dumps(certificate), encoding="utf-8")
        python, cpp = verdicts(in_python(), files), verdicts(in_cpp(), files)
    return [(one.code, other.code) for one, other in zip(python, cpp, strict=True)]
