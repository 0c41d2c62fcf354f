"""Words that a shell offers for `minkref verify`. Where no word matches, the shell offers files."""

from __future__ import annotations


def targets(incomplete: str) -> list[str]:
    from minkref.fuzz.all_targets import ALL_TARGETS

    return [entry.name for entry in ALL_TARGETS.entries() if entry.name.startswith(incomplete)]


def families(incomplete: str) -> list[str]:
    from minkref.fuzz.settings import SETTINGS

    return [n for setting in SETTINGS for n in setting.families if n.startswith(incomplete)]
