"""What a run did not ask its targets, in sentences."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from minkref.fuzz.cases.verbs import EVENTS, UPDATE
from minkref.fuzz.run.resting import MOST_TIME_OUTS, RESTS
from minkref.fuzz.run.runner import REJECTS, Run
from minkref.fuzz.targets.declaration import Declaration


def not_asked(done: Run, declared: Mapping[str, Declaration]) -> list[str]:
    """What targets declare and no case of the run asked for: a sentence for each target."""
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
            notes.append(f"{name} declares what this run did not ask for: {', '.join(missing)}")
    return notes


def resting_notes(done: Run, targets: Iterable[str], count: int | None) -> list[str]:
    """A sentence for each target that rests. `count`: how many cases the run was to have, where
    that is known."""
    ran = sum(done.cases.values())
    notes = []
    for name, case in done.resting.items():
        unasked = sum(
            cell.skips[RESTS] for (target, _), cell in done.matrix.items() if target == name
        )
        left = f"{unasked:,} cases are left unasked"
        if done.resting.keys() >= set(targets):
            left = "the run ended there"
            if count is not None:
                left += f", {count - ran + unasked:,} cases before its end"
        notes.append(
            f"{name} had no answer to {MOST_TIME_OUTS} cases in a row, the last of them {case}: it "
            f"was not asked any more; {left}"
        )
    return notes
