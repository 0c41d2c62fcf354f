"""Puts features on trial: right targets are never accused, seeded faults found."""

from __future__ import annotations

from minkref.reports.evidence.framework.command import counts_of, first_found, told, verify
from minkref.reports.evidence.framework.of_tests import VERIFY, features_adapter, module
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("fuzz/adapters/", "fuzz/libraries/")
MINUTES = Minutes(None, 0.4, 12)

SEED = 12
SECONDS = Counts(3, 8, 300)
FAULTS = Counts(2, 4, 18)
LONGEST = 60  # seconds until a seeded fault shows
TARGETS = ("minkref:index", "features-triples", "features-cgal", "features-boost")
NO_FAULT = ("gave-up", "timed-out")  # too many bits for Boost; the judge by triples is slow
FAMILIES = ("--family", "features", "--family", "features-grid")


def run(findings: Findings, size: Size) -> None:
    seconds = size.of(SECONDS)
    words = (*FAMILIES, "--no-models", "--jobs", 2, "--seed", SEED, "--shrink-calls", 0)
    _, value = verify(*TARGETS, *words, "--seconds", seconds, seconds=seconds)
    for name in TARGETS:
        findings.figures[name] = told(counts_of(value, name))
    accused = [row["reproduce"] for row in value["findings"] if row["verdict"] not in NO_FAULT]
    findings.none("findings against right targets, or against our referee", accused)
    names = list(module("features_adapter", VERIFY).FAULTS)[: size.of(FAULTS)]
    missed = [
        name
        for name in names
        if not first_found(features_adapter(name), LONGEST, "--family", "features")[0]
    ]
    findings.none(f"of {len(names)} seeded faults, not found in {LONGEST} s", missed)
