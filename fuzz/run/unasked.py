"""Sentences on questions that a run did not ask its targets, and results that it could not
prove."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from minkref.fuzz.run.resting import MOST_TIME_OUTS, RESTS
from minkref.fuzz.run.runner import Run
from minkref.fuzz.setting import Setting
from minkref.fuzz.settings import SETTINGS
from minkref.fuzz.targets.declaration import CAPABILITIES, Declaration

NAMED = "named"  # the group for cases that the command names


def not_asked(done: Run, declared: Mapping[str, Declaration]) -> list[str]:
    """Tells what targets declare and no case of the run asked for: a sentence for each target and
    verbs, and, unless the cases were named, a sentence on the kinds of operands and scales."""
    notes = []
    for name, declaration in declared.items():
        able = declaration.capabilities
        taken = [setting for setting in SETTINGS if setting.name in able]
        missing = [
            f"{verb} ({setting.name})"
            for setting in taken
            for verb in _verbs(declaration, setting)
            if not done.asked[name, verb, setting.dimension]
        ]
        if missing:
            notes.append(
                f"{name} declares verbs that this run did not ask for: {', '.join(missing)}"
            )
        absent = [
            f"{setting.where} {', '.join(kinds)}"
            for setting in taken
            if (kinds := _not_met(done, name, able, setting))
        ]
        if absent and set(done.groups) != {NAMED}:
            notes.append(
                f"{name} declares kinds of input that no case of this run had: {'; '.join(absent)}"
            )
    return notes


def _verbs(declaration: Declaration, setting: Setting) -> Iterator[str]:
    """The verbs that a target declares in a setting."""
    if declaration.makes_sums:
        yield "at"
    yield from (verb for verb in setting.verbs if verb in declaration.capabilities)


def _not_met(done: Run, name: str, able: Iterable[str], setting: Setting) -> list[str]:
    """Kinds of operands, numbers and scales that a target takes and was not asked about."""
    others = {word for each in SETTINGS for word in (each.name, *each.verbs)} | setting.never
    return [
        capability
        for capability in CAPABILITIES
        if capability in able and capability not in others
        if not done.met[name, capability, setting.dimension]
    ]


def resting_notes(done: Run, targets: Iterable[str], count: int | None) -> list[str]:
    """A sentence for each resting target. `count`: the run's intended number of cases, if known."""
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


def unproven_notes(done: Run) -> list[str]:
    """A sentence for each target some of whose answers pass without a proof."""
    return [
        f"{name}: {len(remarks):,} answers pass without a proof, the first {min(remarks)[1]}"
        for name, remarks in sorted(done.remarks.items())
    ]
