"""Connected parts."""

from __future__ import annotations


class Parts:
    """Parts of the numbers below `count`, each number alone at first (union-find)."""

    def __init__(self, count: int) -> None:
        self._parent = list(range(count))

    def of(self, k: int) -> int:
        """Returns the number that represents the part containing `k`."""
        parent = self._parent
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    def join(self, a: int, b: int) -> None:
        """Joins two parts: the number for the part of `b` stands for both."""
        self._parent[self.of(a)] = self.of(b)
