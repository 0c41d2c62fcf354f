"""Rings from polylines joined at the ends."""

from __future__ import annotations

from collections.abc import Sequence

from minkref.drawings.curves import Point
from minkref.drawings.reading import Reading
from minkref.repair.weld import welded


def rings_of(chains: Sequence[list[Point]], reading: Reading) -> list[list[Point]]:
    """Join polylines at equal ends; ends nearer than the weld move to the first end. The order of
    the file decides between four or more ends. Refuses a point with an odd number of ends.
    Linear."""
    moves = reading.moves
    if reading.weld is not None:
        ends_in_order = (end for chain in chains for end in (chain[0], chain[-1]))
        moves.update(welded(ends_in_order, reading.weld))
    chains = [
        [moves.get(c[0], c[0]), *c[1:-1], moves.get(c[-1], c[-1])]  # type: ignore[list-item]
        for c in chains
    ]
    ends: dict[Point, list[int]] = {}
    for k, chain in enumerate(chains):
        ends.setdefault(chain[0], []).append(k)
        ends.setdefault(chain[-1], []).append(k)
    for end, meeting in ends.items():
        if len(meeting) % 2:
            raise reading.refusal(
                f"a line ends at ({end[0]}, {end[1]}), and no other begins there",
                "close the gap, or let `minkref repair` join ends nearer than a distance: --weld T",
                "open-chain",
            )
    left = [True] * len(chains)
    rings = []
    for start in range(len(chains)):
        if not left[start]:
            continue
        ring: list[Point] = []
        at, point = start, chains[start][0]
        while True:
            left[at] = False
            chain = chains[at] if chains[at][0] == point else chains[at][::-1]
            ring += chain[:-1]
            point = chain[-1]
            following = next((k for k in ends[point] if left[k]), None)
            if following is None or point == chains[start][0]:
                break
            at = following
        rings.append(ring)
    return rings
