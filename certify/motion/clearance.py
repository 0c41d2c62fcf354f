"""Codes that hold a part and obstacles apart along a segment at all scales of a range
(docs/certificates-paths.md)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.certify.motion.moving_parts import Corner, Pair, Way, cut
from minkref.certify.motion.scale_cells import left_of
from minkref.certify.plane.piece_nodes import Vector
from minkref.motion.scale_ranges import ScaleRange

SPLIT_R, SPLIT_O, HALVE = -1, -2, -3
RECENT = 6
MOST_ENTRIES = 2_000_000  # per code


class Collision(Exception):
    """Some place on the segment collides at some scale."""


class TooLong(Exception):
    """The code would have too many entries."""


class Clearance:
    """Codes for several segments over one list of normals. Exact."""

    def __init__(self, pair: Pair, scales: ScaleRange, contact: str) -> None:
        self.pair, self.scales, self.contact = pair, scales, contact
        self.normals: list[Vector] = []
        self._numbers: dict[Vector, int] = {}
        self._recent: list[Vector] = []
        low, high = scales.low, scales.high
        self._middle = low + 1 if high is None else (low + high) / 2

    def code(self, way: Way) -> list[int]:
        """Returns the code; raises Collision if there is none. The cost grows with the pairs of
        pieces near each other."""
        part, walls = self.pair.R, self.pair.O
        found: list[int] = []
        empty = not (part.hulls and walls.hulls)
        stack = [] if empty else [(way.cell(self.scales), part.root, walls.root)]
        while stack:
            if len(found) > MOST_ENTRIES:
                raise TooLong
            corners, A, B = stack.pop()
            normal = self._separating(way, corners, A, B)
            if normal is not None:
                found.append(self._number(normal))
                continue
            of_R, of_O = part.children[A], walls.children[B]
            if not of_R and not of_O:
                found += map(self._number, self._cuts(way, corners, A, B))
                continue
            sizes = (
                self._middle * part.extents[A] if of_R else -1,
                walls.extents[B] if of_O else -1,
                way.length * _width(corners),
            )
            if sizes[2] > 2 * max(sizes[:2]):
                found.append(HALVE)
                upper, lower = halves(corners)
                stack += [(upper, A, B), (lower, A, B)]
            elif sizes[0] >= sizes[1]:
                found.append(SPLIT_R)
                stack += [(corners, child, B) for child in reversed(of_R)]
            else:
                found.append(SPLIT_O)
                stack += [(corners, A, child) for child in reversed(of_O)]
        return found

    def _left(
        self, way: Way, corners: Sequence[Corner], normal: Vector, A: int, B: int
    ) -> list[Corner]:
        return left_of(corners, way.gap(normal, A, B), self.scales, self.contact)

    def _separating(self, way: Way, corners: Sequence[Corner], A: int, B: int) -> Vector | None:
        tried = dict.fromkeys((*self._recent, *way.across, *self.pair.directions(A, B)))
        for normal in tried:
            if not self._left(way, corners, normal, A, B):
                if normal in self._recent:
                    self._recent.remove(normal)
                self._recent = [normal, *self._recent][:RECENT]
                return normal
        return None

    def _cuts(self, way: Way, corners: list[Corner], A: int, B: int) -> list[Vector]:
        """Normals that together take away the cell for two pieces: each time the normal that
        leaves least."""
        cuts: list[Vector] = []
        normals = self.pair.directions(A, B)
        while corners:
            rests = [(self._left(way, corners, normal, A, B), normal) for normal in normals]
            rest, normal = min(rests, key=lambda one: _size(one[0]))
            if rest == corners:
                rest, normal = next((one for one in rests if one[0] != corners), (corners, normal))
            if rest == corners:
                raise Collision
            cuts.append(normal)
            corners = rest
            normals.remove(normal)
        return cuts

    def _number(self, normal: Vector) -> int:
        if normal not in self._numbers:
            self._numbers[normal] = len(self.normals)
            self.normals.append(normal)
        return self._numbers[normal]


def halves(corners: Sequence[Corner]) -> tuple[list[Corner], list[Corner]]:
    """Cuts a cell in the middle of its places: the later half, the earlier half."""
    at = [Fraction(t, w) for t, _, w in corners if w]
    u, v = ((min(at) + max(at)) / 2).as_integer_ratio()
    return cut(corners, (-v, 0, u)), cut(corners, (v, 0, -u))


def _width(corners: Sequence[Corner]) -> Fraction:
    at = [Fraction(t, w) for t, _, w in corners if w]
    return max(at) - min(at)


def _size(corners: Sequence[Corner]) -> tuple[Fraction, Fraction]:
    """Area and sides of a cell's box in t and s / (1 + s); estimates how much remains."""
    if not corners:
        return Fraction(-1), Fraction(-1)
    scales = [Fraction(s, s + w) for _, s, w in corners]
    width, height = _width(corners), max(scales) - min(scales)
    return width * height, width + height
