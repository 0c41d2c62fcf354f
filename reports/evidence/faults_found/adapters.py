"""Faulty adapters, written from the protocol's page alone: each must be found."""

from __future__ import annotations

from typing import Any

from minkref.reports.evidence.framework.command import first_found
from minkref.reports.evidence.framework.of_tests import page_adapter, page_adapters
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/page_alone/",)
MINUTES = Minutes(None, 1.2, 40)

SECONDS, SOON = 240, 60
SHARE = 0.9
SEED = 1
EVERY = Counts(0, 12, 1)  # one fault of so many


def search(name: str, seconds: int) -> dict[str, Any]:
    """Whether minkref finds the fault, with the verdict and the seconds taken."""
    words = ("--seed", SEED, "--shrink-calls", 40, "--call-seconds", 10, "--call-memory", 1500)
    try:
        found, value = first_found(page_adapter(name), seconds, *words)
    except RuntimeError:  # a run that breaks down while shrinking finds nothing
        return {"name": name, "found": False, "seconds": 0.0, "verdict": "the run broke down"}
    seen = [f for f in value["findings"] if f["verdict"] != "undecided"]
    return {
        "name": name,
        "found": found,
        "seconds": value["seconds"],
        "verdict": " ".join([seen[0]["verdict"], *(seen[0]["reasons"] or [])]) if seen else None,
    }


def run(findings: Findings, size: Size) -> None:
    faults = page_adapters("FAULTY")
    rows = []
    for name in list(faults)[:: size.of(EVERY)]:
        rows.append(search(name, SECONDS))
        print(rows[-1], flush=True)
    for row in rows:
        about = (
            f"{row['seconds']:.0f} s, {row['verdict']}"
            if row["found"]
            else f"not found, {row['verdict']}"
        )
        findings.figures[row["name"]] = f"{about}: {faults[row['name']].__doc__}"
    missed = [row["name"] for row in rows if not row["found"]]
    soon = sum(row["found"] and row["seconds"] <= SOON for row in rows)
    findings.figures["faults"] = len(rows)
    findings.none("faults not found", missed)
    findings.target("share found within 60 s", soon >= SHARE * len(rows), SHARE, soon / len(rows))
