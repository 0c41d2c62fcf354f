"""The members of a case in any setting."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Protocol

from minkref.fuzz.cases.case_name import CaseName


class Exchange(Protocol):
    """Sends operands and scales to a target, as its declaration says, and reads its answer.
    `answer_is_no`: the missing property of a function's unreadable answer."""

    @property
    def answer_is_no(self) -> str: ...
    def taken(self, case: Any, declaration: Any) -> Any:
        """The case as the target takes it."""

    def sent(self, text: str, declaration: Any) -> Any: ...
    def sent_scale(self, text: str) -> str | list[str]: ...
    def received(self, value: dict[str, Any], declaration: Any, seconds: float) -> Any:
        """An Answer. Raises Unreadable."""

    def received_of_function(
        self, value: dict[str, Any], declaration: Any, seconds: float
    ) -> Any: ...


class AnyCase(Protocol):
    """Two operands and a scale, ready to ask a target for the sum. `family` drew the case, and
    `position` tells where its scale lies; both serve a run's coverage. `needs`: the capabilities
    that an implementation must have. `judged_operands`: the operands that the verdict speaks about,
    if a law changed the operands sent. `sent`: all coordinates sent. `is_valid`: both operands are
    sets, and have a sum. `literal`: the case itself as a text that names it."""

    @property
    def name(self) -> CaseName: ...
    @property
    def dimension(self) -> int: ...
    @property
    def exchange(self) -> Exchange: ...
    @property
    def P_name(self) -> str: ...
    @property
    def Q_name(self) -> str: ...
    @property
    def P_json(self) -> str: ...
    @property
    def Q_json(self) -> str: ...
    @property
    def scaled_P_json(self) -> str: ...
    @property
    def scale(self) -> str: ...
    @property
    def family(self) -> str: ...
    @property
    def position(self) -> str: ...
    @property
    def needs(self) -> frozenset[str]: ...
    @property
    def sent(self) -> list[Fraction]: ...
    @property
    def is_valid(self) -> bool: ...
    @property
    def judged_operands(self) -> tuple[str, str]: ...
    @property
    def size(self) -> tuple[int, int, str]: ...
    @property
    def literal(self) -> str: ...
