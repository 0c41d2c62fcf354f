"""What the targets of a run say of themselves before it begins."""

from __future__ import annotations

from dataclasses import replace

from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import REGIONS, Answer, Limits
from minkref.fuzz.targets.catalogue import TargetEntry, is_adapter, make_target
from minkref.fuzz.targets.convex_reference import CONVEX_DECLARATIONS
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.reference import UPDATING

_OURS = {one.name: one for one in (*UPDATING.values(), *CONVEX_DECLARATIONS.values())}


def declarations_of(
    entries: list[TargetEntry], limits: Limits
) -> tuple[list[TargetEntry], dict[str, Declaration]]:
    """The entries with the versions that adapters give, and all declarations. An adapter that does
    not start is taken to declare nothing but the plane: the run says what is wrong with it."""
    found: dict[str, Declaration] = {}
    named = []
    for entry in entries:
        found[entry.name] = REGIONS
        if is_adapter(entry.name):
            target = make_target(entry.name, limits)
            assert isinstance(target, AdapterTarget)
            declared = target.declared()
            target.close()
            if not isinstance(declared, Answer):
                found[entry.name] = declared
                entry = replace(entry, version=declared.version or entry.version)
        elif entry.name in _OURS:
            found[entry.name] = _OURS[entry.name]
        named.append(entry)
    return named, found
