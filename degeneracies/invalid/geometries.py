"""Well-formed input that describes no operand in the plane."""

from __future__ import annotations

import re
from random import Random

from minkref.degeneracies.invalid.json_text import MARK, Marked, Raw, json_text
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import coordinates, region, thin
from minkref.degeneracies.invalid.sheet import (
    CLOSED,
    JSON_FORMS,
    Sheet,
    place_of,
    sheet,
    token,
    tokens,
)
from minkref.degeneracies.invalid.structure import holders
from minkref.degeneracies.invalid.writing import geojson, geometry_of, refused, text_of
from minkref.fuzz.geometry.plane import mapped

FAMILIES = Families()

WORDS = (
    "CIRCULARSTRING", "CURVEPOLYGON", "TRIANGLE", "TIN", "CIRCLE", "POLYHEDRALSURFACE", "POLYGONE",
    "LINEARRING", "BOX", "MULTISURFACE", "COMPOUNDCURVE", "RASTER",
)  # fmt: skip
MIXED = (*JSON_FORMS, *CLOSED)
TYPES = ("polygon", "POLYGON", "Topology", "LinearRing", "Circle", "MultiCurve", "Triangle")


@FAMILIES.add("a geometry that is no operand")
def unsupported_geometry(dice: Random) -> Invalid:
    """Another geometry instead of a polygon."""
    page = sheet(dice, region(dice), CLOSED)
    if page.form == "wkt":
        text = text_of(dice, page)
        word = dice.choice(WORDS)
        old = "MULTIPOLYGON" if "MULTIPOLYGON" in text else "POLYGON"
        shown = word.lower() if dice.random() < 0.3 else word
        text = text.replace(old, MARK + shown, 1)
        return refused(dice, page, "unsupported-geometry", word, text=text)
    tree, name = geojson(dice, page), dice.choice(TYPES)
    some = [where for where, _ in holders(tree, ("type",)) if dict(where)["type"] != "Feature"]
    dice.choice([where for where in some if dict(where).get("coordinates")]).put(
        "type", Marked(name)
    )
    return refused(dice, page, "unsupported-geometry", name, text=json_text(tree, page.tall))


@FAMILIES.add("coordinates beyond x and y")
def three_dimensional(dice: Random) -> Invalid:
    """Coordinates too many, at one vertex or several; Z and M of WKT without numbers."""
    page = sheet(dice, region(dice) if dice.random() < 0.8 else thin(dice))
    if page.form == "wkt" and dice.random() < 0.4 and not text_of(dice, page).startswith("G"):
        return _dimension_word(dice, page)
    rings = [ring for part in page.polygons for ring in part]
    number = dice.randrange(len(rings))
    vertex = dice.randrange(len(rings[number]))
    more = 3 if page.form in CLOSED else 1  # a third and a fourth one are dropped there
    for r, ring in enumerate(rings):
        for v, corner in enumerate(ring):
            if (r, v) == (number, vertex) or ((r, v) > (number, vertex) and dice.random() < 0.8):
                corner += [token(dice, page.form, dice.randint(0, 9)) for _ in range(more)]
    rings[number][vertex][0] = MARK + rings[number][vertex][0]
    return refused(dice, page, "three-dimensional", f"ring {number}", f"vertex {vertex}")


def _dimension_word(dice: Random, page: Sheet) -> Invalid:
    word = dice.choice((" Z", " M", " ZM", "Z", "M", "ZM", " z", " Zm"))
    page.polygons[0][0][0][0] = MARK + page.polygons[0][0][0][0]
    text = text_of(dice, page)
    first = re.match(r"[A-Za-z]*", text)[0]  # type: ignore[index]
    text = f"{first}{word}{text[len(first) :]}"
    return refused(dice, page, "three-dimensional", "ring 0", "vertex 0", text=text)


@FAMILIES.add("a line of one point")
def not_a_segment(dice: Random) -> Invalid:
    """A line of a single point, which has no segment."""
    shape = region(dice, parts=1)
    shape[0] = shape[0][:1]
    page = sheet(dice, shape, CLOSED)
    ring = page.polygons[0][0]
    ring[1:] = []
    ring.mark = True
    if page.form == "wkt":
        text = text_of(dice, page)
        body = text[text.index(MARK) : text.index(")") + 1]
        text = f"{dice.choice(('LINESTRING', 'LineString'))} {body}"
    else:
        tree = geometry_of("LineString", Marked([[Raw(each) for each in c] for c in ring]))
        text = json_text(tree, page.tall)
    return refused(dice, page, "not-a-segment", "ring 0", f"{len(ring)} p", text=text)


@FAMILIES.add("a point or a segment beside polygons")
def mixed_operand(dice: Random) -> Invalid:
    """A point or a segment beside polygons."""
    page = sheet(dice, region(dice), MIXED)
    shape = mapped(thin(dice), coordinates(dice, True))
    number = dice.randint(0, len(page.polygons))
    page.polygons[number:number] = tokens(dice, page.form, shape)
    ring = page.number(number, 0)
    page.mark(number, 0, 0)
    place = place_of(*(rings[0][0] for rings in shape))
    return refused(dice, page, "mixed-operand", f"ring {ring}", "vertex 0", *place)
