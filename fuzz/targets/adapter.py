"""An implementation behind the adapter protocol as a target."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref.errors import cut, message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_claim import PathClaim
from minkref.fuzz.plane.case import Case
from minkref.fuzz.settings import setting_of
from minkref.fuzz.targets.adapter_process import AdapterProcess, Failure
from minkref.fuzz.targets.answer import REGIONS, Answer, Limits, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable, double, received
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.motion.scale_ranges import ScaleRange

MOST_FAILED_STARTS = 3


@dataclass
class ProgramTarget:
    """Asks `load` once for two operands, then `at`."""

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

    def declared(self) -> Declaration | Answer:
        """What it says of itself; an answer that says why it does not."""
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
        key = (case.P_json, case.Q_json)
        if self._loaded == key:
            return
        self._loaded = None
        setting = setting_of(case.dimension)
        value = self._process.ask(
            "load",
            self.limits.seconds,
            dimension=case.dimension,
            P=setting.sent(case.P_json, declaration),
            Q=setting.sent(case.Q_json, declaration),
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
        setting = setting_of(case.dimension)
        value = self._process.ask(
            verb,
            self.limits.seconds,
            scale=setting.sent_scale(case.scale),
            sP=setting.sent(case.scaled_P_json, declaration),
        )
        seconds = time.perf_counter() - since
        if value["status"] != "result":
            return self._without_result(case, value, declaration)
        return self._read(case, value, declaration, seconds)

    def _read(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        return setting_of(case.dimension).received(value, declaration, seconds)

    def _without_result(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration
    ) -> Answer:
        reason = cut(str(value.get("reason", "")))
        if value["status"] == "rejected":
            return Answer(verdict=Verdict.WRONG, message=reason, declaration=declaration)
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
        """The sum by `update` from that of `before`, the same operands at another scale. In every
        other case, by name, that is itself reached by `update`, from the sum of `case`."""

        def ask(declaration: Declaration) -> Answer:
            lack = lacking(declaration, before)
            if lack:
                return skipped(lack, declaration)
            steps: list[tuple[AnyCase, str]] = [(before, "at"), (case, "update")]
            if zlib.crc32(case.name.text.encode()) % 2:
                steps = [(case, "at"), (before, "update"), (case, "update")]
            for at, verb in steps:
                answer = self._at(at, declaration, verb)
                if answer.verdict is not None:
                    break
            return answer

        return self._guarded(case, ask, "update")

    def events(
        self, case: Case, start: str, end: str
    ) -> tuple[list[Fraction], Declaration] | Answer:
        """Scales of topology events in [start, end] as the target has them, and what it declares;
        else why not."""
        found: list[Fraction] = []

        def ask(declaration: Declaration) -> Answer:
            try:
                self._load(case, declaration)
            except Refused as refused:
                return self._without_result(case, refused.value, declaration)
            value = self._process.ask("events", self.limits.seconds, **{"from": start, "to": end})
            if value["status"] != "result":
                return self._without_result(case, value, declaration)
            scales = value.get("scales")
            if not isinstance(scales, list):
                raise Unreadable("scales is not a list")
            found.extend(Fraction(_scale(scale, declaration)) for scale in scales)
            if any(a > b for a, b in pairwise(found)):
                raise Unreadable("scales do not ascend")
            return Answer(declaration=declaration)

        answer = self._guarded(case, ask, "events")
        return (found, answer.declaration) if answer.verdict is None else answer

    def path(self, case: AskedPath) -> tuple[PathClaim, Declaration] | Answer:
        """What the target says of the scales of a path, and what it declares; else why nothing."""
        found: list[PathClaim] = []

        def ask(declaration: Declaration) -> Answer:
            try:
                self._load(case, declaration)
            except Refused as refused:
                return self._without_result(case, refused.value, declaration)
            value = self._process.ask(
                "path",
                self.limits.seconds,
                path=[[_sent(axis, declaration) for axis in point] for point in case.path],
                contact=case.contact,
                **case.asked,
            )
            if value["status"] != "result":
                return self._without_result(case, value, declaration)
            found.append(_claim(case, value, declaration))
            return Answer(declaration=declaration)

        answer = self._guarded(case, ask)
        return (found[0], answer.declaration) if answer.verdict is None else answer


class Refused(Exception):
    """The answer to `load`, which is no result."""

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


def _sent(axis: Fraction, declaration: Declaration) -> str | float:
    return str(axis) if declaration.numbers == "text" else double(str(axis))


def _claim(case: AskedPath, value: dict[str, Any], declaration: Declaration) -> PathClaim:
    """Raises Unreadable for what is none."""
    if case.window is None:
        valid = value.get("valid")
        if not isinstance(valid, list) or not all(isinstance(one, bool) for one in valid):
            raise Unreadable("valid is not a list of true and false")
        if len(valid) != len(case.scales):
            raise Unreadable(f"valid has {len(valid)} entries for {len(case.scales)} scales")
        return PathClaim(tuple(valid))
    ranges = value.get("ranges")
    if not isinstance(ranges, list) or not all(isinstance(one, dict) for one in ranges):
        raise Unreadable("ranges is not a list of objects")
    return PathClaim(ranges=tuple(_range(one, declaration) for one in ranges))


def _range(value: dict[str, Any], declaration: Declaration) -> ScaleRange:
    """Ends belong to it unless it says that they do not; without an end it is that of the
    window."""
    if "from" not in value:
        raise Unreadable("a range has no from")
    low, high = (
        None if value.get(word) is None else Fraction(_scale(value[word], declaration))
        for word in ("from", "to")
    )
    ends_in = [value.get(word, True) for word in ("from_in", "to_in")]
    if low is None or not all(isinstance(one, bool) for one in ends_in):
        raise Unreadable("a range has from, to, from_in and to_in")
    if high is not None and high < low:
        raise Unreadable("a range ends before it begins")
    return ScaleRange(low, high, ends_in[0], ends_in[1])


def _scale(value: Any, declaration: Declaration) -> str:
    """A scale may be a text where numbers are doubles too."""
    if isinstance(value, str):
        return received(value, replace(declaration, numbers="text"))
    return received(value, declaration)
