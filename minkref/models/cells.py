"""The drawing of a net of nerve cells: bodies, the fibres between them, and loose ends."""

from __future__ import annotations

from drawing import Nib, smooth
from shapes import Chance, Drawing, chain

_BODIES = chain(
    "-3.2,13.6,0.9 7.4,11.2,1.5 -6.8,7.8,0.6 2.6,6.2,1.7 -1.6,3,0.5 -8.2,0.2,0.8 "
    "-2.4,-2.2,1.6 6.4,1.4,0.5 3.4,-5.4,1.3 8.6,-7.6,0.7 -8.4,-9,1.7 -0.8,-8.6,0.8 "
    "5.2,-12.4,0.9 -3.6,-13,0.5"
)
# pairs of bodies, with the fibre's sideways bend
_FIBRES = """
0 1 0.4  0 1 -0.9  0 2 0.3  0 3 0.3  1 3 0.5  1 3 -0.6  2 3 0.4  2 4 -0.3  3 4 0.4  2 5 0.3  4 6 0.3
5 6 0.7  5 6 -0.5  3 6 0.4  3 7 -0.3  1 7 0.3  7 8 0.4  6 8 0.4  6 8 -0.5  8 9 0.3  7 9 -0.5
6 10 0.5  10 11 0.6  10 11 -0.4  6 11 0.3  8 11 -0.2  8 12 0.4  10 13 0.3  11 13 0.4  9 12 0.3
5 10 0.5
"""
# loose ends: from a body towards a point, often forking
_LOOSE = """
0 -9.6,14.2  0 1.2,14.8  1 10.3,14.6  1 10.4,10.2  1 4.2,14.6  2 -10.3,9.4  2 -10.1,5.2
3 10.4,6.6  3 6.6,4.2  5 -10.4,-2.6  5 -10.3,2.4  7 10.4,2.2  9 10.3,-4.4  9 10.4,-10.6
12 9.8,-14.6  12 2,-14.8  10 -10.4,-5.6  10 -9.2,-14.4  13 -6.6,-14.8  13 0.6,-14.6  4 -4.8,2.2
8 6.4,-8.6  3 -1,9.2  6 0.8,0.4
"""


def _fibre(start: Nib, end: Nib, bend: int, thick: int, chance: Chance) -> list[Nib]:
    """Draw a trembling arc of ten nibs, thicker at its ends, bent by `bend` thousandths of its
    length."""
    (ax, ay, _), (bx, by, _) = start, end
    result = []
    for k in range(11):
        bow = 4 * bend * k * (10 - k) // 100
        x = ax + (bx - ax) * k // 10 - (by - ay) * bow // 10_000
        y = ay + (by - ay) * k // 10 + (bx - ax) * bow // 10_000
        waver = 1100 if 0 < k < 10 else 0
        ink = thick * (10 + (k - 5) ** 2 // 3) // 12
        result.append((x + chance.between(-waver, waver), y + chance.between(-waver, waver), ink))
    return smooth(result, 2)


def cells() -> Drawing:
    """Draw a connected planar net with 18 holes: 14 bodies, 31 fibres, and trimmed loose ends."""
    chance = Chance(1815)
    drawing: Drawing = [[body] for body in _BODIES]
    for x, y, r in _BODIES:  # bodies are not round
        for _ in range(3):
            shift = (chance.between(-r // 2, r // 2), chance.between(-r // 2, r // 2))
            drawing.append([(x, y, 2 * r // 3), (x + shift[0], y + shift[1], 2 * r // 3)])
    words = _FIBRES.split()
    for a, b, bend in zip(words[::3], words[1::3], words[2::3], strict=True):
        bow = int(float(bend) * 2000)
        drawing.append(
            _fibre(_BODIES[int(a)], _BODIES[int(b)], bow, chance.between(1100, 1800), chance)
        )
    words = _LOOSE.split()
    for a, to in zip(words[::2], words[1::2], strict=True):
        end = chain(to + ",0.1")[0]
        arm = _fibre(_BODIES[int(a)], end, chance.between(-900, 900), 1300, chance)
        drawing.append(arm)
        fork = arm[2 * len(arm) // 3]
        reach = (end[1] - fork[1]) // 2, (fork[0] - end[0]) // 2
        drawing.append([fork, ((fork[0] + end[0]) // 2 + reach[0] // 2,
                               (fork[1] + end[1]) // 2 + reach[1] // 2, 900)])  # fmt: skip
    return drawing
