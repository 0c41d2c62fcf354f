"""Right sums that take down whatever judges them, as targets `py:spoils_judging:NAME`."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from typing import Any

from faulty_sums import Set, right
from minkref.fuzz.cases import naming
from minkref.fuzz.run import asking, worker
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


def exhausts_memory_beside_the_judge(P: Set, Q: Set) -> Set:
    """As the one above, where the judge has nothing to catch it."""

    def spoilt(case: Any, answers: Any, names: list[str], judging: Callable[[str], None]) -> Any:
        spoiling = [name for name in answers if name.startswith("py:spoils_judging")]
        if any(answers[name].region for name in spoiling):
            judging(spoiling[0])
            _no_memory()
        return _judge(case, answers, names, judging)

    asking.judge = spoilt  # type: ignore[attr-defined]
    return right(P, Q)


def leaves_no_memory_for_the_next_case(P: Set, Q: Set) -> Set:
    naming.load = lambda name: _no_memory()
    return right(P, Q)


def _no_memory() -> Any:
    raise MemoryError


_one = judgement._one
_judge = judgement.judge


def _judge_by(spoil: Callable[[], object]) -> None:
    def spoilt(case: Any, name: str, answer: Any, expected: Any) -> Any:
        if name.startswith("py:spoils_judging") and answer.region is not None:
            spoil()
        return _one(case, name, answer, expected)

    judgement._one = spoilt
