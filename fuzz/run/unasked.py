"""What a run did not ask its targets, in sentences."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from minkref.fuzz.cases.verbs import EVENTS, UPDATE
from minkref.fuzz.run.resting import MOST_TIME_OUTS, RESTS
from minkref.fuzz.run.runner import REJECTS, Run
from minkref.fuzz.targets.declaration import CAPABILITIES, Declaration

NAMED = "named"  # the group of cases that the command names


def not_asked(done: Run, declared: Mapping[str, Declaration]) -> list[str]:
    """What targets declare and no case of the run asked for: a sentence for each target and verbs,
    and, unless the cases were named, one for what operands and scales may be."""
    notes = []
    for name, declaration in declared.items():
        able = declaration.capabilities
        in_plane = [("at", "plane", 2)] + [
            (verb, "plane", 2) for verb in (UPDATE, EVENTS, REJECTS) if verb in able
        ]
        in_space = [("at", "space", 3)] + [(UPDATE, "space", 3)] * (UPDATE in able)
        missing = [
            f"{verb} ({where})"
            for verb, where, dimension in (*in_plane, *in_space)
            if where in able and not done.asked[name, verb, dimension]
        ]
        if missing:
            notes.append(
                f"{name} declares verbs that this run did not ask for: {', '.join(missing)}"
            )
        absent = [
            f"in {'the plane' if dimension == 2 else 'space'} {', '.join(kinds)}"
            for where, dimension in (("plane", 2), ("space", 3))
            if where in able and (kinds := _not_met(done, name, able, dimension))
        ]
        if absent and set(done.groups) != {NAMED}:
            notes.append(
                f"{name} declares kinds of input that no case of this run had: {'; '.join(absent)}"
            )
    return notes


def _not_met(done: Run, name: str, able: Iterable[str], dimension: int) -> list[str]:
    """Kinds of operands, numbers and scales that a target takes and was not asked about."""
    others = {"plane", "space", UPDATE, EVENTS, REJECTS, *(["non-uniform"] * (dimension == 2))}
    return [
        capability
        for capability in CAPABILITIES
        if capability in able and capability not in others
        if not done.met[name, capability, dimension]
    ]


def resting_notes(done: Run, targets: Iterable[str], count: int | None) -> list[str]:
    """A sentence for each target that rests. `count`: how many cases the run was to have, where
    that is known."""
    ran = sum(done.cases.values())
    notes = []
    for name, case in done.resting.items():
        unasked = sum(
            cell.skips[RESTS] for (target, _), cell in done.matrix.items() if target == name
        )
        left = f"{unasked:,} cases were not asked"
        if done.resting.keys() >= set(targets):
            left = "the run ended there"
            if count is not None:
                left += f", {count - ran + unasked:,} cases before its end"
        notes.append(
            f"{name} had no answer to {MOST_TIME_OUTS} cases in a row, the last of them {case}: it "
            f"was not asked again; {left}"
        )
    return notes
