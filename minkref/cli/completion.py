"""Words that a shell offers for `minkref verify`. Where no word matches, the shell offers files."""

from __future__ import annotations


def targets(incomplete: str) -> list[str]:
    from minkref.fuzz.run.catalogue import list_targets

    return [entry.name for entry in list_targets() if entry.name.startswith(incomplete)]


def families(incomplete: str) -> list[str]:
    from minkref.fuzz.plane.families.catalogue import FAMILIES
    from minkref.fuzz.space.families import SPACE_FAMILIES

    return [name for name in (*FAMILIES, *SPACE_FAMILIES) if name.startswith(incomplete)]
