"""Faulty adapters, written from the page of the protocol alone: each is found."""

from __future__ import annotations

from typing import Any

from minkref.reports.evidence.framework.command import verify
from minkref.reports.evidence.framework.of_tests import page_adapter, page_adapters
from minkref.reports.evidence.framework.part import COMPARISON, READERS, REFERENCE, Findings

SUBJECT = (
    "Adapters with one fault each, of sums, numbers, updates, events, refusals or the protocol "
    "itself, in the plane and in space, written by somebody who had not read the judge: all are "
    "found, nine of ten within 60 s on one core."
)
MINUTES = (40, None)
DEPENDS = (*REFERENCE, *READERS, *COMPARISON, "tests/page_alone/*.py")

SECONDS, SOON = 240, 60
SHARE = 0.9
SEED = 1


def search(name: str, seconds: int) -> dict[str, Any]:
    """Whether the fault is found, by what verdict, after how many seconds."""
    words = [page_adapter(name), "--first", "--seconds", seconds, "--seed", SEED, "--jobs", 1]
    words += ["--no-models", "--shrink-calls", 40, "--call-seconds", 10, "--call-memory", 1500]
    try:
        code, value = verify(*words, seconds=seconds)
    except RuntimeError:  # shrinking is part of the command: a run that breaks down finds nothing
        return {"name": name, "found": False, "seconds": 0.0, "verdict": "the run broke down"}
    seen = [f for f in value["findings"] if f["verdict"] != "undecided"]
    return {
        "name": name,
        "found": code in (1, 3),
        "seconds": value["seconds"],
        "verdict": " ".join([seen[0]["verdict"], *(seen[0]["reasons"] or [])]) if seen else None,
    }


def run(findings: Findings, quick: bool) -> None:
    faults = page_adapters("FAULTY")
    rows = []
    for name in faults:
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
