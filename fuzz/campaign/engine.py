"""The client's loop: chunks and shrinking as tasks of Dask, results into the ledger and the tally.

Nothing but this process writes the folder: a chunk's part first, the tally later. A death at any
moment costs the chunks in flight; parts that no state counts yet are counted from the ledger.
"""

from __future__ import annotations

import queue
import time
import uuid
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from minkref.errors import Refusal, message_of
from minkref.fuzz.campaign.chunks import Chunk, Plan
from minkref.fuzz.campaign.judging import Judged, Work, judge, made_small
from minkref.fuzz.campaign.tally import Kind, Tally, wanting
from minkref.fuzz.ledgers.counting import results_in
from minkref.fuzz.ledgers.part import store_part
from minkref.fuzz.ledgers.place import chunks_in
from minkref.fuzz.shrink.groups import bounds

TRIES = 2  # of a chunk that fails, or takes its workers down
AHEAD = 2  # chunks for each thread: one in work, one waiting
TICK = 0.5  # seconds
STATE_SECONDS = 5.0  # between two writings of the state
TEND_SECONDS = 60.0
KEPT = 200  # chunks whose results wait in memory for their turn; others wait in the ledger


class SchedulerLost(Exception):
    """The scheduler went away."""


class Shows(Protocol):
    """Gets told of progress."""

    def show(self, drive: Drive) -> None: ...


@dataclass
class Goal:
    """Tells where a run ends: after chunks with `cases` planned cases, or `seconds` of all runs.
    `share` (k, n): only chunks k, k + n, ..."""

    cases: int | None = None
    seconds: float | None = None
    share: tuple[int, int] = (0, 1)
    shrink_calls: int = 0


@dataclass
class Task:
    """A task in flight: a chunk, or a kind to shrink."""

    future: Any
    chunk: Chunk | None = None
    kind: Kind | None = None


@dataclass
class Drive:
    """A run of a campaign. `failed`: chunks without a result, with the reason."""

    folder: Path
    plan: Plan
    work: Work
    tally: Tally
    goal: Goal
    tend: Callable[[], None] = lambda: None
    failed: dict[str, str] = field(default_factory=dict)
    workers: int = 0
    here: int = 0  # cases judged by this run
    work_seconds: float = 0.0  # of all workers
    _tries: dict[int, int] = field(default_factory=dict)
    _tasks: dict[str, Task] = field(default_factory=dict)
    _ready: dict[int, list[Any] | None] = field(default_factory=dict)
    _order: list[int] = field(default_factory=list)
    _next: int = 0

    def __post_init__(self) -> None:
        self._run = uuid.uuid4().hex[:8]
        self._began = time.monotonic()
        self._before = self.tally.spent
        self._wrote = self._tended = self._began
        self._cost = 0.0
        self._wanted = self._numbers()
        self._done = {
            name.removeprefix(f"{self.work.campaign}-")
            for name in chunks_in(self.folder, self.work.campaign)
        }
        self._again: list[Chunk] = []
        self._kinds = wanting(self.tally.kinds.values())

    @property
    def seconds(self) -> float:
        """Returns the time of this run."""
        return time.monotonic() - self._began

    @property
    def chunks_done(self) -> int:
        return len(self._done)

    @property
    def is_out_of_time(self) -> bool:
        return self.goal.seconds is not None and self._before + self.seconds >= self.goal.seconds

    def run(self, client: Any, shows: Shows) -> None:
        """Works with one connection to a scheduler until the goal is reached. Raises SchedulerLost;
        may be called again with another connection."""
        finished: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._tasks.clear()
        looked = 0.0
        try:
            while True:
                if time.monotonic() - looked > TICK:
                    self.workers, looked = self._threads(client), time.monotonic()
                self._fill(client, finished)
                self._advance()
                if not self._tasks:
                    if self._kinds:
                        continue  # chunks from the ledger showed them
                    break
                try:
                    key = finished.get(timeout=TICK)
                except queue.Empty:
                    key = None
                if key in self._tasks:
                    self._take(self._tasks.pop(key))
                self._look_after()
                shows.show(self)
            self._advance()
        finally:
            for task in self._tasks.values():
                task.future.release()
            self.close()

    def close(self) -> None:
        """Writes the state."""
        self.tally.spent = self._before + self.seconds
        self.tally.write()

    def _numbers(self) -> Iterator[int]:
        """Yields the chunks of this run, done or not."""
        k, n = self.goal.share
        for number in self.plan.numbers(self.goal.cases):
            if number % n == k:
                yield number

    def _threads(self, client: Any) -> int:
        try:
            return sum(client.nthreads().values())
        except (OSError, TimeoutError, ValueError, AttributeError) as error:
            raise SchedulerLost(message_of(error)) from error

    def _fill(self, client: Any, finished: queue.SimpleQueue[Any]) -> None:
        """Hands out work, as much as the workers take."""
        while self._kinds:
            kind = self._kinds.pop()
            calls, _ = bounds(kind.first.outcome, self.goal.shrink_calls)
            if calls > 0:
                self._submit(client, finished, Task(None, kind=kind), made_small, kind.first, calls)
        chunks = sum(task.chunk is not None for task in self._tasks.values())
        while chunks < AHEAD * max(1, self.workers):
            chunk = self._again.pop(0) if self._again else self._next_chunk()
            if chunk is None:
                return
            self._submit(client, finished, Task(None, chunk), judge, chunk)
            chunks += 1

    def _next_chunk(self) -> Chunk | None:
        """Returns a chunk to be judged; chunks in the ledger only have to be counted."""
        while not self.is_out_of_time:
            number = next(self._wanted, None)
            if number is None:
                return None
            if number in self.tally.taken:
                continue
            chunk = self.plan.chunk(number)
            self._order.append(number)
            if chunk.name not in self._done:
                return chunk
            self._ready[number] = None  # in the ledger
            if len(self._ready) % 100 == 0:
                self._advance()
        return None

    def _submit(
        self,
        client: Any,
        finished: queue.SimpleQueue[Any],
        task: Task,
        function: Callable[..., Any],
        *arguments: Any,
    ) -> None:
        name = task.chunk.name if task.chunk else "shrink"
        self._next += 1
        key = f"{name}-{self.work.campaign}-{self._run}-{self._next}"
        priority = 0 if task.chunk else 10
        task.future = client.submit(
            function, self.work, *arguments, key=key, pure=False, priority=priority
        )
        self._tasks[key] = task
        task.future.add_done_callback(lambda future: finished.put(future.key))

    def _take(self, task: Task) -> None:
        """Takes a finished task's result, or hands the task out again."""
        status = task.future.status
        if status == "finished":
            try:
                value = task.future.result()
            except (OSError, TimeoutError) as error:
                raise SchedulerLost(message_of(error)) from error
            task.future.release()
            if task.chunk is not None:
                self._keep(task.chunk, value)
            elif task.kind is not None:
                self.tally.keep_small(task.kind, value)
        elif status == "error":
            fault = task.future.exception()
            if isinstance(fault, Refusal):
                raise fault
            self._failed(task, message_of(fault))
        else:
            self._return(task)
            raise SchedulerLost(status)

    def _keep(self, chunk: Chunk, judged: Judged) -> None:
        store_part(self.folder, f"{self.work.campaign}-{chunk.name}", judged.part)
        self._done.add(chunk.name)
        self._ready[chunk.number] = judged.results if len(self._ready) < KEPT else None
        self.here += sum(result.is_run for result in judged.results)
        self.work_seconds += judged.seconds

    def _return(self, task: Task) -> None:
        if task.chunk is not None:
            self._again.append(task.chunk)
        elif task.kind is not None:
            self._kinds.append(task.kind)

    def _failed(self, task: Task, why: str) -> None:
        """Tries a chunk again, a few times."""
        if task.chunk is None:
            if task.kind is not None:
                self.tally.keep_small(task.kind, why.splitlines()[0])
            return
        number = task.chunk.number
        self._tries[number] = self._tries.get(number, 0) + 1
        if self._tries[number] < TRIES:
            self._again.append(task.chunk)
        else:
            self.failed[task.chunk.name] = why
            self._order.remove(number)

    def _advance(self) -> None:
        """Counts chunks in order, up to the first missing chunk."""
        count = 0
        for number in self._order:
            if number not in self._ready:
                break
            results = self._ready.pop(number)
            if results is None:
                name = f"{self.work.campaign}-{self.plan.chunk(number).name}"
                results = results_in(self.folder, name)
            self._kinds += wanting(self.tally.add(number, results))
            count += 1
        del self._order[:count]

    def _look_after(self) -> None:
        """Writes the state now and then, a twentieth of the time at most, and has the folder
        tended."""
        now = time.monotonic()
        if now - self._wrote > max(STATE_SECONDS, 20 * self._cost):
            self.close()
            self._wrote = time.monotonic()
            self._cost = self._wrote - now
        if now - self._tended > TEND_SECONDS:
            self.tend()
            self._tended = time.monotonic()

    def return_all(self) -> None:
        """Hands everything in flight out again, to another scheduler."""
        for task in self._tasks.values():
            self._return(task)
        self._tasks.clear()
