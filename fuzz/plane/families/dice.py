"""The random numbers of the generators."""

from __future__ import annotations

import random


class Dice(random.Random):
    """`random.Random` with whole numbers in half the time. The stream equals Python 3.11's, in any
    version: cases keep their names."""

    def randint(self, a: int, b: int) -> int:
        """Draws from a, ..., b, all equally likely. ValueError if the range is empty."""
        width = b - a + 1
        if width <= 0:
            raise ValueError(f"there is no whole number from {a} to {b}")
        bits = width.bit_length()
        drawn = self.getrandbits(bits)
        while drawn >= width:
            drawn = self.getrandbits(bits)
        return a + drawn
