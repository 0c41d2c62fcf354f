"""The judge of written numbers: its readers, computed corners, and errors to find."""

from __future__ import annotations

import struct
from typing import Any

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")
pytest.importorskip("gmpy2")

import gmpy2
from minkref.reports.evidence.as_written import (
    bulges,
    expressions,
    inputs_disc,
    inputs_plane,
    inputs_space,
    places,
    read_dxf,
    read_meshes,
    read_plane,
    read_svg,
    units,
)
from minkref.reports.evidence.as_written.covering import Neighbourhood
from minkref.reports.evidence.as_written.curves import Grown, grown
from minkref.reports.evidence.as_written.equidistant import Edge, Vertex, between, solutions
from minkref.reports.evidence.as_written.judge_plane import area_told
from minkref.reports.evidence.as_written.measures import area_and_length, bulge
from minkref.reports.evidence.as_written.tally import Tally

SQUARE = [[("0", "0"), ("1", "0"), ("1", "1"), ("0", "1")]]


@pytest.fixture(autouse=True)
def bits() -> None:
    units.use_bits()


def q(*numbers: object) -> tuple[Any, ...]:
    return tuple(gmpy2.mpq(str(number)) for number in numbers)


def unit_square() -> list[list[tuple[Any, ...]]]:
    return [[q(x, y) for x, y in SQUARE[0]]]


def square_and_disc(squared: str) -> Grown:
    sides = [("1", "0", "0"), ("0", "1", "1"), ("-1", "0", "1"), ("0", "-1", "0")]
    ring = [
        row
        for p, side in zip(SQUARE[0], sides, strict=True)
        for row in (["arc", *p], ["line", *side])
    ]
    return grown({"components": [{"outer": ring, "holes": []}], "squared_radius": squared})


def test_readers_of_sets_agree_and_keep_texts() -> None:
    wkt = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
    json = '{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}'
    poly = "1\n4 out\n0 0\n1 0\n1 1\n0 1\n1 2 3 4\n"
    plain = '{"polygons":[{"holes":[],"outer":[["0","0"],["1","0"],["1","1"],["0","1"]]}]}'
    assert read_plane.wkt(wkt) == read_plane.geojson(json) == read_plane.poly(poly) == [SQUARE]
    assert read_plane.plain_json(plain) == [SQUARE]
    assert read_plane.wkt("MULTIPOLYGON (((0 0, 1e-3 0, 1 1, 0 0)))")[0][0][1] == ("1e-3", "0")
    assert read_plane.wkt("POLYGON EMPTY") == []


@pytest.mark.parametrize(
    "text", ["POLYGON ((0 0, 1 0, 1 1))", "POLYGON ((0 0 0, 1 0 0, 1 1 0, 0 0 0))", "POINT (0 0)"]
)
def test_what_is_no_polygon_is_refused(text: str) -> None:
    with pytest.raises(ValueError):
        read_plane.wkt(text)


def test_json_with_nan_is_refused() -> None:
    with pytest.raises(ValueError):
        read_plane.load('{"area": NaN}')


def test_bulges_of_dxf_belong_to_the_vertex_before_them() -> None:
    lines = "0 SECTION 2 ENTITIES 0 LWPOLYLINE 70 1 10 0.5 20 1 42 1.0 10 2 20 3 0 ENDSEC 0 EOF"
    text = "\n".join(lines.split())
    assert read_dxf.polylines(text) == [[("0.5", "1", "1.0"), ("2", "3", "0")]]


def test_paths_of_svg_lose_the_place_that_repeats_the_first() -> None:
    (ring,) = read_svg.rings_of("M0 0L4 0A2 2 0 1 0 4 4L0 0Z")
    assert [(step.x, step.y, step.radius, step.large) for step in ring] == [
        ("0", "0", None, False), ("4", "0", None, False), ("4", "4", "2", True),
    ]  # fmt: skip
    with pytest.raises(ValueError):
        read_svg.rings_of("M0 0Lnan nanZ")


def test_readers_of_meshes_agree() -> None:
    corners = [("0", "0", "0"), ("0", "1", "0"), ("1", "0", "0"), ("0", "0", "0.5")]
    faces = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
    rows = [" ".join(corner) for corner in corners]
    counted = [f"3 {a} {b} {c}" for a, b, c in faces]
    off = "\n".join(["OFF", "4 4 6", *rows, *counted])
    obj = "\n".join(
        [f"v {row}" for row in rows] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    )
    head = ["ply", "format ascii 1.0", "element vertex 4", "element face 4", "end_header"]
    assert read_meshes.off(off) == read_meshes.obj(obj) == (corners, faces)
    assert read_meshes.ply("\n".join([*head, *rows, *counted])) == (corners, faces)
    triangle = struct.pack("<12fH", *[0.0] * 3, *[0.0] * 3, *[1.0] * 3, *[0.5] * 3, 0)
    binary = b"\0" * 80 + struct.pack("<I", 1) + triangle
    assert read_meshes.stl(binary) == ([(0, 0, 0), (1, 1, 1), (0.5, 0.5, 0.5)], [[0, 1, 2]])
    text = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1/3 0\n"
    assert read_meshes.stl(f"{text}endloop\nendfacet\nendsolid a\n".encode())[0][2] == (
        "0",
        "1/3",
        "0",
    )


def test_expressions_have_roots() -> None:
    assert expressions.value("1/2 - 3/4*(2 - 1)") == gmpy2.mpq(-1, 4)
    assert abs(expressions.value("-sqrt(2)*sqrt(8)") + 4) < gmpy2.mpq(1, 2**1400)


def test_own_corners_area_and_length_of_a_square_and_a_disc() -> None:
    of = square_and_disc("1/4")
    starts = [piece.start for piece in of.rings[0]]
    assert starts[:3] == [q("-1/2", 0), q(0, "-1/2"), q(1, "-1/2")]
    area, length = area_and_length(of)
    pi = gmpy2.const_pi()
    small = gmpy2.mpq(1, 10**400)
    assert abs(area - (3 + pi / 4)) < small and abs(length - (4 + pi)) < small
    assert abs(bulge(of.rings[0][0]) - (gmpy2.sqrt(gmpy2.mpfr(2)) - 1)) < small


def test_own_corner_in_front_of_a_vertex_that_is_nearly_straight() -> None:
    """A line enters the offset of a line steeper by 1e-30."""
    tiny = "1/1000000000000000000000000000000"
    rows = [["line", "1", "0", "0"], ["line", "1000000000000000000000000000000", "1", "0"]]
    form = {"components": [{"outer": rows, "holes": []}], "squared_radius": "1"}
    start = grown(form).rings[0][0].start
    assert start is not None and start[1] == -1
    assert abs(start[0] - gmpy2.mpq(tiny) / 2) < gmpy2.mpq(1, 10**80)


def test_unit_in_the_last_place_and_digits_printed() -> None:
    third = gmpy2.mpq(1, 3)
    assert units.is_double_of(units.exact_double(1 / 3), third)
    assert not units.is_double_of(units.exact_double(0.33333333333333348), third)
    assert not units.is_double_of(units.exact_double(1e-17), gmpy2.mpq(0))
    assert units.is_rounded("0.333", third) and not units.is_rounded("0.334", third)
    assert units.is_rounded("3.3e-1", third) and not units.is_rounded("0.33330", third)


def test_inside_is_inside_and_around_is_around() -> None:
    near = Neighbourhood(unit_square(), gmpy2.mpq(1))
    ring = [q(-1, 0), q(0, -1), q(1, -1), q(2, 0), q(2, 1), q(1, 2), q(0, 2), q(-1, 1)]
    assert near.outside_of([ring]) == []
    ring[0] = q("-1.0000000000000000001", 0)
    assert len(near.outside_of([ring])) == 2
    box = [q(-1, -1), q(2, -1), q(2, 2), q(-1, 2)]
    assert near.met_by([box]) == []
    assert len(near.met_by([[*box[:3], q("-0.9999999999999999999", 2)]])) == 1
    assert near.outside_of([box])  # its corners are farther than the radius


def test_nothing_is_inside_of_a_segment() -> None:
    near = Neighbourhood([[q(0, 0), q(0, 9)]], gmpy2.mpq(1))
    assert near.met_by([[q(-2, -2), q(2, -2), q(2, 11), q(-2, 11)]]) == []
    assert not near.has(q(-2, 1))


def test_an_edge_across_several_edges_is_covered_by_all_of_them() -> None:
    """No edge of the comb is as near to both ends as the radius."""
    comb = [q(0, 0), q(9, 0), q(9, 1), q(0, 1)]
    split = [*comb[:2], *[q(x, 1) for x in range(9, -1, -1)]]
    near = Neighbourhood([split], gmpy2.mpq(1, 4))
    inside = [q(1, "3/2"), q(8, "3/2"), q(8, "1/2"), q(1, "1/2")]
    assert near.outside_of([inside]) == []
    assert near.outside_of([[q(1, "3/2"), q(8, "16/10"), q(8, "1/2")]])


def test_a_corner_that_is_wrong_is_found_and_a_right_one_is_not() -> None:
    of, tally = square_and_disc("1/4"), Tally()
    right = [(-0.5, 0.0), (0.0, -0.5), (1.0, -0.5), (1.5, 0.0),
             (1.5, 1.0), (1.0, 1.5), (0.0, 1.5), (-0.5, 1.0)]  # fmt: skip
    places.compare(tally, "file", right, of)
    assert not tally.wrong
    places.compare(tally, "file", [(-0.5000000000000002, 0.0), *right[1:], (9.0, 9.0)], of)
    assert len(tally.wrong) == 2 and tally.numbers["file"] == 34


@pytest.mark.parametrize(
    ("parts", "right"),
    [
        (["0.41421356237309503"], True),
        (["0.4142135623730952"], False),
        (["0.41421356237309153", "3e-15"], True),  # cut where doubles see no length
        (["0.41421356237309153", "3e-14"], False),
    ],
)
def test_an_arc_in_parts_is_all_of_the_arc(parts: list[str], right: bool) -> None:
    of, tally = square_and_disc("1/4"), Tally()
    sides = [("-0.5", "0", parts[0]), *[("0", "-0.5", part) for part in parts[1:]]]
    bulges.compare(tally, [*sides, ("0", "-0.5", "0"), ("1", "-0.5", "0")], of)
    assert (not tally.wrong) == right


def test_places_as_far_from_their_features() -> None:
    a, b, c = Vertex(*q(0, 0)), Vertex(*q(4, 0)), Vertex(*q(0, 2))
    assert between(a, b) == (*q(2, 0), 2)
    (found,) = {tuple(map(float, one)) for one in solutions([a, b, c])}
    assert found == (2.0, 1.0, 5**0.5)
    floor, ceiling = Edge(b, a), Edge(c, Vertex(*q(4, 2)))  # 2 apart, the set beyond them
    facing = {tuple(map(float, one)) for one in solutions([floor, ceiling, Vertex(*q(9, 1))])}
    assert facing == {(8.0, 1.0, 1.0), (10.0, 1.0, 1.0)}


@pytest.mark.parametrize(
    ("draw", "kinds", "count"),
    [
        (inputs_disc.drawn, inputs_disc.kinds, 1500),
        (inputs_plane.pair, inputs_plane.kinds, 800),
        (inputs_space.solids, inputs_space.kinds, 200),
    ],
)
def test_each_kind_is_drawn(draw: Any, kinds: Any, count: int) -> None:
    assert {draw(46, index).kind for index in range(count)} == kinds()


@pytest.mark.parametrize(
    ("line", "right"),
    [
        ("area  3.94973545", True),
        ("area  1493/378, about 3.94973545", True),
        ("area  3.94973545 = 1493/378", False),
        ("area  1493/378, about 3.94973546", False),
        ("area  1493/379, about 3.94973545", False),
        ("volume  about 3.9497 (7 characters; --json prints it)", True),
        ("volume  3.9497 = (7 characters; --json prints it)", False),
    ],
)
def test_an_area_is_told_as_it_is(line: str, right: bool) -> None:
    tally = Tally()
    area_told(tally, "table", f"sum  g1 + g2\n{line}\nholes  1\n", gmpy2.mpq(1493, 378))
    assert (not tally.wrong) == right
