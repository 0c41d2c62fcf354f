"""Processes from /proc: children, and a tree's memory and processor time."""

from __future__ import annotations

import os
from pathlib import Path

PAGE = os.sysconf("SC_PAGE_SIZE")
TICKS = os.sysconf("SC_CLK_TCK")  # a second
PROC = Path("/proc")


def children_of(parent: int) -> list[int]:
    """Lists a process's children, from the kernel's list; else from every process's parent."""
    try:
        return [int(p) for p in (PROC / f"{parent}/task/{parent}/children").read_text().split()]
    except (OSError, ValueError):
        return [child for child, its in _parents().items() if its == parent]


def tree_bytes(root: int) -> int:
    """The memory of all processes below `root`, without `root` itself. Shared memory counts once
    if the kernel tells the shares, else in each process."""
    return sum(_bytes_of(process) for process in descendants(root))


def resident_bytes(root: int) -> int:
    """At least as much as tree_bytes, at less cost: shared memory counts in each process."""
    return sum(_resident(process) for process in descendants(root))


def tree_seconds(root: int) -> float:
    """Processor time of all processes below `root`, including their ended children; for ended
    children of `root` itself, use resource.getrusage."""
    return sum(_seconds_of(process) for process in descendants(root))


def descendants(root: int) -> list[int]:
    """All processes below `root`."""
    parents = _parents()
    found, new = [], [root]
    while new:
        new = [process for process, its in parents.items() if its in new]
        found += new
    return found


def _parents() -> dict[int, int]:
    found = {}
    for entry in os.listdir(PROC):
        if entry.isdecimal():
            try:
                text = (PROC / entry / "stat").read_bytes()
                found[int(entry)] = int(text.rpartition(b")")[2].split()[1])
            except (OSError, IndexError):
                continue
    return found


def _seconds_of(process: int) -> float:
    try:
        text = (PROC / f"{process}/stat").read_bytes()
        return sum(int(word) for word in text.rpartition(b")")[2].split()[11:15]) / TICKS
    except (OSError, ValueError):
        return 0.0


def _resident(process: int) -> int:
    try:
        return int((PROC / f"{process}/statm").read_text().split()[1]) * PAGE
    except (OSError, IndexError):
        return 0


def _bytes_of(process: int) -> int:
    try:
        text = (PROC / f"{process}/smaps_rollup").read_text()
    except OSError:
        return _resident(process)
    words = text.partition("\nPss:")[2].split()
    return int(words[0]) * 1024 if words else _resident(process)
