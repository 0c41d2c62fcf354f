"""Sums with one seeded fault each, as targets `py:seeded_sums:NAME`; `sound` has none. Those about
the scale need the adapter (seeded_adapter.py)."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from types import ModuleType

import faults_of_convex_sums
import faults_of_flat_operands
import faults_of_holes
import faults_of_numbers
import faults_of_pieces
import faults_of_scale
import faults_of_shortcuts
import faults_of_state
import faults_of_union
from faults_of_scale import ScaledSum
from plain_sum import PlainSum


@dataclass(frozen=True)
class Fault:
    """A seeded fault: `name` is the function's name, `kind` tells where the fault lies."""

    name: str
    about: str
    kind: str
    make: type[PlainSum]

    @property
    def needs_scale(self) -> bool:
        return issubclass(self.make, ScaledSum)


def _name(text: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z0-9])|(?<=[A-Z0-9])(?=[A-Z][a-z])", "_", text).lower()


def _in(module: ModuleType) -> list[Fault]:
    kind = module.__name__.removeprefix("faults_of_").replace("_", " ")
    return [
        Fault(_name(each.__name__), " ".join((each.__doc__ or "").split()), kind, each)
        for each in vars(module).values()
        if isinstance(each, type)
        and issubclass(each, PlainSum)
        and each.__module__ == module.__name__
        and each is not ScaledSum
        and each.__dict__.get("seeded", True)
    ]


FAULTS: dict[str, Fault] = {
    fault.name: fault
    for module in (
        faults_of_numbers,
        faults_of_pieces,
        faults_of_convex_sums,
        faults_of_union,
        faults_of_holes,
        faults_of_shortcuts,
        faults_of_flat_operands,
        faults_of_state,
        faults_of_scale,
    )
    for fault in _in(module)
}
CALLABLE = tuple(fault.name for fault in FAULTS.values() if not fault.needs_scale)
sound = PlainSum()


@cache
def _made(name: str) -> PlainSum:
    return FAULTS[name].make()


def __getattr__(name: str) -> PlainSum:
    if name in CALLABLE:
        return _made(name)
    raise AttributeError(name)
