"""Damaged sets in the plane: valid sets with one or two kinds of damage."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction

from minkref.reports.evidence.refusals.judge import doubled_area

Point = tuple[Fraction, Fraction]
Ring = list[Point]
Polygon = list[Ring]  # the outer ring, then holes; closed without a repeated point
SEED = 977
WELD = Fraction(1, 1000)
RULES = ("nonzero", "evenodd", "positive")


@dataclass
class Damaged:
    """`polygons`: what is written. `expected`: kinds of changes to be listed; `is_open`:
    rings, by polygon and number, written without a repeated point."""

    name: str
    polygons: list[Polygon]
    rule: str
    weld: Fraction | None = None
    expected: set[str] = field(default_factory=set)
    is_open: set[tuple[int, int]] = field(default_factory=set)

    def text(self, form: str) -> str:
        return WRITERS[form](self)


def valid(dice: random.Random) -> list[Polygon]:
    """Draw one to three polygons side by side, a third with a hole."""
    polygons = []
    for k in range(dice.randint(1, 3)):
        middle = (Fraction(40 * k), Fraction(dice.randint(-9, 9), 2))
        rings = [_star(dice, middle, 8, 16)]
        if dice.random() < 0.4:
            rings.append(_star(dice, middle, 2, 4)[::-1])
        polygons.append(rings)
    return polygons


def _star(dice: random.Random, middle: Point, least: int, most: int) -> Ring:
    """A ring around a point, counter-clockwise, by directions that ascend."""
    ways = [(4, 1), (3, 3), (1, 4), (-1, 4), (-3, 3), (-4, 1), (-4, -1), (-3, -3), (1, -4), (3, -3)]
    first = dice.randint(0, 1)
    kept = [way for k, way in enumerate(ways) if k % 2 == first or dice.random() < 0.7]
    reach = [Fraction(dice.randint(least * 7, most * 7), 35) for _ in kept]
    return [(middle[0] + r * x, middle[1] + r * y) for r, (x, y) in zip(reach, kept, strict=True)]


def damaged(index: int) -> Damaged:
    """Set number `index`: each kind in turn, every third with a second kind."""
    kinds = list(KINDS)
    dice = random.Random(f"minkref repairs {SEED} {index}")
    kind = kinds[index % len(kinds)]
    found = Damaged("", valid(dice), RULES[index // len(kinds) % 3])
    names = [kind]
    KINDS[kind](dice, found)
    if index % 3 == 2:
        other = dice.choice([name for name in kinds if name not in ALONE and name != kind])
        if kind not in ALONE:
            names.append(other)
            KINDS[other](dice, found)
    found.name = f"{index} {' and '.join(names)}, {found.rule}"
    return found


def _outer(dice: random.Random, found: Damaged) -> Ring:
    return dice.choice(_with_area(found))[0]


def _with_area(found: Damaged) -> list[Polygon]:
    """Leave out the polygons that a damage made flat."""
    return [polygon for polygon in found.polygons if doubled_area(polygon[0])]


def _open(dice: random.Random, found: Damaged) -> None:
    found.is_open.add((dice.randrange(len(found.polygons)), 0))
    found.expected.add("closed")


def _repeat(dice: random.Random, found: Damaged) -> None:
    ring = _outer(dice, found)
    at = dice.randrange(len(ring))
    ring[at:at] = [ring[at]] * dice.randint(1, 3)
    found.expected.add("repeated-point")


def _spike(dice: random.Random, found: Damaged) -> None:
    """Out and back from a corner, perhaps in two steps."""
    ring = _outer(dice, found)
    at = dice.randrange(len(ring))
    x, y = ring[at]
    tip = (x + dice.randint(1, 30), y + Fraction(dice.randint(-40, 40), 3))
    path = [tip] if dice.random() < 0.5 else [tip, (tip[0] + 1, tip[1] + 5), tip]
    ring[at : at + 1] = [ring[at], *path, ring[at]]
    found.expected.add("spike")


def _few(dice: random.Random, found: Damaged) -> None:
    points = [(Fraction(k), Fraction(-90)) for k in range(dice.randint(1, 2))]
    found.polygons.append([points])
    found.expected.add("no-area")


def _flat(dice: random.Random, found: Damaged) -> None:
    xs = [dice.randint(-9, 9) for _ in range(dice.randint(3, 6))]
    found.polygons.append([[(Fraction(x), Fraction(x, 3) - 70) for x in xs]])
    found.expected.add("no-area")


def _box(x: Fraction, y: Fraction, width: int, height: int) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def _abut(dice: random.Random, found: Damaged) -> None:
    y = Fraction(dice.randint(60, 70))
    found.polygons += [
        [_box(Fraction(0), y, 4, 6)],
        [_box(Fraction(4), y + 1, 5, dice.randint(2, 9))],
    ]
    found.expected.add("polygons-abut")


def _overlap(dice: random.Random, found: Damaged) -> None:
    x, y = _outer(dice, found)[0]
    found.polygons.append([_star(dice, (x, y), 1, 3)])
    found.expected.add("polygons-overlap")


def _copy(dice: random.Random, found: Damaged) -> None:
    found.polygons.append([list(ring) for ring in dice.choice(_with_area(found))])
    found.expected.add("polygons-overlap")


def _touch(dice: random.Random, found: Damaged) -> None:
    """Add a ring with two lobes meeting at a corner."""
    x, y = Fraction(dice.randint(-9, 9)), Fraction(120)
    steps = [(0, 0), (4, 0), (4, 3), (0, 0), (-2, 5), (-4, 1)]
    found.polygons.append([[(x + a, y + b) for a, b in steps]])
    found.expected.add("self-touching")


def _cross(dice: random.Random, found: Damaged) -> None:
    """A bow tie, a pentagram, or a ring around twice."""
    x, y = Fraction(dice.randint(-9, 9)), Fraction(160)
    steps = dice.choice(
        [
            [(0, 0), (8, 0), (2, 6), (6, 7)],
            [(0, 10), (6, -8), (-9, 3), (9, 3), (-6, -8)],
            [(0, 0), (9, 0), (9, 9), (0, 9), (1, 1), (5, 1), (5, 5), (1, 6)],
        ]
    )
    found.polygons.append([[(x + a, y + b) for a, b in steps]])
    found.expected.add("self-crossing")


def _turn(dice: random.Random, found: Damaged) -> None:
    dice.choice(dice.choice(found.polygons)).reverse()
    found.expected.add("turned")


def _hole_outside(dice: random.Random, found: Damaged) -> None:
    found.polygons[0].append(_star(dice, (Fraction(-90), Fraction(0)), 1, 3)[::-1])
    found.expected.add("hole-outside")


def _hole_across(dice: random.Random, found: Damaged) -> None:
    polygon = dice.choice(_with_area(found))
    polygon.append(_star(dice, dice.choice(polygon[0]), 1, 2)[::-1])
    found.expected.add("hole-outside")


def _holes(dice: random.Random, found: Damaged) -> None:
    found.polygons.append(
        [
            _box(Fraction(0), Fraction(-160), 20, 20),
            _box(Fraction(2), Fraction(-158), 8, 8)[::-1],
            _box(Fraction(7), Fraction(-155), dice.randint(4, 9), 3)[::-1],
        ]
    )
    found.expected.add("holes-overlap")


def _edge(dice: random.Random, found: Damaged) -> None:
    found.polygons.append(
        [
            _box(Fraction(0), Fraction(-220), 20, 20),
            _box(Fraction(dice.choice([0, 12])), Fraction(-215), 8, 8)[::-1],
        ]
    )
    found.expected.add("shared-edge")


def _near(dice: random.Random, found: Damaged) -> None:
    ring = _outer(dice, found)
    at = dice.randrange(len(ring))
    x, y = ring[at]
    ring[at : at + 1] = [(x, y), (x + Fraction(dice.randint(1, 6), 10_000), y + WELD / 3)]
    found.weld = WELD
    found.expected.add("welded")


KINDS: dict[str, Callable[[random.Random, Damaged], None]] = {
    "an open ring": _open,
    "a repeated point": _repeat,
    "a spike": _spike,
    "too few points": _few,
    "a flat ring": _flat,
    "polygons that abut": _abut,
    "polygons that overlap": _overlap,
    "a polygon twice": _copy,
    "a ring that touches itself": _touch,
    "a ring that crosses itself": _cross,
    "a ring the wrong way round": _turn,
    "a hole outside": _hole_outside,
    "a hole across the boundary": _hole_across,
    "holes that overlap": _holes,
    "a hole along an edge": _edge,
    "vertices too near": _near,
}
ALONE = ("an open ring", "vertices too near", "a ring the wrong way round")


def _wkt(found: Damaged) -> str:
    polygons = []
    for k, polygon in enumerate(found.polygons):
        rings = []
        for r, ring in enumerate(polygon):
            points = [*ring, *([] if (k, r) in found.is_open else ring[:1])]
            rings.append(f"({', '.join(f'{x} {y}' for x, y in points)})")
        polygons.append(f"({', '.join(rings)})")
    return f"MULTIPOLYGON ({', '.join(polygons)})\n"


def _json(found: Damaged) -> str:
    rings = [
        [[[str(x), str(y)] for x, y in ring] for ring in polygon] for polygon in found.polygons
    ]
    return json.dumps({"polygons": [{"outer": each[0], "holes": each[1:]} for each in rings]})


WRITERS: dict[str, Callable[[Damaged], str]] = {"wkt": _wkt, "json": _json}
