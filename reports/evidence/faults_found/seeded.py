"""Seeded faults in a small implementation: how many `minkref verify` finds in a minute each."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any

from minkref.reports.evidence.framework.command import first_found, verify
from minkref.reports.evidence.framework.of_tests import SEEDED, seeded_adapter, seeded_faults
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/seeded/",)
MINUTES = Minutes(0.1, 1.2, 30)

SECONDS = Counts(4, 12, 60)
EVERY = Counts(60, 12, 1)  # one fault of so many
SEED = 40
# Faults that may stay unseen, and why.
HARD = {
    "filters_holes_by_circumference": "needs a part with a long rim in a hole with a short one",
    "at_most_50_sums": "only large operands, where what is lost is often covered",
    "holds_sixteen_pieces": "only large operands, where what is lost is often covered",
    "nearly_convex_is_convex": "needs a dent of at most a hundredth of the hull",
    "touches_at_vertices_only": "needs one rare layout of touching rings",
    "hole_corners_inside_out": "needs one rare layout of touching rings",
}


def target_of(name: str) -> str:
    """A fault about the scale shows through the adapter alone."""
    in_scale = seeded_faults()[name].needs_scale
    return seeded_adapter(name) if in_scale else f"py:seeded_sums:{name}"


def search(name: str, seconds: int) -> dict[str, Any]:
    """Whether minkref finds the fault, after how many cases and seconds, and the shrunk case."""
    words = ("--seed", SEED, "--shrink-calls", 80, "--call-seconds", 10)
    found, value = first_found(target_of(name), seconds, *words, path=SEEDED)
    shrunk = value["shrunk"][0] if value["shrunk"] else None
    return {
        "name": name,
        "found": found,
        "cases": sum(group["cases"] for group in value["groups"]),
        "seconds": value["seconds"],
        "verdict": value["findings"][0]["verdict"] if value["findings"] else None,
        "shrunk": shrunk["reproduce"] if shrunk else None,
    }


def run(findings: Findings, size: Size) -> None:
    names = sorted(seeded_faults())
    names = names[:: size.of(EVERY)]
    seconds = size.of(SECONDS)
    sound = search_sound(seconds)
    findings.none("findings against the sound implementation", sound)
    with ThreadPoolExecutor(2) as both:
        rows = list(both.map(lambda name: search(name, seconds), names))
    found = [row for row in rows if row["found"]]
    findings.figures["faults"] = len(rows)
    findings.figures["found"] = len(found)
    findings.figures["found as wrong"] = sum(row["verdict"] == "wrong" for row in found)
    if found:
        times = sorted(row["seconds"] for row in found)
        findings.figures["seconds until found, shrinking included: median, largest"] = (
            f"{times[len(times) // 2]:.1f}, {times[-1]:.1f}"
        )
    missed = [row["name"] for row in rows if row not in found]
    for name in missed:
        about = HARD.get(name, seeded_faults()[name].about)
        findings.note(f"not found: {name}: {about}")
    unexplained = [name for name in missed if name not in HARD]
    findings.target("faults found, or the reason why not", not unexplained, 0, len(unexplained))


def search_sound(seconds: int) -> int:
    words = ("py:seeded_sums:sound", "--seconds", seconds, "--seed", SEED, "--no-models")
    _, value = verify(*words, "--shrink-calls", "0", seconds=seconds, path=SEEDED)
    return len(value["findings"])
