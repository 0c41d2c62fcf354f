"""A function as a target: `py:module:function` and `so:./library.so:function`.

A program of ours holds it (fuzz/adapters/function_host.py) and speaks the adapter protocol, so that
a function has the walls and limits of an adapter.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.verbs import REJECTS
from minkref.fuzz.isolation.sandbox import EMPTIED
from minkref.fuzz.targets.adapter import ProgramTarget
from minkref.fuzz.targets.answer import Answer, skipped
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Verdict

HOST = Path(__file__).parents[1] / "adapters" / "function_host.py"
PYTHON, C = "py", "so"
MENDS = {
    PYTHON: "write py:module:function, the module importable from here",
    C: "write so:./library.so:function; `minkref adapter header` prints where its header is",
}


class FunctionTarget(ProgramTarget):
    """A Python function takes sP and Q as dictionaries in the canonical JSON's form (not
    necessarily canonical), in space with `vertices` and `faces`, and returns their sum in the same
    form, its numbers as texts `n` or `n/d` or as int, its rings running either way. None says that
    the case is outside its capabilities, and ValueError that an operand is invalid. A dictionary
    `minkref` among the function's attributes is its declaration, as the answer to `hello` in the
    adapter protocol: with `"numbers": "double"` it takes and returns floats. With `"sum":
    "none"` it grows P by a radius, finds the features of P, or unites a list of sets. For C
    functions see fuzz/adapters/minkref_adapter.h."""

    def _read(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        try:
            answer: Answer = case.exchange.received_of_function(value, declaration, seconds)
            return answer
        except ValueError as error:
            message = f"the answer is {case.exchange.answer_is_no}: {message_of(error)}"
            return Answer(verdict=Verdict.ERRORED, message=message, declaration=declaration)

    def _without_result(
        self, case: AnyCase, value: dict[str, Any], declaration: Declaration
    ) -> Answer:
        if value["status"] == "skipped":  # None: no broken promise
            return skipped("outside the capabilities of the target", declaration)
        is_fault = value["status"] == "rejected" and self.name.startswith(f"{PYTHON}:")
        if is_fault and REJECTS not in case.needs:
            value = {**value, "status": "errored"}  # any ValueError
        return super()._without_result(case, value, declaration)


def host_command(name: str) -> list[str]:
    """Returns the command line of the program that hosts the named function. Refuses a name without
    a function."""
    kind, *parts = name.split(":")
    if len(parts) != 2 or not all(parts):
        what = "C" if kind == C else "Python"
        raise Refusal(f"this is not the name of a {what} function", name, MENDS[kind])
    shown = _packages(parts[0]) if kind == PYTHON else []
    return [sys.executable, str(HOST), kind, *parts, *shown]


def _packages(module: str) -> list[str]:
    """Folders with the module's name inside searched folders whose files the sandbox shows only
    singly; as words of the command line these folders are shown."""
    searched = [os.getcwd(), *os.environ.get("PYTHONPATH", "").split(os.pathsep)]
    found = [os.path.abspath(place) for place in searched if os.path.abspath(place) in EMPTIED]
    folders = [os.path.join(place, module.partition(".")[0]) for place in found]
    return [folder for folder in folders if os.path.isdir(folder)]


def mend_of(name: str) -> str:
    """Says how to mend a function of this name that cannot be loaded."""
    return MENDS[name.partition(":")[0]]
