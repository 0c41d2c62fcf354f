"""The evidence's parts, which are folders, and their steps, which are modules with MINUTES."""

from __future__ import annotations

import ast
import importlib
from dataclasses import dataclass
from types import ModuleType

from minkref.reports.evidence.framework.part import Minutes
from minkref.reports.evidence.framework.places import ROOM

PACKAGE = __name__.rpartition(".framework")[0]


@dataclass(frozen=True)
class Step:
    name: str  # part/module
    minutes: Minutes
    alone: bool = False  # runs alone, because the step measures time or looks at all processes

    @property
    def part(self) -> str:
        return self.name.partition("/")[0]

    @property
    def only_full(self) -> bool:
        return self.minutes.whole is None

    @property
    def row(self) -> str:
        """The name of the step's row in the summary: the part's name, or the step's own."""
        return self.name if self.only_full else self.part


def steps() -> list[Step]:
    """All steps, sorted by name. Reads the modules without importing them, which would take
    seconds."""
    found = (f"{path.parent.name}/{path.stem}" for path in sorted(ROOM.glob("*/*.py")))
    return [step for name in found if (step := declared(name))]


def declared(name: str) -> Step | None:
    """The step from a module; None for other modules."""
    text = (ROOM / f"{name}.py").read_text(encoding="utf-8")
    if "\nMINUTES = " not in text:
        return None
    values = {
        node.targets[0].id: node.value
        for node in ast.parse(text).body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    minutes = values["MINUTES"]
    assert isinstance(minutes, ast.Call)
    return Step(name, Minutes(*map(ast.literal_eval, minutes.args)), "ALONE" in values)


def module(step: str) -> ModuleType:
    """The step's module, with run(findings, size), and perhaps SEED, and RESTS_ON: folders beyond
    the recorded reads."""
    return importlib.import_module(f"{PACKAGE}.{step.replace('/', '.')}")


def claim(part: str) -> str:
    """One or two sentences."""
    text = (ROOM / part / "__init__.py").read_text(encoding="utf-8")
    return " ".join((ast.get_docstring(ast.parse(text)) or "").split())
