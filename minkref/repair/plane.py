"""Repair of a set in the plane: rings, then polygons, then the polygons together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.errors import Refusal
from minkref.repair.change import Change
from minkref.repair.groups import Groups
from minkref.repair.regions import Region, Rings, combined, fault, filled, near_pairs, shared_area
from minkref.repair.rings import Note, Point, Ring, cleaned, doubled_area, run_as
from minkref.repair.weld import squared_distance, welded

MOST_ROUNDS = 50  # welding moves edges, which may then cross; each round has fewer vertices


@dataclass(frozen=True)
class Piece:
    """The set of a polygon. `ring`: number of the outer ring in the file."""

    region: Region
    ring: int | None


def repaired(
    read: _core.PolygonSet, is_open: Sequence[int], rule: str, weld: Fraction | None
) -> tuple[_core.PolygonSet, list[Change]]:
    """Repair a set as read, and list the changes in order. `is_open`: 1 for each open ring, if
    known. A polygon means everything that the outer ring encloses by the rule, minus everything
    that holes enclose; the set means the union. Polygons without faults keep their rings. Exact.
    Refuses endless welding."""
    changes: list[Change] = []
    polygons = _as_read(read, is_open)
    for _ in range(MOST_ROUNDS):
        before = len(changes)
        if weld is not None:
            polygons = _welded(polygons, weld, changes.append)
        found = _mended(polygons, rule, changes.append)
        if weld is None or len(changes) == before:
            return found, changes
        polygons = [[Ring(None, points) for points in rings] for rings in found.rings()]
    what = f"after {MOST_ROUNDS} rounds vertices are still nearer than {weld}"
    raise Refusal(what, "--weld", "take another distance", "weld-without-end")


def _as_read(read: _core.PolygonSet, is_open: Sequence[int]) -> list[list[Ring]]:
    places = read.written_rings
    polygons, count = [], 0
    for rings in read.rings():
        polygon = []
        for points in rings:
            number, lines = places[count] if places else (count, [])
            polygon.append(Ring(number, points, bool(is_open and is_open[count]), lines))
            count += 1
        polygons.append(polygon)
    return polygons


def _welded(polygons: list[list[Ring]], weld: Fraction, note: Note) -> list[list[Ring]]:
    rings = sorted(
        (ring for polygon in polygons for ring in polygon),
        key=lambda ring: -1 if ring.number is None else ring.number,
    )
    moves = welded((point for ring in rings for point in ring.points), weld)
    if not moves:
        return polygons
    for ring in rings:
        for k, point in enumerate(ring.points):
            if (to := moves.get(point)) is not None:
                apart = squared_distance(point, to)
                note(
                    ring.change(
                        "welded", ring.indices[k], point=point, to=to, squared_distance=apart
                    )
                )
                ring.points[k] = (to[0], to[1])
    return polygons


def _mended(polygons: list[list[Ring]], rule: str, note: Note) -> _core.PolygonSet:
    kept: list[list[Ring]] = []
    for polygon in polygons:
        clean = [cleaned(ring, note) for ring in polygon]
        if clean and clean[0] is not None:
            kept.append([run_as(r, k > 0, note) for k, r in enumerate(clean) if r is not None])
        else:
            for ring in clean:
                if ring is not None:  # a hole of nothing
                    area = abs(filled(ring.points, rule)[0].area)
                    note(ring.change("hole-outside", area=area))
    written = [[ring.points for ring in polygon] for polygon in kept]
    if fault(written) is None:
        return Region(written).set
    pieces = [piece for polygon in kept if (piece := _piece(polygon, rule, note)) is not None]
    return _united(pieces, note)


def _piece(polygon: list[Ring], rule: str, note: Note) -> Piece | None:
    """The set of a polygon; None for an empty set."""
    written: Rings = [ring.points for ring in polygon]
    if fault([written]) is None:
        return Piece(Region([written]), polygon[0].number)
    regions = [_enclosed(ring, rule, note) for ring in polygon]
    outer = regions[0]
    if not outer.polygons:
        return None
    holes = [(r, h) for r, h in zip(polygon[1:], regions[1:], strict=True) if h.polygons]
    _tell_holes(polygon[0], outer, holes, note)
    if holes:
        outer = combined("difference", [outer, *(hole for _, hole in holes)])
    if outer.polygons:
        return Piece(outer, polygon[0].number)
    note(polygon[0].change("no-area", area=Fraction(0)))
    return None


def _enclosed(ring: Ring, rule: str, note: Note) -> Region:
    """The set that a ring encloses."""
    is_reversed = doubled_area(ring.points) < 0
    points = ring.points[::-1] if is_reversed else ring.points
    found = fault([[points]])
    if found is None:
        return Region([[points]])
    region, is_touching = filled(points, rule)
    at = found.vertices[0] if found.vertices else 0
    if not region.polygons:
        note(ring.change("no-area", point=points[at], area=Fraction(0)))
        return region
    indices = ring.indices[::-1] if is_reversed else ring.indices
    kind = "self-touching" if is_touching else "self-crossing"
    note(ring.change(kind, indices[at], point=_meeting(points, found.vertices), area=region.area))
    return region


def _meeting(points: Sequence[Point], vertices: Sequence[int]) -> Point:
    """Return the point at which two edges, by their four ends, meet; the first one of a stretch."""
    if len(vertices) < 4:
        return points[vertices[0] if vertices else 0]
    a, b, c, d = (points[vertex] for vertex in vertices)
    along, other = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    turn = along[0] * other[1] - along[1] * other[0]
    if turn == 0:
        return max(min(a, b), min(c, d))
    t = ((c[0] - a[0]) * other[1] - (c[1] - a[1]) * other[0]) / turn
    return a[0] + t * along[0], a[1] + t * along[1]


def _tell_holes(
    ring: Ring, outer: Region, holes: Sequence[tuple[Ring, Region]], note: Note
) -> None:
    """Note how holes leave their outer ring and meet each other."""
    for hole, region in holes:
        outside = combined("difference", [region, outer])
        if outside.polygons:
            note(hole.change("hole-outside", area=outside.area))
        elif _share_edge(outer, region):
            note(_between("shared-edge", hole, ring, Fraction(0)))
    for i, j in near_pairs([region.box for _, region in holes]):
        (first, a), (second, b) = holes[i], holes[j]
        if (area := shared_area(a, b)) > 0:
            note(_between("holes-overlap", second, first, area))
        elif fault([*a.polygons, *b.polygons]) is not None:
            note(_between("shared-edge", second, first, area))


def _between(kind: str, ring: Ring, other: Ring, area: Fraction) -> Change:
    return ring.change(kind, other_ring=other.number, area=area)


def _share_edge(outer: Region, hole: Region) -> bool:
    """Tell whether a region within another shares an edge with it: that fault comes first."""
    found = fault([*outer.polygons, *hole.polygons])
    return found is not None and found.code == "overlapping-rings"


def _united(pieces: list[Piece], note: Note) -> _core.PolygonSet:
    """Unite pieces that overlap or share edges; keep all others."""
    if fault([rings for piece in pieces for rings in piece.region.polygons]) is None:
        return Region([rings for piece in pieces for rings in piece.region.polygons]).set
    groups = Groups(len(pieces))
    for i, j in near_pairs([piece.region.box for piece in pieces]):
        a, b = pieces[i], pieces[j]
        if fault([*a.region.polygons, *b.region.polygons]) is None:
            continue
        area = shared_area(a.region, b.region)
        kind = "polygons-overlap" if area > 0 else "polygons-abut"
        note(Change(kind, ring=b.ring, other_ring=a.ring, area=area))
        groups.join(i, j)
    together: dict[int, list[Region]] = {}
    for k, piece in enumerate(pieces):
        together.setdefault(groups.root(k), []).append(piece.region)
    found = [r[0] if len(r) == 1 else combined("union", r) for r in together.values()]
    return Region([rings for region in found for rings in region.polygons]).set
