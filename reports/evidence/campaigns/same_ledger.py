"""One campaign by 1, 2 and 4 local workers, and by separate worker processes joined over loopback:
the same ledger but for times, the same findings; beside `minkref verify`, as fast."""

from __future__ import annotations

import resource
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from minkref.reports.evidence.campaigns.runs import (
    Cluster,
    begin,
    differences,
    ended,
    rows,
    run_campaign,
    write_campaign,
)
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.of_tests import losing_a_hole
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/seeded/",)
MINUTES = Minutes(0.2, 3, 12)
ALONE = True

SEED = 71
CASES = Counts(40, 1_000, 4_000)
WORKERS = Counts((2,), (1, 2, 4), (1, 2, 4))
RATE_CASES = Counts(0, 6_000, 30_000)  # fewer would measure the starts
FAMILIES = ["random", "holes", "comb"]
LEAST_RATE = 0.9
JOBS = 2


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory(prefix="minkref-campaigns-") as name:
        folder = Path(name)
        _same(findings, folder, size)
        if size.of(RATE_CASES):
            _as_fast(findings, folder, size)


def _same(findings: Findings, folder: Path, size: Size) -> None:
    targets = (f"py:seeded_sums:{losing_a_hole()}", "minkref:winding")
    file = write_campaign(
        folder / "campaign.toml", targets, size.of(CASES), seed=SEED, families=FAMILIES, chunk=20,
        shrink_calls=10, derived=size > Size.QUICK,
    )  # fmt: skip
    with Cluster(folder, JOBS) as cluster:
        first = run_campaign(file, folder / "cluster", "--scheduler", cluster.address)
    findings.law("kinds of findings", first["kinds"], "some", len(first["kinds"]))
    findings.figures["cases"] = first["cases"]
    findings.figures["chunks"] = first["chunks"]
    wanted = rows(folder / "cluster")
    for count in size.of(WORKERS):
        value = run_campaign(file, folder / f"local-{count}", "--workers", count)
        same = rows(folder / f"local-{count}").equals(wanted)
        findings.law(f"{count} local workers: rows of the ledger", same, "the same", same)
        findings.none(f"{count} local workers: other findings", differences(value, first))


def _as_fast(findings: Findings, folder: Path, size: Size) -> None:
    """Asks the same cases of `verify`. Both times begin before the first import; processor time
    also tells on a busy machine."""
    targets, cases = ("minkref:winding", "cgal-reduced"), size.of(RATE_CASES)
    file = write_campaign(
        folder / "rate.toml", targets, cases, seed=SEED, families=FAMILIES, derived=False, chunk=100
    )
    value, ours = _timed(lambda: ended(begin(file, folder / "rate", "--workers", JOBS)))
    words = [*targets, "--pairs", value["cases"], "--seed", SEED, "--no-derived", "--no-models"]
    words += [word for family in FAMILIES for word in ("--family", family)]
    (_, other), theirs = _timed(lambda: minkref("verify", *words, "--jobs", JOBS))
    same = sum(group["cases"] for group in other["groups"])
    findings.equal("cases of `verify`", value["cases"], same)
    for what, mine, its in zip(("time", "processor time"), ours, theirs, strict=True):
        findings.figures[f"{what}, seconds: campaign, verify"] = f"{mine:.1f}, {its:.1f}"
        findings.target(
            f"rate beside `minkref verify --jobs`, by {what}", its >= LEAST_RATE * mine,
            f"at least {LEAST_RATE}", f"{its / mine:.2f}",
        )  # fmt: skip


def _timed(work: Callable[[], Any]) -> tuple[Any, tuple[float, float]]:
    """Returns a result with seconds, and processor seconds of children."""
    before, since = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    value = work()
    seconds, after = time.monotonic() - since, resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return value, (seconds, used)
