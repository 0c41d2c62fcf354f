"""A sheet's text in its format, and the resulting member."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.invalid.json_text import MARK, Marked, Object, Raw, json_text
from minkref.degeneracies.invalid.member import PREFIX, Invalid
from minkref.degeneracies.invalid.sheet import Sheet, Tokens, tokens


def text_of(dice: Random, page: Sheet) -> str:
    """The file's text, with the mark."""
    if page.form == "wkt":
        return wkt(dice, page)
    if page.form == "poly":
        return poly(dice, page)
    tree = geojson(dice, page) if page.form == "geojson" else tree_of(dice, page)
    return json_text(tree, page.tall) + dice.choice(("", "\n"))


def refused(
    dice: Random, page: Sheet, code: str, *place: str, text: str | None = None, slow: bool = True
) -> Invalid:
    """Makes the member: the place, and the mark's line if the text has a mark."""
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
