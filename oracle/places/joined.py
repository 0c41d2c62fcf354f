"""Union-find over things that join two at a time."""

from __future__ import annotations


class Joined:
    def __init__(self, count: int) -> None:
        self._above = list(range(count))

    def root(self, k: int) -> int:
        while self._above[k] != k:
            k = self._above[k]
        return k

    def join(self, a: int, b: int) -> bool:
        """Join two sets; tell whether they were apart."""
        a, b = self.root(a), self.root(b)
        self._above[max(a, b)] = min(a, b)
        return a != b
