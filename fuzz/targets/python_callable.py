"""A Python function as a target: `py:module:function`."""

from __future__ import annotations

import importlib
import json
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, cast

from minkref.errors import message_of
from minkref.fuzz.cases.case import Case
from minkref.fuzz.cases.invalid_case import InvalidCase
from minkref.fuzz.cases.space_case import SpaceCase
from minkref.fuzz.targets.answer import Answer, Target, answered, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration, DeclarationError, read_declaration
from minkref.fuzz.targets.numbers import (
    Unreadable,
    plane_answer,
    sent_set,
    sent_solid,
    solid_answer,
)
from minkref.fuzz.verdicts.verdict import Verdict


class CallableTarget:
    """The function takes sP and Q as dictionaries in the form of the canonical JSON (not
    necessarily canonical), in space with `vertices` and `faces`, and returns their sum in the same
    form, its numbers as texts `n` or `n/d` or as int, its rings running either way. None says that
    the case is outside its capabilities, and ValueError that an operand is invalid. A dictionary
    `minkref` among the function's attributes is its declaration, as the answer to `hello` of the
    adapter protocol: with `"numbers": "double"` it takes and returns floats."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._function, self._declaration = load_function(name)
        self._plain = not hasattr(self._function, "minkref")

    def sum(self, case: Case | SpaceCase | InvalidCase) -> Answer:
        declaration = self._declaration
        if not self._plain or not isinstance(case, Case):
            lack = lacking(declaration, case)
            if lack:
                return skipped(lack, declaration)
        try:
            send = sent_solid if isinstance(case, SpaceCase) else sent_set
            P, Q = (send(text, declaration) for text in (case.scaled_P_json, case.Q_json))
        except OverflowError:
            return skipped("numbers beyond the range of doubles", declaration)
        try:
            result = self._function(P, Q)
        except MemoryError as error:
            verdict, message = Verdict.OUT_OF_MEMORY, message_of(error)
            return Answer(verdict=verdict, message=message, declaration=declaration)
        except BaseException as error:  # noqa: BLE001 a fault of the target, whatever it is
            rejected = isinstance(case, InvalidCase) and isinstance(error, ValueError)
            verdict = Verdict.WRONG if rejected else Verdict.ERRORED
            message = message_of(error)
            return Answer(verdict=verdict, message=message, declaration=declaration)
        if result is None:
            return skipped("outside the capabilities of the target", declaration)
        read = solid_of if isinstance(case, SpaceCase) else answer_of
        return read(result, declaration)

    def close(self) -> None:
        pass


def answer_of(result: Any, declaration: Declaration) -> Answer:
    """The answer of a function that returned `result`."""
    if declaration.numbers == "double":
        try:
            answer = plane_answer(json.loads(json.dumps(result)), declaration, 0.0)
        except (Unreadable, TypeError, ValueError, RecursionError) as error:
            message = f"the answer is not a polygon set: {message_of(error)}"
            answer = Answer(verdict=Verdict.ERRORED, message=message)
    else:
        answer = answered(result, 0.0, turned=True)
    answer.declaration = declaration
    return answer


def solid_of(result: Any, declaration: Declaration) -> Answer:
    """As answer_of, in space."""
    try:
        return solid_answer(json.loads(json.dumps(result)), declaration, 0.0)
    except (Unreadable, TypeError, ValueError, AttributeError, RecursionError) as error:
        message = f"the answer is no polyhedron: {message_of(error)}"
        return Answer(verdict=Verdict.ERRORED, message=message, declaration=declaration)


@dataclass
class UnloadableTarget:
    """A function that could be loaded before the run, and now cannot."""

    name: str
    message: str

    def sum(self, case: Case | SpaceCase | InvalidCase) -> Answer:
        return Answer(verdict=Verdict.ERRORED, message=self.message)

    def close(self) -> None:
        pass


def callable_target(name: str) -> Target:
    try:
        return CallableTarget(name)
    except DeclarationError as error:
        return UnloadableTarget(name, f"its declaration: {error}")
    except BaseException as error:  # noqa: BLE001 a module may do anything on import
        return UnloadableTarget(name, message_of(error))


def load_function(name: str) -> tuple[Callable[[Any, Any], Any], Declaration]:
    """The function of `py:module:function` and its declaration. Modules of the current folder are
    found, too. Raises what the import of the module raises, and DeclarationError."""
    _, module, function = name.split(":", 2)
    here = os.getcwd()
    sys.path.insert(0, here)
    try:
        loaded = getattr(importlib.import_module(module), function)
    finally:
        sys.path.remove(here)
        if here not in sys.path:
            sys.path.append(here)  # for what the module imports later; it shadows nothing
    if not callable(loaded):
        raise TypeError(f"{function} is no function")
    declared = getattr(loaded, "minkref", {})
    if not isinstance(declared, dict):
        raise DeclarationError("the attribute minkref is no dictionary")
    return cast(Callable[[Any, Any], Any], loaded), read_declaration(declared, name)
