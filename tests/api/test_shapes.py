"""Sets from what programs hold, and back: numbers count by their exact value, and sets by their
points."""

from __future__ import annotations

import json
import struct
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import minkref
import numpy as np
import pytest
import shapely
from minkref import PolygonSet, Polyhedron

TRIANGLE = PolygonSet([(0, 0), (1, 0), (0, 1)])
FRAME = PolygonSet([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2), (1, 2)]])
CASES = [PolygonSet(), PolygonSet((1, "1/3")), PolygonSet([(0, 0), (1, 2)]), TRIANGLE, FRAME]
RING = [(0, 0), (4, 0), (4, 4), (0, 4)]
HOLE = [(1, 1), (2, 1), (2, 2), (1, 2)]


class Holder:
    def __init__(self, value: Any) -> None:
        self.__geo_interface__ = value


GEOJSON = {"type": "Polygon", "coordinates": [[*RING, RING[0]], [*HOLE, HOLE[0]]]}
SPELLINGS = {
    "turned, and begun elsewhere": [RING[::-1], [*HOLE[2:], *HOLE[:2]]],
    "closed rings": [[*RING, RING[0]], [*HOLE, HOLE[0]]],
    "polygons": [[RING, HOLE]],
    "arrays": [np.array(RING), np.array(HOLE, dtype=np.float32)],
    "one array of two rings": np.array([RING, HOLE]),
    "texts": [[(f"{x}.0", f"{2 * y}/2") for x, y in RING], HOLE],
    "decimals": [[(Decimal(x), Decimal(y)) for x, y in RING], HOLE],
    "scalars of NumPy": [[(np.int64(x), np.float64(y)) for x, y in RING], HOLE],
    "a straight vertex": [[(0, 0), (2, 0), *RING[1:]], HOLE],
    "the project's JSON": {"polygons": [{"outer": RING, "holes": [HOLE]}]},
    "GeoJSON": GEOJSON,
    "a feature": {"type": "Feature", "geometry": GEOJSON},
    "a collection": {"type": "GeometryCollection", "geometries": [GEOJSON]},
    "features": {
        "type": "FeatureCollection",
        "features": [{"type": "Feature", "geometry": GEOJSON}],
    },
    "a multipolygon": {"type": "MultiPolygon", "coordinates": [GEOJSON["coordinates"]]},
    "an object of another library": Holder(GEOJSON),
    "Shapely": shapely.Polygon(RING, [HOLE]),
    "WKT": "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,2 1,2 2,1 2,1 1))",
    "GeoJSON as text": json.dumps(GEOJSON),
    "a set": FRAME,
}  # fmt: skip


@pytest.mark.parametrize("spelling", SPELLINGS)
def test_one_set_in_many_spellings(spelling: str) -> None:
    made = PolygonSet(SPELLINGS[spelling])
    assert made == FRAME and hash(made) == hash(FRAME)
    assert made.area() == "15"


@pytest.mark.parametrize("case", CASES, ids=repr)
def test_what_python_shows_makes_the_set_again(case: PolygonSet) -> None:
    assert eval(repr(case), {"PolygonSet": PolygonSet}) == case
    assert PolygonSet(case.rings()) == case
    assert len({case, PolygonSet(case.rings())}) == 1
    assert case.is_empty or case._repr_svg_().startswith("<svg")  # type: ignore[attr-defined]


@pytest.mark.parametrize("case", [TRIANGLE, FRAME], ids=["triangle", "frame"])
def test_shapely_and_arrays_hold_the_same_set(case: PolygonSet) -> None:
    assert PolygonSet(shapely.geometry.shape(case)) == case
    assert PolygonSet([[ring.tolist() for ring in polygon] for polygon in case.arrays()]) == case
    assert [ring.shape for ring in case.arrays()[0]] == [(len(r), 2) for r in case.rings()[0]]


def test_warnings_of_a_reader_stay_with_the_set_that_was_read() -> None:
    doubtful = minkref.read_text("1\n3 out\n0 0\n4.50.5\n0 4\n", "poly", "one")
    assert "4.50.5" in doubtful.warnings[0]
    assert minkref.read_text("POLYGON((0 0,1 0,0 1,0 0))", "wkt").warnings == []
    assert len(doubtful.warnings) == 1
    assert doubtful.scaled("2").warnings == []


def test_numbers_count_by_their_exact_value() -> None:
    tenth = PolygonSet([(0, 0), (Fraction(1, 10), 0), (0, 1)])
    assert PolygonSet([(0, 0), ("0.1", 0), (0, 1)]) == tenth
    assert PolygonSet([(0, 0), (Decimal("0.1"), 0), (0, 1)]) == tenth
    double = PolygonSet([(0, 0), (0.1, 0), (0, 1)])
    assert double != tenth and double.rings()[0][0][1][0] == Fraction(0.1)
    assert double.arrays()[0][0][1][0] == tenth.arrays()[0][0][1][0] == 0.1


@pytest.mark.parametrize("digits", [4_000, 20_000])
def test_numbers_of_any_length(digits: int) -> None:
    long = 10**digits
    made = PolygonSet([(long, 0), (long + 1, Fraction(1, long + 1)), (long, 1)])
    assert made.rings()[0][0][1] == (long + 1, Fraction(1, long + 1))


def test_random_sets_survive_fractions_and_are_told_apart() -> None:
    for seed in range(100):
        dice = Random(seed)
        x, y, w, h = (Fraction(dice.randint(-9, 9), dice.randint(1, 9)) for _ in range(4))
        right, top = x + abs(w) + 1, y + abs(h) + 1
        corners = [(x, y), (right, y), (right, top), (x, top)]
        box, turned = PolygonSet(corners), dice.randrange(4)
        assert PolygonSet(corners[turned:] + corners[:turned]) == box, f"seed {seed}"
        assert PolygonSet(PolygonSet(box.rings()).rings()) == box, f"seed {seed}"
        assert box.translated("0", "1/97") != box, f"seed {seed}"


LOOP: dict[str, Any] = {"type": "GeometryCollection"}
LOOP["geometries"] = [LOOP]
REFUSED = {
    "a number": (3, "PolygonSet: an object of type int"),
    "nothing": (None, "PolygonSet: an object of type NoneType"),
    "an empty ring": ([[]], "point 0: a point of the plane has two coordinates, not 0"),
    "three coordinates": ([(0, 0, 1)], "two coordinates, not 3"),
    "no number": (
        [(0, 0), (float("nan"), 0), (1, 1)],
        "the ring, point 1, x: the coordinate is nan",
    ),
    "a word": ([(0, 0), ("a", 0), (1, 1)], "the ring, point 1, x: the coordinate is not a number"),
    "a truth value": ([(True, 0), (1, 0), (0, 1)], "of type bool"),
    "a set of points": ({(0, 0), (1, 0), (0, 1)}, "an object of type set"),
    "an iterator": (iter([(0, 0)]), "is no set of polygons"),
    "mixed depths": ([[(0, 0), (1, 0), (0, 1)], 5], "hole 1: there is an object of type int"),
    "no coordinates": ({"type": "Polygon"}, "the coordinates of the Polygon"),
    "no outer ring": ({"polygons": [{"holes": []}]}, "this is no mapping with 'outer'"),
    "another geometry": ({"type": "Circle"}, "of the type 'Circle'"),
    "an array without dimensions": (np.array(3), "of type ndarray"),
    "text in no format": ("circle", "'circle': this text is in no known format"),
    "standard input": ("-", "'-': this text is in no known format"),
    "infinity": ([(0, 0), (np.float32("inf"), 0), (0, 1)], "the coordinate is inf"),
    "a Decimal that is no number": ([(0, 0), (Decimal("sNaN"), 0), (0, 1)], "is sNaN"),
    "a Decimal of a huge exponent": ([(0, 0), (Decimal("1e999999"), 0), (0, 1)], "exponent"),
    "a complex number": ([(0, 0), (1j, 0), (0, 1)], "of type complex"),
    "collections in themselves": (LOOP, "nested deeper"),
    "a feature of no geometry": ({"type": "Feature", "geometry": [1, 2]}, "a mapping is expected"),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_what_is_no_shape_is_refused_where_it_stands(kind: str) -> None:
    shape, told = REFUSED[kind]
    with pytest.raises(minkref.Refusal, match=told.replace("(", r"\(")) as refused:
        PolygonSet(shape)
    assert isinstance(refused.value, minkref.BadInput)  # the exception that is documented
    assert refused.value.problem and refused.value.mend and refused.value.code


def test_a_shape_that_is_no_regular_set_is_refused_unless_told_not_to_look() -> None:
    bow = [(0, 0), (1, 1), (1, 0), (0, 1)]
    with pytest.raises(minkref.BadInput, match="two edges of a ring cross") as refused:
        PolygonSet(bow)
    assert (refused.value.code, refused.value.ring) == ("self-intersection", 0)
    assert PolygonSet(bow, validate=False).vertices == 4
    clockwise = PolygonSet([(0, 0), (0, 1), (1, 0)], validate=False)
    assert clockwise.rings()[0][0] == [
        (Fraction(x), Fraction(y)) for x, y in ((0, 0), (0, 1), (1, 0))
    ]


LINE = [(0, 0), (4, 0), (4, 4)]
#: Values, and the text of a file of the same.
AS_IN_FILES: dict[str, tuple[Any, str]] = {
    "a line of one point": ({"type": "LineString", "coordinates": LINE[:1]}, "LINESTRING (0 0)"),
    "a line that stays": (
        {"type": "LineString", "coordinates": [*LINE, LINE[-1]]}, "LINESTRING (0 0, 4 0, 4 4, 4 4)",
    ),
    "an open ring": ({"type": "Polygon", "coordinates": [LINE]}, "POLYGON ((0 0, 4 0, 4 4))"),
    "a ring there and back": (
        {"type": "Polygon", "coordinates": [[*LINE[:2], LINE[0]]]}, "POLYGON ((0 0, 4 0, 0 0))",
    ),
    "a line in a collection": (
        {
            "type": "GeometryCollection",
            "geometries": [GEOJSON, {"type": "LineString", "coordinates": LINE[:2]}],
        },
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (0 0, 4 0))",
    ),
    "a segment of no length": ([(1, 1), (1, 1)], "LINESTRING (1 1, 1 1)"),
}  # fmt: skip


def test_lines_are_not_filled() -> None:
    """An open line of three points was once filled: its area was 8."""
    line = PolygonSet({"type": "LineString", "coordinates": LINE})
    ring = PolygonSet(shapely.LineString([*LINE, LINE[0]]))
    assert line == PolygonSet("LINESTRING (4 4, 4 0, 2 0, 0 0)") and line != ring
    assert (line.is_lines, ring.is_lines, line.area(), ring.area()) == (True, True, "0", "0")
    several = PolygonSet(shapely.MultiPoint([(0, 0), (1, 1)]))
    assert several == PolygonSet("MULTIPOINT (1 1, 0 0, 1 1)")
    for shape in (
        line,
        several,
        PolygonSet("GEOMETRYCOLLECTION (POINT (9 9), LINESTRING (0 0, 1 0))"),
    ):
        assert PolygonSet(shape.__geo_interface__) == shape
        assert PolygonSet.from_json(shape.to_json()) == shape


@pytest.mark.parametrize("kind", AS_IN_FILES)
def test_values_are_refused_for_what_files_are(kind: str) -> None:
    shape, text = AS_IN_FILES[kind]
    codes = []
    for given in (shape, text):
        with pytest.raises(minkref.BadInput) as refused:
            PolygonSet(given)
        codes.append((refused.value.code, refused.value.problem))
    assert codes[0][0] == codes[1][0]
    assert "line" not in str(refused.value.source)


def test_a_line_of_two_points_is_a_segment_and_an_empty_geometry_the_empty_set() -> None:
    assert PolygonSet(shapely.LineString(LINE[:2])) == PolygonSet(LINE[:2])
    assert PolygonSet(shapely.Point(1, 2)) == PolygonSet((1, 2))
    for empty in ((), [], {"type": "Feature", "geometry": None}, shapely.Polygon()):
        assert PolygonSet(empty).is_empty, empty
    assert PolygonSet().is_empty


def test_a_long_double_counts_by_its_exact_value() -> None:
    value = np.longdouble(1) + np.finfo(np.longdouble).eps
    made = PolygonSet([(0, 0), (value, 0), (0, 1)])
    assert made.rings()[0][0][1][0] == Fraction(*value.as_integer_ratio())


SMALL = Fraction(1, 3 * 10**320)
DOUBLE_OF_SMALL = float(SMALL)  # before a plugin may make this thread flush


def test_arrays_hold_the_nearest_doubles_and_no_infinity() -> None:
    big, small = 10**308, SMALL
    (((_, row, _),),) = PolygonSet([(0, 0), (big, small), (0, 1)]).arrays()
    assert [*row] == [1e308, DOUBLE_OF_SMALL]
    assert row[1].tobytes() == struct.pack("=d", DOUBLE_OF_SMALL) != bytes(8)
    for shape in ([(0, 0), (10**309, 0), (0, 1)], (-(10**400), 0)):
        for read in (PolygonSet.arrays, PolygonSet.approximate_rings, PolygonSet.bounding_box):
            with pytest.raises(minkref.LimitExceeded, match="beyond the range of doubles"):
                read(PolygonSet(shape))


def test_sets_without_area_are_equal_iff_they_have_the_same_points() -> None:
    """They have an empty canonical form, as regular sets without area do."""
    texts = ("POINT (1 1)", "POINT (2 2)", "LINESTRING (0 0, 2 1)", "POLYGON EMPTY")
    sets = [PolygonSet(text) for text in texts]
    for k, one in enumerate(sets):
        for other in sets[:k]:
            assert one != other
    assert len(set(sets)) == len(sets)
    turned = PolygonSet("LINESTRING (2 1, 0 0)")
    assert turned == sets[2] and hash(turned) == hash(sets[2])
    assert PolygonSet("POINT (1 1)") == sets[0]


def test_a_set_is_equal_to_sets_only() -> None:
    for other in (None, 0, "POLYGON EMPTY", [[(0, 0), (1, 0), (0, 1)]]):
        assert TRIANGLE != other and not TRIANGLE == other


@pytest.mark.parametrize("kind", ["texts", "ints", "fractions", "arrays"])
def test_vertices_of_a_polyhedron_count_by_their_exact_value(kind: str) -> None:
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    made: Any = {
        "texts": [tuple(map(str, corner)) for corner in corners],
        "ints": corners,
        "fractions": [tuple(map(Fraction, corner)) for corner in corners],
        "arrays": np.array(corners, dtype=float),
    }[kind]
    solid = Polyhedron(made, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    assert solid.points() == corners
    assert repr(solid) == "<Polyhedron: 4 vertices, 4 faces>"


def test_a_vertex_that_is_no_point_is_refused() -> None:
    with pytest.raises(minkref.BadInput, match="vertex 1 has 2 coordinates"):
        Polyhedron([(0, 0, 0), (1, 0)], [])
    with pytest.raises(minkref.Refusal, match="vertex 0: the coordinate is nan"):
        Polyhedron([(float("nan"), 0, 0)], [])


def test_a_text_of_three_characters_is_no_point_in_space() -> None:
    """Its characters were taken for coordinates, or for the factors of the axes."""
    solid = Polyhedron([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
                       [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])  # fmt: skip
    assert solid.scaled("123").points() == solid.scaled(123).points()
    assert solid.scaled("123").points()[1] == (123, 0, 0)
    with pytest.raises(TypeError, match="by has to be three exact numbers"):
        solid.translated("123")
    held = minkref.PolyhedralSet(solid)
    for ask in (lambda: Polyhedron(["123"], []), lambda: "111" in held, lambda: held.locate("111")):
        with pytest.raises(minkref.BadInput, match="is a text"):
            ask()


def test_a_text_is_no_point_of_a_certificate() -> None:
    solid = Polyhedron([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
                       [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])  # fmt: skip
    square = minkref.PolygonSet([(0, 0), (9, 0), (9, 9), (0, 9)])
    points, one = minkref.SolidPointCertificate(solid, solid), (1, 1, 1)
    plane: Any = minkref.Certificate(square, square)
    text: Any = "111"
    for ask in (
        lambda: points.point(text, one), lambda: points.point(one, text),
        lambda: points.outside(one, text), lambda: plane.point(1, "12"),
        lambda: plane.outside(1, "99"), lambda: minkref.SolidCertificate(solid, solid).sum(text),
        lambda: minkref.ConvexCertificate(solid, solid).sum(text),
    ):  # fmt: skip
        with pytest.raises(TypeError, match="exact numbers"):
            ask()


@pytest.mark.parametrize("scaling", ["2", 2, Fraction(2), (2, "2", Fraction(2))], ids=repr)
def test_a_sum_of_boxes_by_the_public_functions(scaling: Any, tmp_path: Path) -> None:
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    box = Polyhedron(corners, faces)
    file = tmp_path / "box.off"
    file.write_text(minkref.write_mesh(box, "off"), encoding="utf-8")
    body = minkref.ConvexPolyhedron(minkref.read_mesh(file))
    found = minkref.convex_sum(body, body, scaling)
    assert sorted(found.surface.points()) == sorted(tuple(3 * c for c in p) for p in corners)
    tripled, same = (minkref.ConvexPolyhedron(box.scaled(by)) for by in (3, (1, "1", Fraction(1))))
    assert minkref.ConvexPolyhedron(found.surface) == tripled != body
    assert len({body, same}) == 1
    assert repr(body) == "<ConvexPolyhedron: 8 vertices, 12 edges, 6 facets>"
    with pytest.raises(TypeError, match="scaling has to be an exact number"):
        minkref.convex_sum(body, body, (1, 2))


@pytest.mark.parametrize("kind", ["Polygon", "Point", "LineString", "MultiPoint", "MultiPolygon"])
def test_coordinates_beyond_x_and_y_are_dropped_with_a_warning(kind: str) -> None:
    """Shapes of other libraries have a Z; files with one are read with the same warning."""
    ring = [(0, 0), (4, 0), (0, 4), (0, 0)]
    flat = {
        "Polygon": [ring],
        "Point": (1, 2),
        "LineString": ring,
        "MultiPoint": ring[:3],
        "MultiPolygon": [[ring]],
    }[kind]

    def raised(given: Any) -> Any:
        if isinstance(given[0], int):
            return (*given, 7)
        return [raised(each) for each in given]

    with pytest.warns(UserWarning, match="dropped: [0-9]+ coordinates beyond x and y"):
        found = PolygonSet({"type": kind, "coordinates": raised(flat)})
    assert found == PolygonSet({"type": kind, "coordinates": flat})


def test_shapely_shapes_with_z_are_taken() -> None:
    with pytest.warns(UserWarning, match="dropped: 4 coordinates"):
        found = PolygonSet(shapely.Polygon([(0, 0, 5), (1, 0, 5), (0, 1, 6)]))
    assert found == TRIANGLE
