"""Worker processes that may die: each death is charged to the running target."""

from __future__ import annotations

import multiprocessing
import pickle
import secrets
import signal
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from typing import Any, Self

from minkref.fuzz.isolation.isolation import usual
from minkref.fuzz.run import child
from minkref.fuzz.run.case_list import Wait
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.run.worker import CASE, CaseResult, Job, work
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.targets.asking import JUDGING
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

START_SECONDS = 60.0  # until a started worker reads its job
KILLED = signal.SIGKILL.name  # by an operator, or by a machine without memory


class InternalError(Exception):
    """A fault of the suite itself, with the worker's traceback."""


class _Worker:
    def __init__(self, targets: list[str], catalogue: Catalogue, limits: Limits) -> None:
        self.limits, self.given = limits, (targets, catalogue, limits)
        context = multiprocessing.get_context("spawn")
        self.pipe: Connection
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=work, args=(theirs, *self.given), daemon=False)
        resource_tracker.ensure_running()  # unblocks SIGINT, so before
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
        try:
            self.process.start()  # deaf to Ctrl-C from its first instruction on
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        theirs.close()
        self.job: Job | None = None
        self.begin(CASE, START_SECONDS)

    def begin(self, step: str, seconds: float) -> None:
        self.step, self.seconds, self.since = step, seconds, time.monotonic()

    @property
    def remaining(self) -> float:
        return self.since + self.seconds - time.monotonic()

    def give(self, job: Job) -> None:
        self.job = job
        self.begin(CASE, START_SECONDS)
        try:
            self.pipe.send(job)
        except OSError:
            pass  # it died while it was idle, as reading from it will tell

    def end(self) -> None:
        try:
            self.pipe.send(None)
        except OSError:
            pass
        self.process.join(10)
        self.kill()

    def kill(self) -> None:
        child.end(self.process)
        self.pipe.close()


class Pool:
    """`jobs` worker processes, kept from one list of cases to the next. Leaving the context kills
    workers that `end` has not ended; `close` kills them from another thread."""

    def __init__(self, targets: list[str], catalogue: Catalogue, limits: Limits, jobs: int) -> None:
        walls = limits.isolation or usual()  # with another mark: pools end beside each other
        self._isolation = replace(walls, mark=secrets.token_hex(8))
        self._given = targets, catalogue, replace(limits, isolation=self._isolation)
        self._jobs = max(1, jobs)
        self._workers: list[_Worker] = []
        self._closed = False

    def results(self, cases: Iterable[Job | Wait]) -> Iterator[CaseResult]:
        """Yields results for all cases, in the order of completion. After Wait, the next case is
        requested only when all earlier results have been taken. Raises InternalError if the suite
        itself fails, and after `close`. Kills workers that are still busy at the end."""
        queue, workers = _Queue(iter(cases)), self._workers
        try:
            while len(workers) < self._jobs:
                workers.append(_Worker(*self._given))
            while True:
                idle = [worker for worker in workers if worker.job is None]
                for worker in idle:
                    job = queue.next(any_busy=any(worker.job for worker in workers))
                    if job is None:
                        break
                    worker.give(job)
                busy = [worker for worker in workers if worker.job]
                if not busy:
                    break
                tick = min(worker.remaining for worker in busy)
                ready = wait([worker.pipe for worker in busy], timeout=max(0.0, tick))
                for worker in busy:
                    if worker.pipe in ready:
                        result = _read(worker)
                    elif worker.remaining <= 0:
                        result = _overdue(worker)
                    else:
                        continue
                    if self._closed:
                        raise InternalError("the run was closed")
                    if result is None:
                        continue
                    if isinstance(result, CaseResult):
                        worker.job = None
                        yield result
                    else:
                        workers.append(_replaced(worker, result))
                        workers.remove(worker)
        finally:
            for worker in [worker for worker in workers if worker.job]:
                workers.remove(worker)
                worker.kill()

    def end(self) -> None:
        """Ends idle workers in order: they close their targets."""
        while self._workers:
            self._workers.pop().end()

    def close(self) -> None:
        self._closed = True
        for worker in list(self._workers):
            child.end(worker.process)
        self._isolation.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        while self._workers:
            self._workers.pop().kill()
        self._isolation.clear()


def run_cases(
    cases: Iterable[Job | Wait], targets: list[str], catalogue: Catalogue, limits: Limits, jobs: int
) -> Iterator[CaseResult]:
    """Yields a Pool's results for these cases; always ends its workers."""
    with Pool(targets, catalogue, limits, jobs) as pool:
        yield from pool.results(cases)
        pool.end()


@dataclass
class _Queue:
    jobs: Iterator[Job | Wait]
    waiting: bool = False

    def next(self, any_busy: bool) -> Job | None:
        """Returns a job, or None for now: at the end, or before results arrive."""
        while True:
            if self.waiting and any_busy:
                return None
            self.waiting = False
            job = next(self.jobs, None)
            if not isinstance(job, Wait):
                return job
            self.waiting = True


def _replaced(worker: _Worker, lost: Outcome) -> _Worker:
    """Makes a fresh worker with a lost worker's job, noting the loss against its target."""
    job = worker.job
    assert job is not None
    worker.kill()
    if lost.target in job.lost:
        raise _internal(worker, "the same step took a worker down twice")
    ours = lost.target == CASE or lost.target.startswith(JUDGING)
    again = lost.verdict is Verdict.TIMED_OUT and (ours or worker.limits.tries > 1)
    if (again or lost.signal == KILLED) and lost.target not in job.overdue:
        job.overdue.add(lost.target)  # perhaps the machine stood still: once more
    else:
        job.lost[lost.target] = lost
    fresh = _Worker(*worker.given)
    fresh.give(job)
    return fresh


def _read(worker: _Worker) -> CaseResult | Outcome | None:
    try:
        message: tuple[Any, ...] = worker.pipe.recv()
    except (EOFError, OSError, pickle.UnpicklingError):
        return _died(worker)
    if message[0] == "begin":
        worker.begin(message[1], message[2])
        return None
    if message[0] == "done":
        result: CaseResult = message[1]
        return result
    if message[0] == "no memory":
        return _without_memory(worker)
    raise InternalError(f"{message[1]}\n{message[2]}")


def _without_memory(worker: _Worker) -> Outcome:
    """The outcome of a step that needed more memory than a worker may have."""
    if worker.step.startswith(JUDGING):
        return _not_judged(worker, "there is too little memory")
    return Outcome(
        worker.step,
        Verdict.OUT_OF_MEMORY,
        message="there is too little memory",
        seconds=time.monotonic() - worker.since,
    )


def _died(worker: _Worker) -> Outcome:
    worker.process.join(5)
    child.end(worker.process)  # it may have closed its pipe and live on
    code = worker.process.exitcode or 0
    name = signal.Signals(-code).name if code < 0 else None
    how = name or f"exit code {code}"
    if name == KILLED and worker.job and worker.step not in worker.job.overdue:
        return Outcome(worker.step, Verdict.CRASHED, signal=name)  # perhaps from outside: once more
    if worker.step == CASE:
        raise _internal(worker, f"the worker process died ({how})")
    if worker.step.startswith(JUDGING):
        return _not_judged(worker, f"the process died ({how})")
    return Outcome(
        worker.step,
        Verdict.CRASHED,
        message=f"took its process down ({how})",
        signal=name,
        seconds=time.monotonic() - worker.since,
    )


def _overdue(worker: _Worker) -> Outcome:
    seconds = worker.seconds
    if worker.job and worker.step in worker.job.overdue:
        if worker.step == CASE:
            raise _internal(worker, f"no end after {seconds:g} s")
        if worker.step.startswith(JUDGING):
            return _not_judged(worker, f"there was no end after {seconds:g} s")
    return Outcome(
        worker.step, Verdict.TIMED_OUT, message=f"no answer in {seconds:g} s", seconds=seconds
    )


def _not_judged(worker: _Worker, what: str) -> Outcome:
    return Outcome(
        worker.step,
        Verdict.UNDECIDED,
        message=f"the answer could not be judged: {what}",
        seconds=time.monotonic() - worker.since,
    )


def _internal(worker: _Worker, what: str) -> InternalError:
    job = worker.job
    return InternalError(f"{job.name.text if job else '?'}: {what} in step {worker.step}")
