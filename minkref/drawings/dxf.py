"""DXF: closed polylines, circles, and lines and arcs that close, as rings."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from minkref.drawings.chains import rings_of
from minkref.drawings.curves import Point, TooFine, arc_by_angles, arc_by_bulge, circle
from minkref.drawings.dxf_tags import Entity, sections
from minkref.drawings.nesting import nested
from minkref.drawings.reading import Reading

UNITS = {
    1: "inches", 2: "feet", 3: "miles", 4: "millimetres", 5: "centimetres", 6: "metres",
    7: "kilometres", 8: "microinches", 9: "mils", 10: "yards", 11: "angstroms", 12: "nanometres",
    13: "micrometres", 14: "decimetres",
}  # fmt: skip
#: Entities that say something about a drawing, and bound nothing.
TEXTS = frozenset({
    "TEXT", "MTEXT", "DIMENSION", "LEADER", "MULTILEADER", "POINT", "ATTDEF", "ATTRIB", "VIEWPORT",
    "ACAD_TABLE", "TOLERANCE", "XLINE", "RAY", "IMAGE", "WIPEOUT",
})  # fmt: skip
LINES = ("LWPOLYLINE", "POLYLINE", "LINE", "CIRCLE", "ARC")
CLOSED, IN_SPACE = 1, 8 | 16 | 64
Corner = tuple[Fraction, Fraction, Fraction]  # x, y, and the bulge towards the next one


def read_dxf(data: bytes, reading: Reading) -> list[list[list[Point]]]:
    """Return the polygons of the model space. Refuses other geometry, open chains."""
    found = sections(data, reading)
    _tell_units(found.get("HEADER", []), reading)
    rings: list[list[Point]] = []
    chains: list[list[Point]] = []
    for entity, vertices in _entities(found["ENTITIES"]):
        if entity.flags(67):
            reading.left_out["entities of the paper space"] += 1
        elif entity.kind in TEXTS:
            reading.left_out[entity.kind] += 1
        elif entity.kind not in LINES:
            raise reading.refusal(
                f"{entity.kind} is not read",
                "explode it, or convert it to polylines, in the program that drew it",
                "unsupported-geometry",
                f"line {entity.line}",
            )
        elif reading.takes(entity.first(8, "0")):
            try:
                is_closed, points = _DrawnEntity(entity, vertices, reading).points()
            except TooFine as error:
                raise reading.too_fine(error, f"line {entity.line}") from error
            (rings if is_closed else chains).append(points)
    reading.check_layer()
    rings += rings_of([chain for chain in chains if len(chain) > 1], reading)
    return nested([ring for ring in rings if ring])


def _tell_units(header: list[Entity], reading: Reading) -> None:
    for variable in header:
        if variable.kind == "$INSUNITS" and (unit := UNITS.get(variable.flags(70))):
            reading.note(f"the unit is {unit} ($INSUNITS): numbers are kept as they are")


def _entities(every: list[Entity]) -> Iterator[tuple[Entity, list[Entity]]]:
    """Yield entities with the VERTEX entities that follow a POLYLINE."""
    k = 0
    while k < len(every):
        entity, vertices = every[k], []
        k += 1
        if entity.kind == "POLYLINE":
            while k < len(every) and every[k].kind == "VERTEX":
                vertices.append(every[k])
                k += 1
        if entity.kind not in ("SEQEND", "VERTEX"):
            yield entity, vertices


class _DrawnEntity:
    def __init__(self, entity: Entity, vertices: list[Entity], reading: Reading) -> None:
        self._entity, self._vertices, self._reading = entity, vertices, reading
        self._is_mirrored = self._mirrored()

    def _refusal(self, what: str, mend: str, code: str) -> Exception:
        return self._reading.refusal(what, mend, code, f"line {self._entity.line}")

    def _number(self, code: int, default: str = "") -> Fraction:
        text = self._entity.first(code, default)
        if not text:
            what = f"{self._entity.kind} has no group {code}"
            raise self._refusal(what, "give a complete entity", "missing-member")
        return self._reading.number(text)

    def _mirrored(self) -> bool:
        """Tell whether the entity is seen from below. Refuses other planes."""
        x, y, z = self._number(210, "0"), self._number(220, "0"), self._number(230, "1")
        if x or y or not z:
            raise self._refusal(
                f"{self._entity.kind} lies in a plane that is not x, y",
                "flatten the drawing", "three-dimensional",
            )  # fmt: skip
        return z < 0 and self._entity.kind != "LINE"

    def points(self) -> tuple[bool, list[Point]]:
        """Return whether the entity closes, and its points."""
        kind = self._entity.kind
        if any(self._reading.number(z) for code in (30, 31, 38) for z in self._entity.all(code)):
            self._reading.note("dropped: heights (z)")
        if kind == "LINE":
            points = [(self._number(10), self._number(20)), (self._number(11), self._number(21))]
            is_closed = False
        elif kind in ("CIRCLE", "ARC"):
            is_closed, points = self._round(kind == "CIRCLE")
        else:
            is_closed, points = self._polyline(self._corners())
        return is_closed, [(-x, y) for x, y in points] if self._is_mirrored else points

    def _round(self, is_circle: bool) -> tuple[bool, list[Point]]:
        tolerance = self._reading.curve_tolerance()
        center, radius = (self._number(10), self._number(20)), self._number(40)
        if radius <= 0:
            raise self._refusal("the radius is not above 0", "correct it", "not-a-number")
        if is_circle:
            return True, circle(center, radius, tolerance)
        first, last = self._number(50), self._number(51)
        return False, arc_by_angles(center, radius, first, last, tolerance)

    def _corners(self) -> list[Corner]:
        if self._entity.kind == "POLYLINE":
            if self._entity.flags(70) & IN_SPACE:
                what = "this POLYLINE is no polyline in the plane"
                raise self._refusal(what, "convert it to LWPOLYLINE", "unsupported-geometry")
            return [
                (
                    self._reading.number(each.first(10, "0")),
                    self._reading.number(each.first(20, "0")),
                    self._reading.number(each.first(42, "0")),
                )
                for each in self._vertices
            ]
        corners: list[Corner] = []
        for code, value in self._entity.values:
            if code == 10:
                corners.append((self._reading.number(value), Fraction(0), Fraction(0)))
            elif code == 20 and corners:
                corners[-1] = (corners[-1][0], self._reading.number(value), corners[-1][2])
            elif code == 42 and corners:
                corners[-1] = (*corners[-1][:2], self._reading.number(value))
        return corners

    def _polyline(self, corners: list[Corner]) -> tuple[bool, list[Point]]:
        is_closed = bool(self._entity.flags(70) & CLOSED)
        if not corners:
            return is_closed, []
        points: list[Point] = [corners[0][:2]]
        following = [*corners[1:], *(corners[:1] if is_closed else [])]
        for (x, y, bulge), end in zip(corners, following, strict=False):
            if bulge:
                tolerance = self._reading.curve_tolerance()
                points += arc_by_bulge((x, y), end[:2], bulge, tolerance)
            else:
                points.append(end[:2])
        return is_closed, points[:-1] if is_closed and len(points) > 1 else points
