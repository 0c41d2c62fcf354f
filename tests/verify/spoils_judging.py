"""Right sums that take down whatever judges them, as targets `py:spoils_judging:NAME`."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from typing import Any

from faulty_sums import Set, right
from minkref.fuzz.run import worker
from minkref.fuzz.verdicts import judgement

worker.JUDGING_SECONDS = 1.0


def dies(P: Set, Q: Set) -> Set:
    _judge_by(lambda: os.kill(os.getpid(), signal.SIGSEGV))
    return right(P, Q)


def takes_for_ever(P: Set, Q: Set) -> Set:
    _judge_by(lambda: time.sleep(60))
    return right(P, Q)


def exhausts_memory(P: Set, Q: Set) -> Set:
    _judge_by(_no_memory)
    return right(P, Q)


def _no_memory() -> None:
    raise MemoryError


_one = judgement._one


def _judge_by(spoil: Callable[[], object]) -> None:
    def spoilt(case: Any, name: str, answer: Any, expected: Any) -> Any:
        if name.startswith("py:spoils_judging") and answer.region is not None:
            spoil()
        return _one(case, name, answer, expected)

    judgement._one = spoilt
