"""Workers whose judge takes them down at an answer of `py:faulty_sums:right`; each replaces
`pool.work`."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from typing import Any

from minkref.fuzz.plane import asking, judgement
from minkref.fuzz.run import naming, worker

SPOILT = "py:faulty_sums:right"


def dies(*given: Any) -> None:
    _judge_by(lambda: os.kill(os.getpid(), signal.SIGSEGV))
    worker.work(*given)


def takes_for_ever(*given: Any) -> None:
    worker.JUDGING_SECONDS = 1.0
    _judge_by(lambda: time.sleep(60))
    worker.work(*given)


def exhausts_memory(*given: Any) -> None:
    _judge_by(_no_memory)
    worker.work(*given)


def exhausts_memory_beside_the_judge(*given: Any) -> None:
    """Runs out of memory outside the judge, which cannot catch this."""

    def spoilt(case: Any, answers: Any, names: list[str], judging: Callable[[str], None]) -> Any:
        if SPOILT in answers and answers[SPOILT].region:
            judging(SPOILT)
            _no_memory()
        return _judge(case, answers, names, judging)

    asking.judge = spoilt  # type: ignore[attr-defined]
    worker.work(*given)


def has_no_memory_for_the_second_case(*given: Any) -> None:
    load = naming.load

    def spoilt(name: Any) -> Any:
        return load(name) if name.text.endswith(":0") else _no_memory()

    naming.load = spoilt
    worker.work(*given)


def _no_memory() -> Any:
    raise MemoryError


_one = judgement._one
_judge = judgement.judge


def _judge_by(spoil: Callable[[], object]) -> None:
    def spoilt(case: Any, name: str, answer: Any, expected: Any) -> Any:
        if name == SPOILT and answer.region is not None:
            spoil()
        return _one(case, name, answer, expected)

    judgement._one = spoilt
