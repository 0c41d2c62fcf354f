"""Bars of two lists paired one to one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def unpaired(required: Iterable[int], partners: Sequence[Sequence[int]]) -> int | None:
    """Pairs each required member of one list with a partner of its own; returns a member for which
    none is left, or None. `partners`: numbers in the second list, by number in the first. If the
    required members of each list can be paired alone, they can all be paired together (Mendelsohn
    and Dulmage)."""
    owner: dict[int, int] = {}
    own: dict[int, int] = {}
    for start in required:
        if not _augment(start, partners, owner, own):
            return start
    return None


def _augment(
    start: int, partners: Sequence[Sequence[int]], owner: dict[int, int], own: dict[int, int]
) -> bool:
    """Finds a way that alternates between new and old pairs, and turns it over."""
    came_from: dict[int, int] = {}
    waiting = [start]
    for member in waiting:
        for partner in partners[member]:
            if partner in came_from:
                continue
            came_from[partner] = member
            if partner in owner:
                waiting.append(owner[partner])
                continue
            free: int | None = partner
            while free is not None:
                last = came_from[free]
                before = own.get(last)
                owner[free], own[last] = last, free
                free = before
            return True
    return False
