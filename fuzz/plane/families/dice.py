"""The random numbers of the generators."""

from __future__ import annotations

import random


class Dice(random.Random):
    """`random.Random` whose whole numbers take half the time. The stream is that of Python 3.11,
    whatever the version: cases keep their names."""

    def randint(self, a: int, b: int) -> int:
        """Draws one of a, ..., b, each with the same probability. ValueError if there is none."""
        width = b - a + 1
        if width <= 0:
            raise ValueError(f"there is no whole number from {a} to {b}")
        bits = width.bit_length()
        drawn = self.getrandbits(bits)
        while drawn >= width:
            drawn = self.getrandbits(bits)
        return a + drawn
