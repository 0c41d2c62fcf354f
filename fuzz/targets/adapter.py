"""An implementation behind the adapter protocol as a target."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeVar

from minkref.errors import cut, message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.verbs import FEATURES, OFFSET, UNION
from minkref.fuzz.targets.adapter_process import GAVE_UP, AdapterProcess, Failure
from minkref.fuzz.targets.answer import REGIONS, Answer, Limits, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable, sent_number
from minkref.fuzz.verdicts.verdict import Verdict

MOST_FAILED_STARTS = 3
T = TypeVar("T")
Manner = Callable[[Callable[[Fraction], Any]], dict[str, Any]]


@dataclass
class ProgramTarget:
    """Asks `load` once for two operands, then `at`; or for a union or an offset."""

    name: str
    command: list[str]
    limits: Limits
    environment: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._process = AdapterProcess(self.name, self.command, self.limits, self.environment)
        self._loaded: tuple[str, str] | None = None
        self._failed_starts = 0
        self._last_failure: Failure | None = None

    @property
    def most_pairs(self) -> int | None:
        return None

    def sum(self, case: AnyCase) -> Answer:
        """The fresh sum."""
        return self._guarded(case, lambda d: self._at(case, d, "at"))

    def union(self, case: AnyCase, sets: Sequence[str]) -> Answer:
        """Asks for the union: without `load`, and no state changes."""

        def fields(declaration: Declaration) -> dict[str, Any]:
            return {"sets": [case.exchange.sent(text, declaration) for text in sets]}

        return self._asked_at_once(case, UNION, fields)

    def offset(self, case: AnyCase, text: str, radius: Fraction, manner: Manner) -> Answer:
        """Asks for a set grown by a disc: without `load`, and no state changes. `manner` writes
        the members about joins and caps, its numbers by the function that it gets."""
        return self._asked_with_radius(case, OFFSET, text, radius, manner)

    def features(self, case: AnyCase, text: str, radius: Fraction) -> Answer:
        """Asks for the concave features of a set, likewise."""
        return self._asked_with_radius(case, FEATURES, text, radius)

    def _asked_with_radius(
        self, case: AnyCase, verb: str, text: str, radius: Fraction, manner: Manner = lambda _: {}
    ) -> Answer:
        def fields(declaration: Declaration) -> dict[str, Any]:
            P = case.exchange.sent(text, declaration)
            more = manner(lambda number: sent_number(number, declaration))
            return {"P": P, "radius": sent_number(radius, declaration), **more}

        return self._asked_at_once(case, verb, fields)

    def _asked_at_once(
        self, case: AnyCase, verb: str, fields: Callable[[Declaration], dict[str, Any]]
    ) -> Answer:
        """Asks a question that holds its sets."""

        def ask(declaration: Declaration) -> Answer:
            import time

            since = time.perf_counter()
            value = self._process.ask(
                verb, self.limits.seconds, dimension=case.dimension, **fields(declaration)
            )
            seconds = time.perf_counter() - since
            if value["status"] != "result":
                return self._without_result(case, value, declaration)
            return self._read(case, value, declaration, seconds)

        return self._guarded(case, ask)

    def declared(self) -> Declaration | Answer:
        """Returns the target's declaration; else an answer that explains its absence."""
        try:
            return self._process.start()
        except Failure as failure:
            return _failed(failure, REGIONS)

    def close(self) -> None:
        self._process.close()

    def _guarded(self, case: AnyCase, ask: Callable[[Declaration], Answer], *more: str) -> Answer:
        declaration = REGIONS
        try:
            declaration = self._started()
            lack = lacking(declaration, case, *more)
            if lack:
                return skipped(lack, declaration)
            answer = ask(declaration)
        except Failure as failure:
            self._loaded = None
            return _failed(failure, declaration)
        except OverflowError:
            return skipped("numbers beyond the range of doubles", declaration)
        except (Unreadable, ValueError, ZeroDivisionError, TypeError, KeyError) as error:
            message = f"the answer cannot be read: {message_of(error)}"
            return Answer(verdict=Verdict.ERRORED, message=message, declaration=declaration)
        return answer

    def _started(self) -> Declaration:
        if self._failed_starts >= MOST_FAILED_STARTS and self._last_failure is not None:
            raise self._last_failure
        if self._process.declaration is None:
            self._loaded = None
        try:
            declaration = self._process.start()
        except Failure as failure:
            self._failed_starts += 1
            self._last_failure = failure
            raise
        self._failed_starts = 0
        return declaration

    def _load(self, case: AnyCase, declaration: Declaration) -> None:
        case = case.exchange.taken(case, declaration)
        key = (case.P_json, case.Q_json)
        if self._loaded == key:
            return
        self._loaded = None
        exchange = case.exchange
        value = self._process.ask(
            "load",
            self.limits.seconds,
            dimension=case.dimension,
            P=exchange.sent(case.P_json, declaration),
            Q=exchange.sent(case.Q_json, declaration),
        )
        if value["status"] != "result":
            raise Refused(value)
        self._loaded = key

    def _at(self, case: AnyCase, declaration: Declaration, verb: str) -> Answer:
        import time

        since = time.perf_counter()
        try:
            self._load(case, declaration)
        except Refused as refused:
            return self._without_result(case, refused.value, declaration)
        exchange = case.exchange
        case = exchange.taken(case, declaration)
        value = self._process.ask(
            verb,
            self.limits.seconds,
            scale=exchange.sent_scale(case.scale),
            sP=exchange.sent(case.scaled_P_json, declaration),
        )
        seconds = time.perf_counter() - since
        if value["status"] != "result":
            return self._without_result(case, value, declaration)
        return self._read(case, value, declaration, seconds)

    def _read(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        answer: Answer = case.exchange.received(value, declaration, seconds)
        return answer

    def _without_result(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration
    ) -> Answer:
        reason = cut(str(value.get("reason", "")))
        if value["status"] == "rejected":
            return Answer(verdict=Verdict.WRONG, message=reason, declaration=declaration)
        if value["status"] == GAVE_UP:
            message = reason or "gave up, without a reason"
            return Answer(verdict=Verdict.GAVE_UP, message=message, declaration=declaration)
        if value["status"] == "skipped":
            message = f"skipped what it declares to take: {reason}"
        else:
            message = reason or "errored, without a reason"
        verdict = Verdict.ERRORED
        if any(word in reason.lower() for word in ("bad_alloc", "memoryerror")):
            verdict = Verdict.OUT_OF_MEMORY
        return Answer(verdict=verdict, message=message, declaration=declaration)


class AdapterTarget(ProgramTarget):
    """Asks for updates, events and paths, too."""

    @property
    def most_pairs(self) -> int:
        return 40_000

    def updated_sum(self, before: AnyCase, case: AnyCase) -> Answer:
        """The sum by `update` from the sum of `before`, with the same operands at another scale.
        For about half the cases, chosen by name, `before` is itself reached by `update`, from the
        sum of `case`."""

        def ask(declaration: Declaration) -> Answer:
            lack = lacking(declaration, before)
            if lack:
                return skipped(lack, declaration)
            if before.exchange.taken(before, declaration) is not before:
                return skipped("does not declare non-uniform", declaration)
            steps: list[tuple[AnyCase, str]] = [(before, "at"), (case, "update")]
            if zlib.crc32(case.name.text.encode()) % 2:
                steps = [(case, "at"), (before, "update"), (case, "update")]
            for at, verb in steps:
                answer = self._at(at, declaration, verb)
                if answer.verdict is not None:
                    break
            return answer

        return self._guarded(case, ask, "update")

    def asked(
        self,
        case: AnyCase,
        verb: str,
        fields: Callable[[Declaration], dict[str, Any]],
        read: Callable[[dict[str, Any], Declaration], T],
        *more: str,
    ) -> tuple[T, Declaration] | Answer:
        """Returns the value that `read` makes from the answer to another verb, and the declaration;
        else an answer that explains its absence. `fields` for the request; `more` capabilities
        needed."""
        found: list[T] = []

        def ask(declaration: Declaration) -> Answer:
            try:
                self._load(case, declaration)
            except Refused as refused:
                return self._without_result(case, refused.value, declaration)
            value = self._process.ask(verb, self.limits.seconds, **fields(declaration))
            if value["status"] != "result":
                return self._without_result(case, value, declaration)
            found.append(read(value, declaration))
            return Answer(declaration=declaration)

        answer = self._guarded(case, ask, *more)
        return (found[0], answer.declaration) if answer.verdict is None else answer


class Refused(Exception):
    """The answer to `load`, if not a result."""

    def __init__(self, value: dict[str, Any]) -> None:
        super().__init__(json.dumps(value)[:200])
        self.value = value


def _failed(failure: Failure, declaration: Declaration) -> Answer:
    return Answer(
        verdict=failure.verdict,
        message=failure.message,
        signal=failure.signal,
        declaration=declaration,
        log=failure.log,
    )
