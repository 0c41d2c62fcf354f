"""Well-formed JSON texts with wrong members, or values with the wrong type."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random

from minkref.degeneracies.invalid.json_text import MARK, Marked, Object, Raw, json_text
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region
from minkref.degeneracies.invalid.sheet import Sheet, sheet
from minkref.degeneracies.invalid.writing import geojson, refused, tree_of

FAMILIES = Families()

FORMS = ("json", "case", "geojson")
MISSPELT = {
    "polygons": ("polygon", "Polygons", "rings"), "outer": ("Outer", "exterior", "outer "),
    "holes": ("hole", "inner", "Holes", "interiors"), "title": ("titel", "name"),
    "scales": ("scale",), "from": ("begin",), "to": ("until",),
}  # fmt: skip
MORE = ("crs", "bbox", "$schema", "comments", "properties", "units", "hole")
NEEDED = {
    "json": ("polygons", "outer"),
    "case": ("schema", "id", "dimension", "P", "Q", "polygons", "outer", "scales", "interval"),
    "geojson": ("type", "coordinates", "geometry", "geometries", "features"),
}
ARRAYS = ("polygons", "outer", "holes", "scales", "coordinates", "geometries", "features")
OBJECTS = ("P", "Q", "interval", "geometry")
TEXTS = ("title", "schema", "id", "type")
NO_ARRAY: tuple[object, ...] = (Raw("null"), Raw("true"), Raw("7"), "0 0, 1 0, 0 1", Object())
NO_OBJECT: tuple[object, ...] = (Raw("false"), Raw("7"), "POLYGON EMPTY", [])
NO_TEXT: tuple[object, ...] = (Raw("null"), Raw("7"), ["a"], Object())
NO_VERTEX = ("null", '"0 0"', "[]", "[1]", "5", '{"x": 0, "y": 0}')


def drawn(dice: Random, forms: Sequence[str] = FORMS) -> tuple[Sheet, Object]:
    page = sheet(dice, region(dice), forms)
    return page, tree(dice, page)


def tree(dice: Random, page: Sheet) -> Object:
    return geojson(dice, page) if page.form == "geojson" else tree_of(dice, page)


def written(dice: Random, page: Sheet, code: str, value: object, *place: str) -> Invalid:
    return refused(dice, page, code, *place, text=json_text(value, page.tall))


def objects(value: object) -> Iterator[Object]:
    """All of a tree, from the top."""
    if isinstance(value, Object):
        yield value
        for _, part in value:
            yield from objects(part)
    elif isinstance(value, list):
        for part in value:
            yield from objects(part)


def holders(value: object, names: Sequence[str]) -> list[tuple[Object, str]]:
    """The objects with a member by one of these names, each with the name."""
    return [(each, name) for each in objects(value) for name, _ in each if name in names]


@FAMILIES.add("a JSON object that lacks a member")
def missing_member(dice: Random) -> Invalid:
    """Drops a member, or empties it."""
    page, value = drawn(dice)
    where, name = dice.choice(holders(value, NEEDED[page.form]))
    if name in ("id", "scales") and dice.random() < 0.3:
        where.put(name, Marked("" if name == "id" else []))
    elif name in ("P", "Q") and dice.random() < 0.3:
        where.put(name, Marked(Object()))
        name = "polygons"
    else:
        where.drop(name)
        where.mark = True
    return written(dice, page, "missing-member", value, name)


@FAMILIES.add("a JSON object with a member that is not known")
def unknown_member(dice: Random) -> Invalid:
    """Misspells a known member, or adds an unknown one."""
    page, value = drawn(dice, ("json", "case"))
    if dice.random() < 0.5:
        where, old = dice.choice(holders(value, tuple(MISSPELT)))
        name = dice.choice(MISSPELT[old])
        where[:] = [
            (name, Marked(part)) if known == old else (known, part) for known, part in where
        ]
    else:
        where, name = dice.choice(list(objects(value))), dice.choice(MORE)
        part = dice.choice(NO_TEXT)
        where.insert(dice.randint(0, len(where)), (name, Marked(part)))
    return written(dice, page, "unknown-member", value, name)


@FAMILIES.add("a JSON object with a member given twice")
def duplicate_member(dice: Random) -> Invalid:
    """The same value twice, or two; or scales in two ways."""
    page, value = drawn(dice)
    if page.form == "case" and dice.random() < 0.2:
        value.drop("scales")
        value.drop("interval")
        value += [("scales", ["1"]), ("interval", Object([("from", "1"), ("to", "2")]))]
        value.mark = True
        return written(dice, page, "duplicate-member", value, "scales", "interval")
    known = NEEDED["geojson"] if page.form == "geojson" else None
    some = [(each, name) for each in objects(value) for name, _ in each]
    where, name = dice.choice([(w, n) for w, n in some if known is None or n in known])
    k = next(k for k, (first, _) in enumerate(where) if first == name)
    twice = dice.choice((where[k][1], Raw("null")))
    where.insert(dice.randint(k + 1, len(where)), (name, Marked(twice)))
    return written(dice, page, "duplicate-member", value, name)


@FAMILIES.add("a JSON value of another type than is due")
def wrong_type(dice: Random) -> Invalid:
    page, value = drawn(dice)
    if dice.random() < 0.3:
        return _no_vertex(dice, page)
    where, name = dice.choice(holders(value, (*ARRAYS, *OBJECTS, *TEXTS)))
    choices = NO_ARRAY if name in ARRAYS else NO_OBJECT if name in OBJECTS else NO_TEXT
    where.put(name, Marked(dice.choice(choices)))
    return written(dice, page, "wrong-type", value)


def _no_vertex(dice: Random, page: Sheet) -> Invalid:
    rings = [ring for part in page.polygons for ring in part]
    number = dice.randrange(len(rings))
    vertex = dice.randrange(len(rings[number]))
    rings[number][vertex][:] = ["@"]
    text = json_text(tree(dice, page), page.tall).replace("[@]", MARK + dice.choice(NO_VERTEX))
    return refused(dice, page, "wrong-type", f"ring {number}", f"vertex {vertex}", text=text)
