"""Bad input through the command line: refused with a place and a mend, nothing written."""

from __future__ import annotations

from minkref.reports.evidence.framework.bad_input import Bad, refuse_all
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.3, 0.3)


GEOMETRY = ("ring", "(")  # the ring, and coordinates
BOX = "(0 0, 9 0, 9 9, 0 9, 0 0)"


def _case(ring: str) -> str:
    square = '[["0","0"],["1","0"],["1","1"],["0","1"]]'
    return (
        '{"schema":"case-v1","id":"bad","dimension":2,"scales":["1"],'
        f'"P":{{"polygons":[{{"outer":{ring},"holes":[]}}]}},'
        f'"Q":{{"polygons":[{{"outer":{square},"holes":[]}}]}}}}'
    )


BAD = [
    Bad("self-intersection", "a.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 6, 0 0))",
        ("self-intersection",), GEOMETRY),
    Bad("zero-length edge", "b.wkt", "POLYGON ((0 0, 4 0, 4 0, 4 4, 0 0))",
        ("zero-length-edge",), GEOMETRY),
    Bad("fewer than three vertices", "c.poly", "1\n2 out\n0 0\n1 1\n",
        ("too-few-vertices",), ("ring",)),
    Bad("zero area", "d.wkt", "POLYGON ((0 0, 2 0, 4 0, 0 0))",
        ("zero-area", "self-intersection"), GEOMETRY),
    Bad("wrong orientation in a case", "e.json", _case('[["0","0"],["0","1"],["1","0"]]'),
        ("wrong-orientation",), GEOMETRY),
    Bad("hole outside its outer ring", "f.wkt", f"POLYGON ({BOX}, (20 1, 21 1, 20 2, 20 1))",
        ("hole-outside",), GEOMETRY),
    Bad("rings that overlap along an edge", "g.wkt", f"POLYGON ({BOX}, (0 2, 3 3, 0 4, 0 2))",
        ("overlapping-rings",), GEOMETRY),
    Bad("rings that cross", "h.wkt", f"POLYGON ({BOX}, (5 5, 12 6, 5 7, 5 5))",
        ("crossing-rings",), GEOMETRY),
    Bad("polygons that overlap", "i.wkt",
        f"MULTIPOLYGON (({BOX}), ((2 2, 4 2, 4 4, 2 4, 2 2)))",
        ("overlapping-polygons",), GEOMETRY),
    Bad("NaN", "j.wkt", "POLYGON ((0 0, NaN 0, 4 4, 0 0))", ("not-a-number", "syntax")),
    Bad("infinity", "k.poly", "1\n3 out\n0 0\ninf 0\n1 1\n", ("not-a-number", "syntax")),
    Bad("NaN in JSON", "l.geojson",
        '{"type":"Polygon","coordinates":[[[0,0],[NaN,0],[1,1],[0,0]]]}',
        ("not-a-number", "syntax")),
    Bad("a number of a million digits", "m.wkt", f"POLYGON ((0 0, {'7' * 10**6} 0, 4 4, 0 0))",
        ("number-too-long", "too-many-digits")),
    Bad("an exponent of a billion", "n.geojson",
        '{"type":"Polygon","coordinates":[[[0,0],[1e1000000000,0],[1,1],[0,0]]]}',
        ("exponent-too-large",)),
    Bad("a truncated file (WKT)", "o.wkt", "POLYGON ((0 0, 4 0, 4", ("truncated", "syntax")),
    Bad("a truncated file (GeoJSON)", "p.geojson", '{"type":"Polygon","coordinates":[[[0,0],[1,',
        ("truncated", "syntax")),
    Bad("a truncated file (poly)", "q.poly", "1\n4 out\n0 0\n1 0\n1 1\n", ("truncated", "syntax")),
    Bad("deep nesting", "r.json", "[" * 10**6, ("too-deep",)),
    Bad("an empty file", "s.wkt", "", ("empty-file", "truncated")),
    Bad("a zero denominator", "t.json", _case('[["0","0"],["1/0","0"],["1","1"]]'),
        ("zero-denominator",)),
    Bad("scale zero", "u.wkt", f"POLYGON ({BOX})", ("scale-zero",), scale="0"),
    Bad("a negative scale", "v.wkt", f"POLYGON ({BOX})", ("scale-negative",), scale="-1/2"),
    Bad("a scale that is no number", "w.wkt", f"POLYGON ({BOX})",
        ("scale-not-finite", "scale-not-a-number"), scale="nan"),
]  # fmt: skip

EVERY = Counts(3, 1, 1)  # one in so many


def run(findings: Findings, size: Size) -> None:
    refuse_all(findings, BAD[:: size.of(EVERY)])
