"""Kills workers, scheduler or client by signal 9 at drawn moments: no reported result is lost, and
findings equal an undisturbed campaign's."""

from __future__ import annotations

import random
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from pathlib import Path

from minkref.reports.evidence.campaigns.runs import (
    Cluster,
    begin,
    differences,
    ended,
    kill,
    rows,
    run_campaign,
    wait_for_parts,
    write_campaign,
)
from minkref.reports.evidence.framework.of_tests import losing_a_hole
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("tests/adapters/seeded/",)
MINUTES = Minutes(0.3, 2, 12)

SEED = 72
CAMPAIGNS = Counts(1, 6, 20)
CASES = Counts(60, 150, 150)
WORKERS = 2
KILLED = ("client", "worker", "scheduler")
LONGEST = 1.0  # seconds after a drawn part


def run(findings: Findings, size: Size) -> None:
    dice = random.Random(SEED)
    lost: list[str] = []
    other: list[str] = []
    killed: Counter[str] = Counter()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="minkref-killed-")))
        file = write_campaign(
            folder / "campaign.toml",
            (f"py:seeded_sums:{losing_a_hole()}", "minkref:winding"),
            size.of(CASES),
            seed=SEED,
            families=["random", "holes", "comb"],
            derived=False,
            chunk=15,
            shrink_calls=6,
        )
        whole = run_campaign(file, folder / "whole", "--workers", WORKERS)
        findings.law("kinds of findings", whole["kinds"], "some", len(whole["kinds"]))
        findings.figures["chunks"], wanted = whole["chunks"], rows(folder / "whole")
        cluster = stack.enter_context(Cluster(folder, WORKERS))
        for number in range(size.of(CAMPAIGNS)):
            who = KILLED[number % len(KILLED)]
            ledger = folder / str(number)
            moment = dice.randint(0, whole["chunks"] - 2), dice.uniform(0, LONGEST)
            start = partial(begin, file, ledger, "--scheduler", cluster.address)
            process = start()
            before = wait_for_parts(ledger, moment[0], process)
            time.sleep(moment[1])
            killed[who] += process.poll() is None
            process = _kill(who, dice, cluster, process, start)
            value = ended(process)
            after = wait_for_parts(ledger, 0, process)
            if any(after.get(part) != data for part, data in before.items()):
                lost.append(f"{number}, {who}")
            differing = differences(value, whole)
            if not rows(ledger).equals(wanted):
                differing.append("rows of the ledger")
            other += [f"{number}, {who}: {each}" for each in differing]
            print(
                f"{number}: {who}, {len(before)} parts before: {differing or 'the same'}",
                flush=True,
            )
    findings.figures["killed before the end"] = dict(killed)
    findings.law("killed before the end", bool(killed.total()), "some", killed.total())
    findings.none("campaigns that lost a part", lost)
    findings.none("campaigns with another ledger or other findings", other)


def _kill(
    who: str,
    dice: random.Random,
    cluster: Cluster,
    process: subprocess.Popen[str],
    again: Callable[[], subprocess.Popen[str]],
) -> subprocess.Popen[str]:
    """Kills and replaces. Returns the client that ends the campaign."""
    if who == "client":
        kill(process)
        process.communicate()
        return again()
    if who == "worker":
        cluster.replace_worker(dice.randrange(len(cluster.workers)))
    else:
        cluster.replace_scheduler()
    return process
