"""Hostile operands in the plane: WKT, GeoJSON, .poly, plain JSON, and texts of the command line."""

from __future__ import annotations

import gzip

from hostile_file import JUDGED, PLANE, SQUARE, Hostile, Large, odd

MILLION = 10**6


def wkt(x: str) -> str:
    return f"POLYGON (({x} 0, 9 0, 9 9, 0 9, {x} 0))"


def plain(x: str) -> str:
    return f'{{"polygons":[{{"outer":[[{x},"0"],["9","0"],["0","9"]],"holes":[]}}]}}'


def geojson(x: str) -> str:
    return f'{{"type":"Polygon","coordinates":[[[{x},0],[9,0],[0,9],[{x},0]]]}}'


def poly(x: str) -> str:
    return f"1\n3 out\n{x} 0\n9 0\n0 9\n"


NUMBERS = {
    "an underscore": "1_0",
    "an exponent with underscores": "1e1_000_000_000",
    "an exponent of a billion": "1e1000000000",
    "an exponent of twenty digits": "1e-99999999999999999999",
    "Arabic digits": "\u0661",
    "a superscript": "\u00b2",
    "a letter of full width": "\uff11",
    "hexadecimal": "0x10",
    "a fraction by zero": "1/0",
    "a fraction in a fraction": "1/2/3",
    "a negative denominator": "1/-2",
    "not a number": "nan",
    "infinity": "-Infinity",
    "two points": "1.2.3",
    "a comma": "1,5",
    "a million digits": "7" * MILLION,
    "a million digits behind the point": "0." + "7" * MILLION,
    "an unseen space": "\u200b1",
}


def of_numbers() -> list[Hostile]:
    """Each spelling in each format. In .poly two points become two numbers, with a warning."""
    found = []
    for title, spelling in NUMBERS.items():
        forms = {
            "wkt": wkt(spelling),
            "json": plain(f'"{spelling}"'),
            "geojson": geojson(spelling),
            "poly": poly(spelling),
        }
        found += [
            Hostile(f"{title}, {form}", f"number.{form}", text) for form, text in forms.items()
        ]
    return found


def nested(open_: str, close: str, inner: str, depth: int = MILLION) -> str:
    return open_ * depth + inner + close * depth


def comb(count: int) -> str:
    """A ring of `count` vertices that crosses itself everywhere."""
    points = [f"{k * 7919 % 104729} {k * 104729 % 7919}" for k in range(count)]
    return f"POLYGON (({', '.join([*points, points[0]])}))"


BYTES = {
    "nothing": b"",
    "a NUL": SQUARE.encode().replace(b"9 0", b"9\0 0", 1),
    "letters that are not UTF-8": b"POLYGON ((\xff\xfe 0, 9 0, 9 9, 0 0))",
    "a letter longer than it need be": SQUARE.encode().replace(b"9", b"\xc0\xb9", 1),
    "UTF-16": SQUARE.encode("utf-16"),
    "UTF-32": SQUARE.encode("utf-32"),
    "what a terminal obeys": b"POLYGON ((\x1b]0;title\x07\x1b[2J 0, 9 0, 9 9, 0 0))",
    "turned writing": "POLYGON ((\u202e\u2066 0, 9 0, 9 9, 0 0))".encode(),
    "a program": b"\x7fELF\x02\x01\x01" + bytes(1000),
    "gzip": gzip.compress(SQUARE.encode()),
    "a bomb in gzip": Large(lambda: gzip.compress(bytes(1 << 24))),
    "a line of 60 MB": Large(lambda: b"POLYGON ((" + b" " * (60 << 20) + b"0 0, 9 0, 9 9, 0 0))"),
    "a word of 60 MB": Large(lambda: b"X" * (60 << 20)),
    "sixty million lines": Large(lambda: b"\n" * (60 << 20)),
    "tabs and carriage returns alone": b"\t\r" * 1000,
}
TEXTS = {
    "collections in collections": (
        "deep.wkt", Large(lambda: nested("GEOMETRYCOLLECTION (", ")", "POINT (0 0)", 10**5))),
    "parentheses": ("deep.wkt", Large(lambda: "POLYGON " + nested("(", ")", "0 0"))),
    "lists in lists": ("deep.json", Large(lambda: nested("[", "]", ""))),
    "objects in objects": ("deep.json", Large(lambda: nested('{"polygons":', "}", "[]", 10**5))),
    "GeoJSON in GeoJSON": (
        "deep.geojson",
        Large(lambda: nested('{"type":"GeometryCollection","geometries":[', "]}", "", 10**5))),
    "a million empty polygons": (
        "many.json", Large(lambda: '{"polygons":[' + ",".join(['{"outer":[]}'] * MILLION) + "]}")),
    "a million members": (
        "many.json", Large(lambda: "{" + ",".join(f'"{k}":0' for k in range(MILLION)) + "}")),
    "twenty million values": ("many.json", Large(lambda: "[" + "0," * 20_000_000 + "0]")),
    "a member twice": ("twice.json", '{"polygons":[],"polygons":[]}'),
    "a member twice, once escaped": ("twice.json", '{"polygons":[],"poly\\u0067ons":[]}'),
    "half a surrogate": ("surrogate.json", '{"polygons":[],"\\ud800":1}'),
    "a word behind the end": ("tail.json", '{"polygons":[]} x'),
    "a member with a name that obeys a terminal": ("name.json", '{"\\u001b[2J\\u0007":1}'),
    "a member with a name of a megabyte": ("name.json", '{"' + "x" * MILLION + '":1}'),
    "polygons that are an object": ("kind.json", '{"polygons":{"outer":[]}}'),
    "a ring of rings": ("kind.json", '{"polygons":[{"outer":[[["0","0"]]]}]}'),
    "a point of three numbers": ("kind.json", '{"polygons":[{"outer":[["0","0","0"]]}]}'),
    "a point of no number": ("kind.json", '{"polygons":[{"outer":[[],[],[]]}]}'),
    "a count of rings below zero": ("count.poly", "-1\n3 out\n0 0\n1 0\n0 1\n"),
    "a count of rings beyond every type": ("count.poly", "9" * 40 + "\n3 out\n0 0\n1 0\n0 1\n"),
    "a count of vertices of four billion": ("count.poly", "1\n4294967299 out\n0 0\n1 0\n0 1\n"),
    "a count of vertices of 2^64 + 3": (
        "count.poly", "1\n18446744073709551619 out\n0 0\n1 0\n0 1\n"),
    "a count with an exponent": ("count.poly", "1e0\n3 out\n0 0\n1 0\n0 1\n"),
    "an index of zero": ("index.poly", "1\n3 out\n0 0\n1 0\n0 1\n0 1 2\n"),
    "an index twice": ("index.poly", "1\n3 out\n0 0\n1 0\n0 1\n1 1 2\n"),
    "an index beyond every type": ("index.poly", f"1\n3 out\n0 0\n1 0\n0 1\n1 2 {'9' * 30}\n"),
    "a hole without a ring around it": ("hole.poly", "1\n3 in\n0 0\n0 1\n1 0\n"),
    "a ring of 200,000 vertices that crosses itself": (
        "crossing.wkt", Large(lambda: comb(200_000))),
    "a million vertices and one": (
        "many.wkt", Large(lambda: "POLYGON ((" + "0 0," * (MILLION + 1) + "0 0))")),
    "an SRID": ("srid.wkt", "SRID=4326;" + SQUARE),
    "a polygon with Z": ("z.wkt", "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))"),
    "curves": ("curve.wkt", "CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 4 4, 0 4, 0 0))"),
    "a type that is a list": ("type.geojson", '{"type":["Polygon"],"coordinates":[]}'),
    "a feature of itself": (
        "type.geojson", '{"type":"Feature","geometry":{"type":"Feature","geometry":null}}'),
    "coordinates that are an object": (
        "type.geojson", '{"type":"Polygon","coordinates":{"0":[[0,0]]}}'),
    "coordinates of mixed depth": (
        "type.geojson", '{"type":"Polygon","coordinates":[[0,0],[[1,1]],[[[2,2]]]]}'),
    "a hole for each of 5,000 outer rings": (
        "work.poly",
        Large(lambda: "10000\n" + "".join(
            f"3 out\n{k} 0\n{k}.5 0\n{k} 1\n3 in\n{k}.1 0.1\n{k}.1 0.2\n{k}.2 0.1\n"
            for k in range(5000)))),
    "vertices whose denominators share no factor": (
        "long.json",
        Large(lambda: '{"polygons":[{"outer":[' + ",".join(
            f'["1/{odd(10, 3000, k)}","{k * k}/{odd(7, 3000, k)}"]' for k in range(12))
            + "]}]}")),
}  # fmt: skip
HUGE = [
    Hostile("1e9999 beside 1e-9999", "magnitudes.wkt",
            "POLYGON ((0 0, 1e9999 0, 1e9999 1e-9999, 0 0))", codes=JUDGED),
    Hostile("a number of 9,999 digits over another", "long.wkt",
            f"POLYGON ((0 0, {'7' * 9999}/{'3' * 9998} 0, 9 {'1' * 9999}, 0 0))", codes=JUDGED),
]  # fmt: skip
ARGUMENTS = [
    Hostile("an operand of the command line without end", "unused.wkt", "",
            ("sum", "POLYGON ((" + "0 0," * 20_000, "g3", "-o", "out.json")),
    Hostile("an operand of the command line in braces", "unused.wkt", "",
            ("sum", "{" * 50_000, "g3", "-o", "out.json")),
    Hostile("the name of an operand is longer than names are", "unused.wkt", "",
            ("sum", "x" * 100_000, "g3", "-o", "out.json")),
    Hostile("the name of an operand obeys a terminal", "unused.wkt", "",
            ("sum", "\x1b]0;title\x07\u202e.wkt", "g3", "-o", "out.json")),
]  # fmt: skip
JUDGED_BYTES = {"a line of 60 MB"}
JUDGED_TEXTS = {
    "a feature of itself", "vertices whose denominators share no factor", "an SRID",
    "a polygon with Z",
}  # fmt: skip

FILES = [
    *of_numbers(),
    *(
        Hostile(title, "bytes.wkt", data, codes=JUDGED if title in JUDGED_BYTES else (2,))
        for title, data in BYTES.items()
    ),
    *(
        Hostile(title, name, text, PLANE, JUDGED if title in JUDGED_TEXTS else (2,))
        for title, (name, text) in TEXTS.items()
    ),
    *HUGE,
    *ARGUMENTS,
]
