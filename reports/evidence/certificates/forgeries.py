"""Certificates forged from the pages alone, with a stranger to all checkers: true ones within
raw form, changed so that figures, digests and derivations agree with a lie. No checker may
accept one."""

from __future__ import annotations

import random
import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from minkref.reports.evidence.certificates.checkers import in_proved
from minkref.reports.evidence.certificates.forged import raw, solids_raw
from minkref.reports.evidence.certificates.forged.ideas import FALSE, IDEAS
from minkref.reports.evidence.certificates.forged.trying import (
    Trial,
    by_command,
    checkers,
    made,
    tried_together,
    truths,
)
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(None, 0.5, 6)

SEED = 7117
FORGERIES = Counts(150, 300, 3000)
ROUNDS = Counts(1, 1, 3)
BATCH = 30
LEAST = 60  # ideas
SOME = ("ell hull gap plate tight topology inside apart path trap seam ringdisc bays convex "
         "solid beside").split()  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    proved = is_built()
    if not proved:
        findings.note("the proved checker is not built here: it was not asked")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "raw").mkdir()
        solids_raw.write(folder / "raw")
        names = () if size is Size.FULL else SOME
        asked = raw.orders(random.Random(SEED), size.of(ROUNDS), names)
        raws = raw.made(folder / "raw", asked)
        findings.equal("true certificates to begin with", len(asked), len(raws))
        findings.none("true certificates that a checker refuses", truths(folder / "raw", raws))
        trials = made(folder, raws, size.of(FORGERIES), SEED)
        batches = [trials[first : first + BATCH] for first in range(0, len(trials), BATCH)]
        tasks = [(batch, proved) for batch in batches]
        told = [t for batch in in_processes(judged, tasks, what="batches") for t in batch]
    tell(findings, told, size)


def is_built() -> bool:
    try:
        return bool(in_proved())
    except FileNotFoundError:
        return False


def judged(task: tuple[Sequence[Trial], bool]) -> Sequence[Trial]:
    """The batch with each checker's codes; faults of the commands with the first of them."""
    batch, proved = task
    tried_together(batch, checkers(proved))
    for options in ((), ("--proved",))[: 1 + proved]:
        for wrong in by_command(batch, *options):
            batch[0].faults.append(f"minkref check {' '.join(options)}: {wrong}")
    return batch


def tell(findings: Findings, trials: Sequence[Trial], size: Size) -> None:
    findings.equal("forgeries", size.of(FORGERIES), len(trials))
    ideas = Counter(trial.idea for trial in trials)
    findings.target("ideas", len(ideas) >= LEAST, f"at least {LEAST}", len(ideas))
    faults = [f"{t.name}: {fault}" for t in trials for fault in t.faults]
    findings.none("forgeries that a checker accepts, or on which it breaks down", faults)
    ours = ("check.py", "minkref-check")
    apart = [f"{t.name}: {t.codes}" for t in trials
             if len({t.codes.get(name) for name in ours} - {4}) > 1]  # fmt: skip
    findings.none("forgeries that are malformed to one checker and refuted to another", apart)
    third = sum(len(set(t.codes.values()) - {4, 5}) > 1 for t in trials)
    findings.figures["where the proved checker tells another of several faults"] = third
    kinds = {kept.name: kept.kind for kept in IDEAS}
    false = sum(kinds[trial.idea] == FALSE for trial in trials)
    findings.figures["a claim is false; true or open, and a rule is broken"] = (
        f"{false:,}; {len(trials) - false:,}"
    )
    findings.figures["forgeries of each form"] = dict(Counter(t.form for t in trials))
    codes = Counter(f"{name}: {code}" for t in trials for name, code in t.codes.items())
    findings.figures["exit codes"] = dict(sorted(codes.items()))
    slow = max(trials, key=lambda trial: trial.slowest)
    findings.figures["slowest, seconds"] = f"{slow.slowest:.1f}, {slow.idea}"
