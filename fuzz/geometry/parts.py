"""What hangs together."""

from __future__ import annotations


class Parts:
    """Of the numbers below `count`, each alone at first (union-find)."""

    def __init__(self, count: int) -> None:
        self._parent = list(range(count))

    def of(self, k: int) -> int:
        """The number that stands for its part."""
        parent = self._parent
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    def join(self, a: int, b: int) -> None:
        """What stands for the part of `b` stands for both."""
        self._parent[self.of(a)] = self.of(b)
