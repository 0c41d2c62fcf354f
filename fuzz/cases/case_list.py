"""The cases of a run, small ones first: random pairs, the shipped models, the paper's kind of
input."""

from __future__ import annotations

import itertools
import time
from collections.abc import Iterator
from dataclasses import dataclass, field

from minkref.fuzz.cases.case import CaseName
from minkref.model_catalogue import PAPER_MODELS, all_models, or_look_alike

SMALL_MODELS = ("g3", "g1", "disc1", "disc5", "g2", "g4", "dog145")
REAL_PAIRS = (("disc1", "neuron"), ("disc5", "neuron"), ("monkey", "bird"))
REAL_SCALES = ("1/3", "1", "7/5", "541/186", "9")


@dataclass
class CaseList:
    """What a run goes through. Random pairs are counted by `pairs` or bounded by `seconds`."""

    seed: int = 1
    pairs: int | None = None
    seconds: float = 150.0
    named: tuple[str, ...] = ()
    models: bool = True
    notes: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._rest = [] if self.named else self._model_cases() if self.models else []

    def __iter__(self) -> Iterator[CaseName]:
        if self.named:
            yield from (CaseName(text, "named") for text in self.named)
            return
        end = time.monotonic() + self.seconds
        for index in itertools.count():
            if index >= self.pairs if self.pairs is not None else time.monotonic() >= end:
                break
            yield CaseName(f"random:{self.seed}:{index}", "random pairs")
        yield from self._rest

    @property
    def count(self) -> int | None:
        """The number of cases where it is known beforehand."""
        if self.named:
            return len(self.named)
        return None if self.pairs is None else self.pairs + len(self._rest)

    def _model_cases(self) -> list[CaseName]:
        known = all_models()
        small = [name for name in SMALL_MODELS if name in known]
        cases = [
            CaseName(f"{P}+{Q}@1", "shipped models")
            for P, Q in itertools.combinations_with_replacement(small, 2)
        ]
        for first, second in REAL_PAIRS:
            P, Q = or_look_alike(first, known), or_look_alike(second, known)
            if P in known and Q in known:
                cases += [CaseName(f"{P}+{Q}@{scale}", f"{P} + {Q}") for scale in REAL_SCALES]
        for name, _, alike, _ in PAPER_MODELS:
            if name not in known:
                self.notes.append(
                    f"{name} is absent (MINKREF_MODELS does not give it): {alike} in its place"
                )
        missing = [name for name in SMALL_MODELS if name not in known]
        if missing:
            self.notes.append(f"models not found: {', '.join(missing)}")
        return cases
