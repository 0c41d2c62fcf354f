"""The part of a campaign that runs on a worker: a chunk of cases, or a finding made small.

A worker keeps a process for targets (`fuzz/run`) from chunk to chunk, and runs no target's code
itself.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from minkref.errors import Refusal, message_of
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.campaign.chunks import Chunk
from minkref.fuzz.isolation.isolation import choose
from minkref.fuzz.ledgers.part import part_of
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.pool import InternalError, Pool
from minkref.fuzz.run.runner import Finding, run_asking
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.finding import SmallFinding, shrink_finding
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.version import version


@dataclass(frozen=True)
class Work:
    """States what each worker of a campaign has to know. `head`: the campaign's head. Each
    machine chooses `limits.isolation` anew, with the same `kind`."""

    campaign: str
    head: Mapping[str, Any]
    limits: Limits
    kind: str
    passed: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()

    @property
    def versions(self) -> dict[str, str | None]:
        """Returns versions by target, in order."""
        return dict(self.head["versions"])


@dataclass(frozen=True)
class Judged:
    """Holds a chunk's ordered results and its ledger part. `seconds`: work."""

    results: list[CaseResult]
    part: bytes
    seconds: float


class Held:
    """A worker's process for each of its threads, and the limits on this machine."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._threads: dict[int, tuple[str, Pool]] = {}
        self._limits: dict[str, Limits] = {}

    def limits(self, work: Work) -> Limits:
        """Returns the limits with this machine's walls. Refuses a machine with other versions."""
        with self._lock:
            if work.campaign not in self._limits:
                walls = choose(work.kind, work.passed, work.hidden)
                limits = replace(work.limits, isolation=walls)
                _refuse_others(work, limits)
                self._limits[work.campaign] = limits
            return self._limits[work.campaign]

    def pool(self, work: Work) -> Pool:
        """Returns this thread's process, which serves one campaign at a time."""
        limits, thread = self.limits(work), threading.get_ident()
        campaign, pool = self._threads.get(thread, ("", None))
        if pool is not None and campaign == work.campaign:
            return pool
        if pool is not None:
            pool.close()
        pool = Pool(list(work.versions), ALL_TARGETS, limits, 1)
        self._threads[thread] = work.campaign, pool
        return pool

    def drop(self) -> None:
        """Forgets this thread's process, after a failure."""
        _, pool = self._threads.pop(threading.get_ident(), ("", None))
        if pool is not None:
            pool.close()

    def close(self) -> None:
        """Kills all processes."""
        while self._threads:
            _, (_, pool) = self._threads.popitem()
            pool.close()
        self._limits.clear()


HELD = Held()


def judge(work: Work, chunk: Chunk) -> Judged:
    """Judges a chunk. Raises InternalError if the suite itself fails, and a Refusal on a machine
    that does not have what the campaign needs."""
    since = time.monotonic()
    results: list[CaseResult] = []
    pool = HELD.pool(work)
    try:
        done = run_asking(
            pool.results, chunk.cases, list(work.versions), {}, Baseline(), keep=results.append
        )
        if done.failed is not None:
            raise InternalError(done.failed)
    except BaseException:
        HELD.drop()
        raise
    part = part_of(f"{work.campaign}-{chunk.name}", results, work.head)
    return Judged(results, part, time.monotonic() - since)


def made_small(work: Work, finding: Finding, calls: int) -> SmallFinding | str | None:
    """Shrinks a finding: None if it does not show again, a text if our own shrinking failed."""
    try:
        return shrink_finding(finding, ALL_TARGETS, HELD.limits(work), calls)
    except Exception as error:  # noqa: BLE001 a fault of ours costs no finding
        return message_of(error).splitlines()[0]


def _refuse_others(work: Work, limits: Limits) -> None:
    """Refuses to judge with another minkref, or other versions of targets."""
    entries, _ = ALL_TARGETS.select(list(work.versions))
    named, _ = declarations_of(entries, ALL_TARGETS, limits)
    here = {entry.name: entry.version for entry in named}
    wanted = {"minkref": work.head["minkref"], **work.versions}
    for name, number in {"minkref": version(), **here}.items():
        if wanted.get(name) != number:
            what = f"a worker has {name} {number}, and the campaign {wanted.get(name)}"
            mend = "start workers with the campaign's versions, or another campaign"
            raise Refusal(what, _machine(), mend, "other-version")


def _machine() -> str:
    try:
        from distributed import get_worker

        return str(get_worker().address)
    except (ImportError, ValueError):
        return "this machine"
