"""Random places in rooms whose doors just shut: doors as wide as the part at one scale, several at
a time, necks, keyholes, bends, spikes; turned by rational rotations."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref.api import BadInput, PolygonSet
from minkref.fuzz.geometry.plane import fraction_rings
from minkref.fuzz.plane.families.small_operands import as_set, random_rings

Place = tuple[Fraction, Fraction]
Ring = Sequence[tuple[Fraction | int, Fraction | int]]
SIZE = 4
SCALES = tuple(map(Fraction, ("1", "2", "1/2", "3/4", "5/3", "7/5")))
TURNS = tuple(
    (Fraction(a, c), Fraction(b, c))
    for a, b, c in ((1, 0, 1), (3, 4, 5), (-5, 12, 13), (15, -8, 17))
)


@dataclass(frozen=True)
class TrapCase:
    """A part, obstacles that may hold it, and the place of the part's origin."""

    name: str
    part: PolygonSet
    obstacles: PolygonSet
    at: Place
    kind: str


@dataclass(frozen=True)
class Room:
    """A square of side `size` with walls `thick`, and doors as wide and as high as the part at one
    scale."""

    dice: random.Random
    size: Fraction
    thick: Fraction
    wide: Fraction
    high: Fraction

    def sill(self, door: Fraction) -> Fraction:
        """Where along a side a door begins."""
        return (self.size - door) * Fraction(self.dice.randint(0, 4), 4)

    def block(self, door: Ring) -> list[Ring]:
        """The room in a block, with its way out to the right through a door, given as an outline
        from the inner lower end to the outer lower end, and from the outer upper end back."""
        half = len(door) // 2
        s, t = self.size, self.thick
        x = max(px for px, _ in door)
        lower, upper = list(door[:half]), list(door[half:])
        return [
            [(-t, -t), (x, -t), *lower[::-1], (s, 0), (0, 0), (0, s), (s, s), *upper[::-1],
             (x, s + t), (-t, s + t)]
        ]  # fmt: skip


def _door(room: Room) -> list[Ring]:
    s, x, d = room.size, room.size + room.thick, room.high
    c = room.sill(d)
    return room.block([(s, c), (x, c), (x, c + d), (s, c + d)])


def _neck(room: Room) -> list[Ring]:
    """A long one."""
    s, d = room.size, room.high
    x, c = s + room.dice.randint(2, 5) * room.size, room.sill(room.high)
    return room.block([(s, c), (x, c), (x, c + d), (s, c + d)])


def _taper(room: Room) -> list[Ring]:
    """A door as wide as the part at one end, wider at the other."""
    s, x, d = room.size, room.size + room.thick, room.high
    c, more = room.sill(d), room.thick / room.dice.randint(2, 5)
    if room.dice.random() < 0.5:
        return room.block([(s, c), (x, c - more), (x, c + d + more), (s, c + d)])
    return room.block([(s, c), (x, c), (x, c + d), (s, c + d + min(more, s - c - d))])


def _keyhole(room: Room) -> list[Ring]:
    """A room with its corners cut off, and a slot."""
    s, t, d = room.size, room.thick, room.high
    x, cut = s + room.dice.randint(1, 3) * s, s / room.dice.randint(3, 5)
    c = (s - d) / 2
    inner: Ring = [(s - cut, 0), (cut, 0), (0, cut), (0, s - cut), (cut, s), (s - cut, s)]
    low, high = min(c, cut), max(c + d, s - cut)
    return [
        [(-t, -t), (x, -t), (x, c), (s, c), (s, low), *inner, (s, high), (s, c + d), (x, c + d),
         (x, s + t), (-t, s + t)]
    ]  # fmt: skip


def _bend(room: Room) -> list[Ring]:
    """To the right, and then up."""
    s, t, d, e = room.size, room.thick, room.high, room.wide
    c, a = room.sill(d), room.dice.randint(1, 3) * t
    x, y = s + a + e, s + t
    return [
        [(-t, -t), (x + t, -t), (x + t, y), (x, y), (x, c), (s, c), (s, 0), (0, 0), (0, s), (s, s),
         (s, c + d), (s + a, c + d), (s + a, y), (-t, y)]
    ]  # fmt: skip


def _spikes(room: Room) -> list[Ring]:
    """A door between two corners, not opposite to each other."""
    s, x, d = room.size, room.size + room.thick, room.high
    c = room.sill(d)
    aside = room.thick * Fraction(room.dice.randint(0, 4), 4)
    low, high = min(c, Fraction(1)), min(s - c - d, Fraction(1))
    return room.block(
        [(s, c - low), (s + aside, c), (x, c - 1), (x, c + d + 1), (x - aside, c + d),
         (s, c + d + high)]
    )  # fmt: skip


def _doors(room: Room) -> list[Ring]:
    """Several doors that shut at one scale, each in a different side."""
    return _walls(room, room.dice.sample(range(4), room.dice.randint(2, 4)), ())


def _touching(room: Room) -> list[Ring]:
    """A door, and walls that touch in a corner on another side."""
    first, second = room.dice.sample(range(4), 2)
    return _walls(room, (first,), (second,))


def _walls(room: Room, doors: Sequence[int], spikes: Sequence[int]) -> list[Ring]:
    """Walls around a room, side by side, counter-clockwise from the right one, with doors, and with
    two corners that touch where a door has no width."""
    s, t = room.size, room.thick
    turns = ((1, 0), (0, 1), (-1, 0), (0, -1))
    rings: list[list[Place]] = []
    inner: list[Place] = []  # the current wall's corners
    outer: list[Place] = []
    first: tuple[list[Place], list[Place]] | None = None
    for side, (u, v) in enumerate(turns):

        def put(out: Fraction | int, along: Fraction, u: int = u, v: int = v) -> Place:
            x, y = s / 2 + out, along - s / 2
            return s / 2 + u * x - v * y, s / 2 + v * x + u * y

        if side in doors or side in spikes:
            width = (room.high if u else room.wide) if side in doors else Fraction(0)
            c = room.sill(width) if width else s / 2
            shut = c + width
            ends = [[put(0, c), put(t, c)], [put(t, shut), put(0, shut)]]
            if not width:
                tip, aside = put(t / 2, c), s / 4
                ends[0] = [put(0, c - aside), tip, put(t, c - aside)]
                ends[1] = [put(t, c + aside), tip, put(0, c + aside)]
            if first is None:
                first = [*inner, *ends[0]], outer
            else:
                rings.append([*outer, *ends[0][::-1], *inner[::-1]])
            outer, inner = ends[1][:1], ends[1][1:]
        outer.append(put(t, s + t))
        inner.append(put(0, s))
    assert first is not None
    rings.append([*outer, *first[1], *first[0][::-1], *inner[::-1]])
    return list(rings)


KINDS: dict[str, Callable[[Room], list[Ring]]] = {
    "door": _door, "neck": _neck, "taper": _taper, "keyhole": _keyhole, "bend": _bend,
    "spikes": _spikes, "doors": _doors, "touching corners": _touching,
}  # fmt: skip


def trap_case(seed: int, index: int) -> TrapCase:
    """Draws equal cases for equal numbers; one kind after another."""
    name = f"trap {seed}:{index}"
    dice = random.Random(name)
    kind = list(KINDS)[index % len(KINDS)]
    while True:
        try:
            return _drawn(dice, name, kind)
        except BadInput:
            continue


def _drawn(dice: random.Random, name: str, kind: str) -> TrapCase:
    if dice.random() < 0.15:
        part = PolygonSet([(0, 0), (dice.randint(1, SIZE), dice.randint(-SIZE, SIZE))])
    else:
        part = as_set(random_rings(dice, SIZE)[:1])
    part.validate("a drawn part")
    xs, ys = zip(*_points(part), strict=True)
    x, y = (-Fraction(min(cs) + max(cs), 2) for cs in (xs, ys))
    scale = dice.choice(SCALES)
    if dice.random() < 0.5:  # the origin lies off the middle, perhaps outside
        x, y = x + dice.randint(-2, 2), y + dice.randint(-2, 2)
    wide, high = (scale * max(max(cs) - min(cs), 1) for cs in (xs, ys))
    size = max(wide, high) * Fraction(dice.randint(5, 12), 4)
    room = Room(dice, size, Fraction(dice.randint(1, 3)), wide, high)
    rings = KINDS[kind](room)
    at = tuple(size * Fraction(dice.randint(3, 9), 12) for _ in range(2))
    turn, (u, v) = dice.choice(TURNS), (Fraction(dice.randint(-9, 9)) for _ in range(2))
    placed = [[(p[0] + u, p[1] + v) for p in _turned(ring, turn)] for ring in rings]
    obstacles = PolygonSet([[_texts(_once(ring))] for ring in placed])
    obstacles.validate("drawn walls")
    moved = part.translated(str(x), str(y))
    ring = _turned(_points(moved), turn)
    turned_part = PolygonSet([[_texts(ring)]]) if part.is_region else PolygonSet(_texts(ring))
    turned_part.validate("a drawn part")
    (place,) = _turned([(at[0], at[1])], turn)
    return TrapCase(name, turned_part, obstacles, (place[0] + u, place[1] + v), kind)


def _once(ring: list[Place]) -> list[Place]:
    """Drops vertices equal to the vertex before."""
    return [p for k, p in enumerate(ring) if p != ring[k - 1]]


def _turned(ring: Ring, turn: Place) -> list[Place]:
    c, s = turn
    return [(c * x - s * y, s * x + c * y) for x, y in ring]


def _points(shape: PolygonSet) -> list[Place]:
    return [p for ring in fraction_rings(shape.to_json()) for p in ring]


def _texts(ring: Ring) -> list[tuple[str, str]]:
    return [(str(x), str(y)) for x, y in ring]
