"""Worker processes that may die: each death is charged to the target that was running."""

from __future__ import annotations

import multiprocessing
import pickle
import signal
import time
from collections.abc import Iterable, Iterator
from multiprocessing.connection import Connection, wait
from typing import Any

from minkref.fuzz.cases.case import CaseName
from minkref.fuzz.run import child
from minkref.fuzz.run.worker import CaseResult, Job, work
from minkref.fuzz.targets.catalogue import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

START_SECONDS = 60.0  # for the start of a worker, and until it reads its job


class InternalError(Exception):
    """A fault of the suite itself, with the worker's traceback."""


class _Worker:
    def __init__(self, targets: list[str], limits: Limits) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe: Connection
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=work, args=(theirs, targets, limits), daemon=False)
        self.process.start()
        theirs.close()
        self.job: Job | None = None
        self.begin("minkref:case", START_SECONDS)

    def begin(self, step: str, seconds: float) -> None:
        self.step, self.seconds, self.since = step, seconds, time.monotonic()

    @property
    def remaining(self) -> float:
        return self.since + self.seconds - time.monotonic()

    def give(self, job: Job) -> None:
        self.job = job
        self.begin("minkref:case", START_SECONDS)
        self.pipe.send(job)

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


def run_cases(
    cases: Iterable[CaseName], targets: list[str], limits: Limits, jobs: int
) -> Iterator[CaseResult]:
    """The results of all cases, in the order in which they are done. Raises InternalError where the
    suite itself fails; ends its workers in every case."""
    queue = (Job(number, name) for number, name in enumerate(cases))
    workers = [_Worker(targets, limits) for _ in range(max(1, jobs))]
    try:
        busy = [worker for worker in workers if _next(worker, queue)]
        while busy:
            tick = min(worker.remaining for worker in busy)
            ready = wait([worker.pipe for worker in busy], timeout=max(0.0, tick))
            for worker in list(busy):
                if worker.pipe in ready:
                    result = _read(worker)
                elif worker.remaining <= 0:
                    result = _overdue(worker)
                else:
                    continue
                if result is None:
                    continue
                if isinstance(result, CaseResult):
                    yield result
                    worker.job = None
                    if not _next(worker, queue):
                        busy.remove(worker)
                else:
                    job = worker.job
                    assert job is not None
                    busy.remove(worker)
                    workers.remove(worker)
                    worker.kill()
                    if result.verdict is Verdict.TIMED_OUT and result.target not in job.overdue:
                        job.overdue.add(result.target)  # perhaps the machine stood still: once more
                    else:
                        job.lost[result.target] = result
                    fresh = _Worker(targets, limits)
                    workers.append(fresh)
                    busy.append(fresh)
                    fresh.give(job)
        for worker in workers:
            worker.end()
        workers.clear()
    finally:
        for worker in workers:
            worker.kill()


def _next(worker: _Worker, queue: Iterator[Job]) -> bool:
    job = next(queue, None)
    if job is None:
        return False
    worker.give(job)
    return True


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
    raise InternalError(f"{message[1]}\n{message[2]}")


def _died(worker: _Worker) -> Outcome:
    worker.process.join(5)
    child.end(worker.process)  # it may have closed its pipe and live on
    code = worker.process.exitcode or 0
    name = signal.Signals(-code).name if code < 0 else None
    how = name or f"exit code {code}"
    _own_step(worker, f"the worker process died ({how})")
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
        _own_step(worker, f"no end after {seconds:g} s")
    return Outcome(
        worker.step, Verdict.TIMED_OUT, message=f"no answer in {seconds:g} s", seconds=seconds
    )


def _own_step(worker: _Worker, what: str) -> None:
    if worker.step in ("minkref:case", "minkref:referee"):
        job = worker.job
        raise InternalError(f"{job.name.text if job else '?'}: {what} in step {worker.step}")
