"""Chooses the program that shows a finding, by the target's name."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from minkref.fuzz.libraries.catalogue import LIBRARIES
from minkref.fuzz.libraries.program import Program
from minkref.fuzz.run.runner import Finding

Maker = Callable[[Finding, str], Program | None]


def program(finding: Finding, name: str) -> Program | None:
    """Returns the program, its file called `name`; None if none exists (`why_none`)."""
    if finding.case.offset is not None or finding.case.features is not None:
        return None
    maker = _maker(finding.outcome.target, finding.case.union is not None)
    return maker(finding, name) if maker else None


def why_none(finding: Finding) -> str:
    """A sentence for a finding that has no program."""
    if finding.case.offset is not None or finding.case.features is not None:
        return "No program: only sums and unions have programs so far."
    if _maker(finding.outcome.target) and finding.case.union is not None:
        return "No program: this library's programs show sums."
    if _maker(finding.outcome.target):
        return "No program: the library is not called with such operands."
    if finding.outcome.target.startswith("minkref"):
        return "No program: this is minkref itself; the line above shows it."
    return "No program: the adapter or function is itself the program that shows it."


def library(target: str) -> str:
    """Returns the accused library's name; for an unknown library, the target's name."""
    folder = _folder(target)
    return LIBRARIES[folder].title if folder else target


def _maker(target: str, union: bool = False) -> Maker | None:
    folder = _folder(target)
    if folder is None:
        return None
    library = LIBRARIES[folder]
    if not library.has_program or (union and not library.shows_unions):
        return None
    module = import_module(f"minkref.fuzz.libraries.{folder}.program")
    names = {adapter.name for adapter in library.adapters}
    maker: Maker = module.program
    return maker if target in names or _is_method(module, target) else None


def _folder(target: str) -> str | None:
    """The folder of the library with the longest prefix of the target's name."""
    fitting = [name for name, each in LIBRARIES.items() if target.startswith(each.targets)]
    return max(fitting, key=lambda name: len(LIBRARIES[name].targets), default=None)


def _is_method(module: object, target: str) -> bool:
    """Whether a target is a library method without adapter."""
    return bool(getattr(module, "shows", lambda _: False)(target))
