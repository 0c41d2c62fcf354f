"""Pairs bars one to one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


def unpaired(required: Iterable[int], partners: Sequence[Sequence[int]]) -> int | None:
    """Gives each required member its own partner; returns a member left without, or None.
    `partners`: second numbers, by first number. Required members on both sides can be paired
    together if either side can alone (Mendelsohn and Dulmage)."""
    owner: dict[int, int] = {}
    own: dict[int, int] = {}
    for start in required:
        if not _augment(start, partners, owner, own):
            return start
    return None


def _augment(
    start: int, partners: Sequence[Sequence[int]], owner: dict[int, int], own: dict[int, int]
) -> bool:
    """Finds a path, new and old pairs alternating, then swaps them."""
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
