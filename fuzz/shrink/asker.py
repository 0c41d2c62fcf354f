"""Whether a smaller case still shows the fault of a target, tried in a worker process."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Self

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.run.pool import run_cases
from minkref.fuzz.run.worker import CaseResult, Job
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome


class Asker:
    """Asks one target about one case after another, in a process that may die."""

    def __init__(self, target: str, catalogue: Catalogue, limits: Limits) -> None:
        self.target = target
        self._next: Job | None = None
        self._number = 0
        self._results = run_cases(self._jobs(), [target], catalogue, limits, 1)

    def _jobs(self) -> Iterator[Job]:
        while self._next is not None:
            job, self._next = self._next, None
            yield job

    def ask(self, text: str) -> tuple[CaseResult, Outcome | None]:
        """Returns the case's result, and the target's outcome."""
        self._next = Job(self._number, CaseName(text, "shrinking"))
        self._number += 1
        result = next(self._results)
        own = (outcome for outcome in result.outcomes if outcome.target == self.target)
        return result, next(own, None)

    def close(self) -> None:
        self._results.close()  # type: ignore[attr-defined]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def same_fault(first: Outcome, second: Outcome | None) -> bool:
    """Whether verdict, reasons and signal agree. In space, where the reasons depend on the
    knowledge of the sum, the witness's side replaces them."""
    if second is None or second.verdict is not (first.was or first.verdict):
        return False
    if first.witness and second.witness and len(first.witness.point) == 3:
        return first.witness.in_truth == second.witness.in_truth
    return set(second.kinds) == set(first.kinds) and second.signal == first.signal
