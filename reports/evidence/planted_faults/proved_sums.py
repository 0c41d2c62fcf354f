"""Faults of the plane that the extracted program alone catches, as the target
`minkref@proved-sums` of `verify`: no other judge, law or test."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.planted_faults import faults
from minkref.reports.evidence.proved_checker.sums import is_absent

RESTS_ON = (*faults.RESTS_ON, "oracle/proved/", "bindings/")
MINUTES = Minutes(None, None, 30)  # it builds
JUDGE = "minkref@proved-sums"
PAIRS, SECONDS = Counts(0, 0, 100), 300
JOBS = 2
FEWEST = 15


def caught(fault: str, pairs: int) -> int | None:
    """Cases in which this judge sees the fault; None where the reference gives no answer."""
    found = faults.seen(fault, pairs, SECONDS, JUDGE)
    count = None if found is None else found[JUDGE]
    print(f"{fault or 'none'}: {count}", flush=True)
    return count


def run(findings: Findings, size: Size) -> None:
    if is_absent(findings):
        return
    faults.build(faults.EXTENSION)
    pairs = size.of(PAIRS)
    names = ["", *faults.listed("plane")]
    with ThreadPoolExecutor(JOBS) as pool:
        found = dict(zip(names, pool.map(lambda name: caught(name, pairs), names), strict=True))
    findings.equal("alarms without a fault", 0, found.pop(""))
    seen = [name for name, count in found.items() if count]
    ended = [name for name, count in found.items() if count is None]
    missed = [name for name, count in found.items() if count == 0]
    findings.target(
        f"faults of the plane that {JUDGE} alone catches on {pairs} pairs",
        len(seen) >= FEWEST, f"at least {FEWEST}", f"{len(seen)} of {len(found)}",
    )  # fmt: skip
    findings.figures |= {
        "caught, with the cases": ", ".join(f"{name} ({found[name]})" for name in seen),
        "runs that the reference does not end": ", ".join(ended) or "none",
        "not seen": ", ".join(missed),
    }
    others = len(faults.listed()) - len(found)
    findings.note(
        f"{others} more faults are in space and in sums with a disc, which this judge does not see"
    )
