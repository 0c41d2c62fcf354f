"""A campaign over all settings: our routes against each other, CGAL's sound methods and the
judges, without a false alarm."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.reports.evidence.campaigns.runs import run_campaign, write_campaign
from minkref.reports.evidence.framework.command import counts_of, told
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("fuzz/libraries/minkref/",)
MINUTES = Minutes(0.1, 2, 30)
ALONE = True

SEED = 73
SECONDS = Counts(3.0, 90.0, 1_700.0)
WORKERS = 2
SETTINGS = ["plane", "disc", "space", "motion", "scene"]
SOUND = (
    "cgal-triangulation", "cgal-vertical", "cgal-nef", "cgal-hull", "cgal-join", "features-triples",
    "features-cgal",
)  # fmt: skip
JUDGES = "minkref"  # all of them: too slow for a quick run
MILLION = 10**6


def run(findings: Findings, size: Size) -> None:
    entries = [entry for entry in ALL_TARGETS.entries() if entry.available]
    wanted = SOUND if size is Size.QUICK else (*SOUND, JUDGES)
    names = [e.name for e in entries if e.name.startswith("minkref:") or e.name in wanted]
    with tempfile.TemporaryDirectory(prefix="minkref-alarms-") as name:
        folder = Path(name)
        file = write_campaign(
            folder / "self.toml", names, MILLION, seed=SEED, settings=SETTINGS, chunk=60
        )
        since = time.monotonic()
        words = ("--workers", WORKERS, "--seconds", size.of(SECONDS))
        value = run_campaign(file, folder / "self", *words)
        rate = value["cases_here"] / (time.monotonic() - since)
    findings.law("cases", value["cases"] > 0, "some", f"{value['cases']:,}")
    findings.none(
        "findings", [f"{k['first']['reproduce']} {k['first']['verdict']}" for k in value["kinds"]]
    )
    findings.none("chunks without a result", list(value["failed"].values()))
    findings.figures["cases a second"] = round(rate, 1)
    findings.figures["hours for a million cases here"] = round(MILLION / rate / 3600, 1)
    findings.figures["families"] = len(value["families"])
    findings.figures["behaviours"] = value["behaviours"]
    for target in value["targets"]:
        counts = counts_of(value, target["name"])
        findings.figures[f"{target['name']} {target['version'] or ''}".strip()] = told(counts)
