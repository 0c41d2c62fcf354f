"""The declarations of the targets of a run, before the run begins."""

from __future__ import annotations

import shlex
from dataclasses import replace

from minkref.errors import Refusal, cut
from minkref.fuzz.isolation.isolation import SANDBOX, usual
from minkref.fuzz.plane.reference import UPDATING
from minkref.fuzz.run.catalogue import Catalogue, TargetEntry, is_function
from minkref.fuzz.space.convex_reference import CONVEX_DECLARATIONS
from minkref.fuzz.space.space_reference import SPACE_DECLARATIONS
from minkref.fuzz.targets.adapter import ProgramTarget
from minkref.fuzz.targets.answer import REGIONS, Limits, Target
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.function import mend_of

_OURS = {
    one.name: one
    for group in (UPDATING, CONVEX_DECLARATIONS, SPACE_DECLARATIONS)
    for one in group.values()
}


def declarations_of(
    entries: list[TargetEntry], catalogue: Catalogue, limits: Limits
) -> tuple[list[TargetEntry], dict[str, Declaration]]:
    """Returns the entries with versions from adapters and functions, and all declarations. Refuses
    a target that does not start, or whose `hello` fails."""
    found: dict[str, Declaration] = {}
    named = []
    for entry in entries:
        found[entry.name] = _OURS.get(entry.name, REGIONS)
        if catalogue.declares_itself(entry.name):
            declared = _of_program(catalogue.target(entry.name, limits), limits)
            found[entry.name] = declared
            entry = replace(entry, version=declared.version or entry.version)
        named.append(entry)
    return named, found


def _of_program(target: Target, limits: Limits) -> Declaration:
    assert isinstance(target, ProgramTarget)
    declared = target.declared()
    target.close()
    if isinstance(declared, Declaration):
        return declared
    what, code = "the adapter does not begin", "no-adapter"
    mend = f"run it by hand: {shlex.join(target.command)}"
    name = target.name
    if is_function(name):
        what, code, mend = "the function cannot be loaded", "usage", mend_of(name)
    what += f": {declared.message}"
    if declared.log:
        what += f"; the end of its log: {cut(declared.log.strip())}"
    if (limits.isolation or usual()).kind == SANDBOX:
        mend += "; in the sandbox it has no network and writes to TMPDIR only (--isolation none)"
    raise Refusal(what, name, mend, code)
