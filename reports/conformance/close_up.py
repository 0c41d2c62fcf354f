"""Windows for a closer look at a difference: at parts drawn too small to see."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from minkref.plane.exact_frame import Exact, ExactBox, ExactPolygons, box_of

SEEN = Fraction(1, 8)  # of the picture's longer side: parts smaller both ways get a close-up
THIN = Fraction(1, 60)  # of the same side: thinner parts do too
AROUND = 4  # thicknesses shown on each side, at most

ExactPolygon = list[list[Exact]]


def close_up(difference: ExactPolygons, whole: ExactBox, witness: Exact | None) -> ExactBox | None:
    """A window around the part with the witness, else around the largest part; for a long part,
    around one place of it. None if the whole picture shows the part well."""
    if not difference:
        return None
    polygon, place = _part(difference, witness)
    box = box_of([polygon])
    assert box is not None
    across, up = (_span(polygon, place, k) for k in (0, 1))
    longest, thick = max(_sides(box)), min(across, up)
    side = max(_sides(whole))
    if not thick or (longest >= SEEN * side and thick >= THIN * side):
        return None
    if longest <= 2 * AROUND * thick:
        half, place = longest * Fraction(3, 4), ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    else:
        half = AROUND * thick
    return (place[0] - half, place[1] - half, place[0] + half, place[1] + half)


def clipped(polygons: ExactPolygons, window: ExactBox) -> ExactPolygons:
    """The polygons within a window enlarged by half on each side, so that the cuts stay hidden.
    Rings may run along the window's border more than once: for drawing only."""
    half = [(window[k + 2] - window[k]) / 2 for k in (0, 1)]
    found = []
    for polygon in polygons:
        rings = []
        for ring in polygon:
            kept = ring
            for k in (0, 1):
                kept = _cut(kept, k, window[k] - half[k], 1)
                kept = _cut(kept, k, window[k + 2] + half[k], -1)
            if kept:
                rings.append(kept)
        if rings:
            found.append(rings)
    return found


def _cut(ring: list[Exact], k: int, bound: Fraction, sign: int) -> list[Exact]:
    """The ring clipped to the half plane where sign times coordinate k is at least sign times the
    bound."""
    kept: list[Exact] = []
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        da, db = sign * (a[k] - bound), sign * (b[k] - bound)
        if da >= 0:
            kept.append(a)
        if (da < 0 < db) or (db < 0 < da):
            part = da / (da - db)
            kept.append((a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])))
    return kept


def _part(difference: ExactPolygons, witness: Exact | None) -> tuple[ExactPolygon, Exact]:
    """A polygon and a place inside it."""
    if witness is not None:
        for polygon in difference:
            if _span(polygon, witness, 0) and _span(polygon, witness, 1):
                return polygon, witness
    largest = max(difference, key=lambda polygon: max(_sides(_box(polygon))))
    box = _box(largest)
    k = 0 if box[3] - box[1] > box[2] - box[0] else 1  # the axis of the cut
    level = (box[1 - k] + box[3 - k]) / 2
    low, high = max(_pieces(largest, level, k), key=lambda piece: piece[1] - piece[0])
    middle = (low + high) / 2
    return largest, (middle, level) if k == 0 else (level, middle)


def _span(polygon: ExactPolygon, place: Exact, k: int) -> Fraction:
    """The length of the piece with the place on the line through it along axis k; 0 outside."""
    for low, high in _pieces(polygon, place[1 - k], k):
        if low <= place[k] <= high:
            return high - low
    return Fraction(0)


def _pieces(polygon: ExactPolygon, level: Fraction, k: int) -> list[tuple[Fraction, Fraction]]:
    """The pieces inside the polygon of the line along axis k at this level."""
    met = []
    for ring in polygon:
        for a, b in pairwise([*ring, ring[0]]):
            if (a[1 - k] > level) != (b[1 - k] > level):
                part = (level - a[1 - k]) / (b[1 - k] - a[1 - k])
                met.append(a[k] + part * (b[k] - a[k]))
    met.sort()
    return list(zip(met[::2], met[1::2], strict=True))


def _box(polygon: ExactPolygon) -> ExactBox:
    box = box_of([polygon])
    assert box is not None
    return box


def _sides(box: ExactBox) -> tuple[Fraction, Fraction]:
    return box[2] - box[0], box[3] - box[1]
