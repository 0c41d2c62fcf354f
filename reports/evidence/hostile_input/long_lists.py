"""The cost of long lists: millions of events found, searched and written, and long sweeps."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pyarrow.parquet
from minkref.reports.evidence.framework.command import COMMAND, Cost, cost
from minkref.reports.evidence.framework.operands import operand
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 1, 3)

PAIR = ("monkey", "bird")
MOST_SECONDS = {"json": 4.0, "jsonl": 4.0, "parquet": 3.0}  # beyond finding them
MOST_SEARCH = 2.0  # the same
MOST_MIB = 160  # for writing, beyond finding; Parquet holds a row group in memory
CONDITIONS = {
    "one scale": "s = 1",
    "a box": "x in [0, 1] and y in [0, 1]",
    "one edge": "parents has S 0.12 at 0.3",
    "a change in a half-plane": "change = touch and not y >= -1/3",
    "one scale, or an edge in an interval": "s = 7/5 or (parents has T 0.5 and 1 < s <= 11/10)",
}
STEPS = (200, 5000)
MOST_SWEEP_MIB = 16  # how much more a sweep with many steps may need


def run(findings: Findings, size: Size) -> None:
    P, Q = (operand(name) for name in PAIR)
    with tempfile.TemporaryDirectory() as folder:
        _events(findings, P.name, Q.name, Path(folder))
        _arrangement(findings)
        _sweeps(findings)


def _events(findings: Findings, P: str, Q: str, folder: Path) -> None:
    found = _cost("events", P, Q, "--limit", "0", "-o", "/dev/null", "--format", "jsonl")
    table = folder / "events.parquet"
    findings.figures[f"events of {P} + {Q} found"] = _told(found)
    for form, most in MOST_SECONDS.items():
        to = [str(table)] if form == "parquet" else ["/dev/null", "--format", form]
        took = _cost("events", P, Q, "-o", *to)
        more = took.seconds - found.seconds
        title = f"processor seconds of writing {form}, beyond finding"
        findings.target(title, more <= most, most, f"{more:.2f}")
        title = f"MiB of writing {form}, beyond finding"
        findings.target(
            title, took.mib - found.mib <= MOST_MIB, MOST_MIB, f"{took.mib - found.mib:.0f}"
        )
    count = pyarrow.parquet.read_metadata(table).num_rows
    findings.figures["events in the list"] = f"{count:,}"
    for name, condition in CONDITIONS.items():
        options = ("--where", condition, "-o", "/dev/null", "--format", "jsonl")
        took = _cost("events", P, Q, *options)
        more = took.seconds - found.seconds
        title = f"processor seconds of searching for {name}, beyond finding all"
        findings.target(title, more <= MOST_SEARCH, MOST_SEARCH, f"{more:.2f}")


def _arrangement(findings: Findings) -> None:
    common = ("events", "disc1", "cells1815", "--kind", "arrangement", "--format", "jsonl")
    found = _cost(*common, "--limit", "0", "-o", "/dev/null")
    written = _cost(*common, "-o", "/dev/null")
    few = _cost(*common, "-o", "/dev/null", "--where", "kind = triple and x in [0, 1]")
    for title, took in (("found", found), ("written", written), ("searched", few)):
        findings.figures[f"arrangement events of disc1 + cells1815 {title}"] = _told(took)
    more = written.mib - found.mib
    title = "MiB of writing arrangement events, beyond finding"
    findings.target(title, more <= MOST_MIB, MOST_MIB, f"{more:.0f}")


def _sweeps(findings: Findings) -> None:
    few, many = (
        _cost("sweep", "g1", "g2", "--from", "1", "--to", "2", "--steps", str(count), "--json")
        for count in STEPS
    )
    findings.figures[f"a sweep of g1 + g2 in {STEPS[1]:,} steps"] = _told(many)
    more = many.mib - few.mib
    title = f"MiB of a sweep in {STEPS[1]:,} steps, beyond one in {STEPS[0]}"
    findings.target(title, more <= MOST_SWEEP_MIB, MOST_SWEEP_MIB, f"{more:.0f}")


def _cost(*arguments: str) -> Cost:
    return cost([*COMMAND, *arguments])


def _told(took: Cost) -> str:
    return f"{took.seconds:.2f} s of the processor, {took.mib:.0f} MiB at most"
