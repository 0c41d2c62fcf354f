"""An operand on its way to a file: its tokens may still be changed, and one place marked."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from minkref.degeneracies.invalid.json_text import MARK, Marked, Object, Raw, json_text
from minkref.degeneracies.invalid.member import PREFIX, Invalid
from minkref.degeneracies.invalid.operands import coordinates, region
from minkref.fuzz.families.drawing import Point, Shape, mapped

Corner = list[str]  # the texts of its coordinates
ENDINGS = {"wkt": ".wkt", "geojson": ".geojson", "poly": ".poly", "json": ".json", "case": ".json"}
FORMS = tuple(ENDINGS)
JSON_FORMS = ("json", "case")
CLOSED = ("wkt", "geojson")  # a ring repeats its first vertex


class Tokens(list[Corner]):
    """Of a ring, or the ends of what is `thin`, a point or a segment. `mark`: the mark stands
    before its beginning."""

    mark = False
    thin = False


def decimal(value: Fraction | int) -> str | None:
    """The finite decimal that the number is, if it is one."""
    value = Fraction(value)
    places = 0
    while value.denominator != 1 and places < 400:
        value, places = value * 10, places + 1
    if value.denominator != 1:
        return None
    if not places:
        return str(value)
    digits = str(abs(value.numerator)).rjust(places + 1, "0")
    return ("-" if value < 0 else "") + digits[:-places] + "." + digits[-places:]


def token(dice: Random, form: str, value: Fraction | int) -> str:
    """One of the texts of a number in a format."""
    plain = decimal(value)
    kind = dice.random()
    if form == "geojson" and plain is None:
        raise ValueError(f"{value} is no decimal")
    if plain is not None and "." not in plain and kind < 0.2:
        plain = dice.choice((f"{plain}.0", f"{plain}e0", f"{plain}.00E+0"))
    if form == "geojson":
        return str(plain)
    text = plain if plain is not None and kind < 0.7 else str(value)
    if form == "json" and plain is not None and kind < 0.4:
        return plain
    if form == "case" and Fraction(value).denominator == 1 and kind < 0.4:
        return str(value)
    return json.dumps(text) if form in JSON_FORMS else text


@dataclass
class Sheet:
    """`shape` holds the numbers, `polygons` their texts. `backwards`: the rings run the wrong way,
    so that indices of two vertices come in another order in messages."""

    form: str
    shape: Shape
    polygons: list[list[Tokens]]
    operand: str
    tall: bool
    backwards: bool
    other: Shape | None = None  # of a case

    def number(self, polygon: int, ring: int) -> int:
        """Of a ring in the file."""
        return sum(len(rings) for rings in self.polygons[:polygon]) + ring

    def mark(self, polygon: int, ring: int, vertex: int) -> None:
        """The line of this vertex is named."""
        corner = self.polygons[polygon][ring][vertex]
        corner[0] = MARK + corner[0]

    def name(self) -> str:
        return ("case" if self.form == "case" else self.operand) + ENDINGS[self.form]


def sheet(
    dice: Random,
    shape: Shape,
    forms: Sequence[str] = FORMS,
    backwards: bool | None = None,
) -> Sheet:
    """The shape in one of the formats, in other coordinates, each ring begun at its first
    vertex."""
    thin = any(len(rings[0]) < 3 for rings in shape)
    form = dice.choice([form for form in forms if not (thin and form == "poly")])
    change = coordinates(dice, form == "geojson")
    placed = mapped(shape, change)
    turn = dice.random() < 0.25 if backwards is None else backwards
    turn = turn and form != "case" and not thin
    if turn:
        placed = [[ring[::-1] for ring in rings] for rings in placed]
    polygons = tokens(dice, form, placed)
    if form in CLOSED and not thin:
        for ring in (ring for rings in polygons for ring in rings):
            ring.append(list(ring[0]))
    made = Sheet(form, placed, polygons, dice.choice("PQ"), dice.random() < 0.5, turn)
    if form == "case":
        made.other = mapped(region(dice), coordinates(dice, False))
    return made


def tokens(dice: Random, form: str, shape: Shape) -> list[list[Tokens]]:
    """The texts of the numbers of a shape; no vertex is repeated."""
    found = [
        [Tokens([token(dice, form, n) for n in p] for p in ring) for ring in rings]
        for rings in shape
    ]
    for rings in found:
        rings[0].thin = len(rings[0]) < 3
    return found


def place_of(*points: Point) -> tuple[str, ...]:
    """As messages write them."""
    return tuple(f"({Fraction(x)}, {Fraction(y)})" for x, y in points)


def text_of(dice: Random, page: Sheet) -> str:
    """The text of the file, with its mark."""
    if page.form == "wkt":
        return wkt(dice, page)
    if page.form == "poly":
        return poly(dice, page)
    tree = geojson(dice, page) if page.form == "geojson" else tree_of(dice, page)
    return json_text(tree, page.tall) + dice.choice(("", "\n"))


def refused(
    dice: Random, page: Sheet, code: str, *place: str, text: str | None = None, slow: bool = True
) -> Invalid:
    """The member: its place, and the line of the mark if there is one."""
    text = text_of(dice, page) if text is None else text
    if MARK in text:
        place = (*place, f"line {text[: text.index(MARK)].count(chr(10)) + 1}")
    content = text.replace(MARK, "").encode()
    return of_bytes(page, code, content, *place, slow=slow)


def of_bytes(page: Sheet, code: str, content: bytes, *place: str, slow: bool = True) -> Invalid:
    return Invalid(
        PREFIX + code,
        code,
        page.name(),
        content,
        place or (page.name(),),
        page.operand,
        part=f"#{page.operand}" if page.form == "case" else "",
        slow_reads=slow and page.form != "geojson",
    )


def geometries(dice: Random, page: Sheet) -> list[list[list[Tokens]]]:
    """The polygons, alone or together; a point or a segment is alone."""
    polygons = page.polygons
    together = len(polygons) > 1 and dice.random() < 0.6
    if together and not any(rings[0].thin for rings in polygons):
        return [polygons]
    return [[rings] for rings in polygons]


def kind_of(rings: list[Tokens]) -> str:
    return ("point", "segment")[len(rings[0]) - 1] if rings[0].thin else "polygon"


def wkt(dice: Random, page: Sheet) -> str:
    line = "\n" if page.tall else ""

    def ring_text(ring: Tokens) -> str:
        corners = f",{line} ".join(" ".join(corner) for corner in ring)
        return f"{MARK if ring.mark else ''}({corners})"

    def part(rings: list[Tokens]) -> str:
        return "(" + f",{line} ".join(ring_text(ring) for ring in rings) + ")"

    def geometry(polygons: list[list[Tokens]]) -> str:
        kind = kind_of(polygons[0])
        if kind != "polygon":
            return (
                {"point": "POINT", "segment": "LINESTRING"}[kind] + " " + ring_text(polygons[0][0])
            )
        if len(polygons) == 1 and dice.random() < 0.8:
            return f"POLYGON {line}{part(polygons[0])}"
        return f"MULTIPOLYGON {line}(" + f",{line} ".join(map(part, polygons)) + ")"

    parts = [geometry(polygons) for polygons in geometries(dice, page)]
    text = parts[0]
    if len(parts) > 1 or dice.random() < 0.1:
        text = "GEOMETRYCOLLECTION (" + f",{line} ".join(parts) + ")"
    return text + dice.choice(("", "\n"))


def poly(dice: Random, page: Sheet) -> str:
    lines = [str(sum(len(rings) for rings in page.polygons))]
    if dice.random() < 0.3:
        lines.insert(0, "# a polygon set")
    indices = dice.random() < 0.6
    for rings in page.polygons:
        for r, ring in enumerate(rings):
            lines.append(f"{MARK if ring.mark else ''}{len(ring)} {'in' if r else 'out'}")
            lines += [" ".join(corner) for corner in ring]
            if indices:
                lines.append(" ".join(str(k + 1) for k in range(len(ring))))
    return "\n".join(lines) + dice.choice(("", "\n"))


def json_ring(ring: Tokens) -> object:
    corners = [[Raw(text) for text in corner] for corner in ring]
    return Marked(corners) if ring.mark else corners


def plain_tree(polygons: list[list[Tokens]]) -> Object:
    parts = []
    for p, rings in enumerate(polygons):
        part = Object([("outer", json_ring(rings[0]))])
        holes = [json_ring(ring) for ring in rings[1:]]
        if holes or p % 2:
            part.append(("holes", holes))
        parts.append(part)
    return Object([("polygons", parts)])


def tree_of(dice: Random, page: Sheet) -> Object:
    """A plain operand or a case."""
    if page.form == "json":
        return plain_tree(page.polygons)
    other = tokens(dice, "case", page.other or [])
    first, second = plain_tree(page.polygons), plain_tree(other)
    if page.operand == "Q":
        first, second = second, first
    case = Object(
        [
            ("schema", "case-v1"),
            ("id", f"drawn-{dice.randrange(10**6)}"),
            ("title", "A drawn pair"),
            ("dimension", Raw("2")),
            ("P", first),
            ("Q", second),
        ]
    )
    if dice.random() < 0.7:
        case.append(("scales", [str(Fraction(dice.randint(1, 9), dice.randint(1, 5)))]))
    else:
        case.append(("interval", Object([("from", "1/2"), ("to", str(dice.randint(1, 9)))])))
    return case


def geojson(dice: Random, page: Sheet) -> Object:
    parts = []
    for polygons in geometries(dice, page):
        trees = [[json_ring(ring) for ring in rings] for rings in polygons]
        kind = kind_of(polygons[0])
        if kind != "polygon":
            ring = [[Raw(text) for text in corner] for corner in polygons[0][0]]
            body = ring[0] if kind == "point" else ring
            parts.append(geometry_of("Point" if kind == "point" else "LineString", body))
        elif len(trees) == 1 and dice.random() < 0.8:
            parts.append(geometry_of("Polygon", trees[0]))
        else:
            parts.append(geometry_of("MultiPolygon", trees))
    style = dice.random()
    if len(parts) == 1 and style < 0.5:
        return parts[0]
    if style < 0.75:
        return Object([("type", "GeometryCollection"), ("geometries", parts)])
    features = [
        Object([("type", "Feature"), ("properties", Raw("null")), ("geometry", part)])
        for part in parts
    ]
    if len(features) == 1 and style < 0.9:
        return features[0]
    return Object([("type", "FeatureCollection"), ("features", features)])


def geometry_of(kind: str, body: object) -> Object:
    return Object([("type", kind), ("coordinates", body)])
