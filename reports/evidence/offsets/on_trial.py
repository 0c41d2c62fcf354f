"""Offsets on trial: our routes, seeded faults, and libraries with the tolerances that they
document."""

from __future__ import annotations

import os
from statistics import median

from minkref.fuzz.judges.disc.offset_findings import confirmed
from minkref.fuzz.libraries import catalogue
from minkref.fuzz.offsets.question import OFFSETS
from minkref.reports.evidence.framework.command import counts_of, first_found, told, verify
from minkref.reports.evidence.framework.of_tests import VERIFY, module, offset_adapter
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("fuzz/adapters/", "fuzz/libraries/")
MINUTES = Minutes(0.2, 0.6, 20)

SEED = 11
SECONDS = Counts(3, 12, 300)
FAULTS = Counts(1, 1, 30)
LONGEST = 60  # seconds until a seeded fault shows
MEDIAN = 10.0
OURS = ("minkref:definition", "minkref:paper", "minkref:index", "minkref-paper@rational,corrected")
LIBRARIES = (
    "geos-buffer", "clipper2-inflate", "cgal-offset", "boost-geometry-buffer", "manifold3d-offset",
    "openscad-offset", "pyclipper-inflate", "pyclipr-inflate", "clipper-lib-inflate",
    "clipper2-ts-inflate", "jsts-buffer", "jts-buffer", "i-overlay-outline", "cavalier-contours",
)  # fmt: skip
FAMILIES = [word for family in OFFSETS.families for word in ("--family", family)]


def run(findings: Findings, size: Size) -> None:
    seconds = size.of(SECONDS)
    words = (*FAMILIES, "--no-models", "--jobs", 2, "--seed", SEED, "--shrink-calls", 0)
    _, value = verify(*OURS, *words, "--seconds", seconds, seconds=seconds)
    for name in OURS:
        findings.figures[name] = told(counts_of(value, name))
    findings.none("findings against our routes", [row["reproduce"] for row in value["findings"]])
    _seeded(findings, size.of(FAULTS))
    there = [name for name in LIBRARIES if catalogue.absence(name) is None]
    for name in LIBRARIES:
        if name not in there:
            findings.note(f"{name} is absent")
    if not there:
        return
    _, value = verify(*there, *words, "--seconds", seconds, seconds=seconds)
    for target in value["targets"]:
        findings.figures[f"{target['name']} {target['version']}"] = told(
            counts_of(value, target["name"])
        )
    wrong = [
        row
        for row in value["findings"]
        if row["verdict"] == "wrong" and row["P"]["set"] and "manner" not in row["witness"]
    ]  # with joins a second program has checked the witness already
    refuted = [row["reproduce"] for row in wrong if not confirmed(row)]
    findings.none(f"of {len(wrong)} witnesses, refuted by distances in fractions", refuted)
    ours = [row["reproduce"] for row in value["findings"] if row["target"].startswith("minkref:")]
    findings.none("findings against our referee", ours)


def _seeded(findings: Findings, most: int) -> None:
    """Each fault of a small implementation, searched alone on one core."""
    names = list(module("offset_adapter", VERIFY).FAULTS)[:most]
    taken, missed = [], []
    for name in names:
        began = _spent()
        found, _ = first_found(offset_adapter(name), LONGEST, "--family", "offsets")
        taken.append(_spent() - began)
        missed += [] if found else [name]
    findings.none(f"of {len(names)} seeded faults, not found in {LONGEST} s", missed)
    middle = median(taken)
    findings.target(
        "median seconds of computing until one shows", middle < MEDIAN, MEDIAN, f"{middle:.1f}"
    )


def _spent() -> float:
    """Seconds of computing by all children so far, whatever else the machine does."""
    times = os.times()
    return times.children_user + times.children_system
