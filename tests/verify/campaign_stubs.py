"""A client of Dask without processes: finishes tasks in any order, and lets some fail."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from typing import Any

from minkref.fuzz.campaign.chunks import Chunk
from minkref.fuzz.campaign.judging import Judged, Work, judge
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.ledgers.part import part_of
from minkref.fuzz.run.case_list import Wait
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness


class Death(BaseException):
    """The client's process is killed."""


class Future:
    def __init__(self, key: str, status: str, value: Any) -> None:
        self.key, self.status, self._value = key, status, value

    def result(self) -> Any:
        return self._value

    def exception(self) -> Any:
        return self._value

    def release(self) -> None:
        pass

    def add_done_callback(self, tell: Callable[[Any], None]) -> None:
        self.tell = tell


class Client:
    """Has `workers` threads. Each look at them finishes a few tasks, drawn by `dice`. `fails` and
    `dies`: probabilities, for a task and a look."""

    def __init__(
        self, dice: random.Random, workers: int, fails: float = 0.0, dies: float = 0.0
    ) -> None:
        self._dice, self._workers, self._fails, self._dies = dice, workers, fails, dies
        self._open: list[Future] = []
        self.judged: list[str] = []

    def nthreads(self) -> dict[str, int]:
        return {"a": self._workers}

    def submit(self, function: Any, work: Work, *arguments: Any, key: str, **_: Any) -> Future:
        if function is not judge:
            return self._finished(Future(key, "finished", None))
        (chunk,) = arguments
        self.judged.append(chunk.name)
        if self._dice.random() < self._fails:
            return self._finished(Future(key, "error", RuntimeError("a worker fell")))
        return self._finished(Future(key, "finished", judged(work, chunk)))

    def _finished(self, future: Future) -> Future:
        self._open.append(future)
        return future

    def finish_some(self) -> None:
        if self._dice.random() < self._dies:
            raise Death
        for _ in range(self._dice.randint(1, max(1, len(self._open)))):
            if self._open:
                future = self._open.pop(self._dice.randrange(len(self._open)))
                future.tell(future)


def names(chunk: Chunk) -> Sequence[CaseName]:
    return [name for name in chunk.cases if not isinstance(name, Wait)]


def judged(work: Work, chunk: Chunk) -> Judged:
    """Makes results of the chunk's names alone: of two targets one is now and then wrong."""
    results = []
    for number, name in enumerate(names(chunk)):
        dice = random.Random(name.text)
        wrong = dice.random() < 0.2
        right = Outcome("right", Verdict.PASS, seconds=random.random())
        other = Outcome("other", Verdict.PASS, seconds=random.random())
        if wrong:
            reason = dice.choice((Reason.MISSING, Reason.EXTRA, Reason.HOLE_LOST))
            witness = Witness((str(number), "1"), True, ("0", "0"), (str(number), "1"))
            other = Outcome("other", Verdict.WRONG, (reason,), witness=witness)
        result = CaseResult(number, name, "1", [right, other], "P", "Q", (7, 1, ""))
        result.coverage = f"shape {dice.randrange(40)}"
        if wrong:
            result.P = result.Q = '{"polygons":[]}'
            result.literal = '{"P":{"polygons":[]},"Q":{"polygons":[]},"scale":"1"}'
        results.append(result)
    part = part_of(f"{work.campaign}-{chunk.name}", results, work.head)
    return Judged(results, part, 1.0)
