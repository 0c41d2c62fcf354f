"""The drawings behind the models: strokes with rounded ends, in units of 10^-4."""

from __future__ import annotations

from decimal import Decimal

from circle import cosine_and_sine
from drawing import Nib

UNIT = 10_000
Drawing = list[list[Nib]]


class Chance:
    """A linear congruential generator (Knuth's MMIX constants), for a hand that trembles."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def between(self, low: int, high: int) -> int:
        """Draw an integer from [low, high]."""
        self.state = (6364136223846793005 * self.state + 1442695040888963407) % 2**64
        return low + (self.state >> 33) % (high - low + 1)


def nibs(*texts: tuple[str, str, str]) -> list[Nib]:
    """Make nibs from decimals, in units of 10^-4."""
    return [(exact(x), exact(y), exact(r)) for x, y, r in texts]


def exact(text: str) -> int:
    return int(Decimal(text) * UNIT)


def chain(text: str) -> list[Nib]:
    """ "x,y,r x,y,r ..." """
    return nibs(*[(x, y, r) for x, y, r in (word.split(",") for word in text.split())])


def spiral(
    centre: tuple[str, str], outer: str, inner: str, turns: int, thick: str, thin: str
) -> list[Nib]:
    """Draw counter-clockwise and inwards, from the right of the centre, 24 nibs per turn."""
    cx, cy = Decimal(centre[0]), Decimal(centre[1])
    result, steps = [], 24 * turns
    for k in range(steps + 1):
        cosine, sine = cosine_and_sine(Decimal(k % 24) / 24)
        part = Decimal(k) / steps
        radius = Decimal(outer) + (Decimal(inner) - Decimal(outer)) * part
        ink = Decimal(thick) + (Decimal(thin) - Decimal(thick)) * part
        x, y = cx + radius * cosine, cy + radius * sine
        result.append((int(x * UNIT), int(y * UNIT), int(ink * UNIT)))
    return result


def tremble(strokes: Drawing, amount: int, seed: int) -> Drawing:
    """Move every nib except the ends by up to `amount` in x and in y."""
    chance = Chance(seed)
    return [
        [
            (x + chance.between(-amount, amount), y + chance.between(-amount, amount), r)
            if 0 < k < len(stroke) - 1
            else (x, y, r)
            for k, (x, y, r) in enumerate(stroke)
        ]
        for stroke in strokes
    ]
