"""DXF and SVG as operands: exact decimals, curves within the tolerance, refusals."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from minkref import read_file
from minkref.drawings.curves import arc_by_angles, arc_by_bulge, bezier, circle
from minkref.drawings.drawing import read_drawing
from minkref.errors import Refusal

T = Fraction(1, 1000)
SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'
INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
Points = list[tuple[Fraction, Fraction]]


def of_svg(folder: Path, body: str, **options: Any) -> Any:
    (folder / "a.svg").write_text(SVG.format(body))
    return read_drawing(folder / "a.svg", **options)


def dxf_text(*entities: str, header: str = "") -> str:
    """Groups are written as `0 LINE|8 CUT|10 0.1`."""
    groups = ["0 SECTION|2 HEADER", header, "0 ENDSEC", "0 SECTION|2 ENTITIES", *entities]
    lines = "|".join(group for group in [*groups, "0 ENDSEC", "0 EOF"] if group).split("|")
    return "".join(
        f"{code}\n{value}\n" for code, _, value in (line.partition(" ") for line in lines)
    )


def of_dxf(folder: Path, *entities: str, header: str = "", **options: Any) -> Any:
    (folder / "a.dxf").write_text(dxf_text(*entities, header=header))
    return read_drawing(folder / "a.dxf", **options)


def refused(read: Callable[[], object]) -> Refusal:
    with pytest.raises(Refusal) as caught:
        read()
    return caught.value


def polyline(points: str, layer: str = "0", more: str = "") -> str:
    corners = "|".join(f"10 {x}|20 {y}" for x, y in (p.split(",") for p in points.split()))
    return f"0 LWPOLYLINE|8 {layer}|70 1{more}|{corners}"


def line(ax: str, ay: str, bx: str, by: str) -> str:
    return f"0 LINE|8 0|10 {ax}|20 {ay}|11 {bx}|21 {by}"


def test_decimals_of_both_formats_are_exact(tmp_path: Path) -> None:
    square = "0.1,0.2 1.1,0.2 1.1,1.2 0.1,1.2"
    for found, _ in (
        of_dxf(tmp_path, polyline(square)),
        of_svg(tmp_path, f'<polygon points="{square}"/>'),
        of_svg(tmp_path, '<path d="M.1.2h1v1h-1z"/>'),
        of_svg(
            tmp_path, '<rect x="-.1" y=".2" width="1" height="1e0" transform="translate(0.2,0)"/>'
        ),
    ):
        assert {Fraction(1, 10), Fraction(11, 10)} == {x for x, _ in found.rings()[0][0]}
        assert found.area() == "1"


def test_rings_of_a_dxf_file_nest(tmp_path: Path) -> None:
    squares = ["0,0 9,0 9,9 0,9", "1,1 8,1 8,8 1,8", "2,2 4,2 4,4 2,4", "20,0 21,0 21,1"]
    found, _ = of_dxf(tmp_path, *map(polyline, squares))
    assert [len(rings) for rings in found.rings()] == [2, 1, 1]
    assert Fraction(found.area()) == 81 - 49 + 4 + Fraction(1, 2)
    found.validate()


def test_lines_and_arcs_that_close_are_a_ring(tmp_path: Path) -> None:
    slot = [
        line("0", "0", "4", "0"),
        line("4", "3", "0", "3"),
        "0 ARC|8 0|10 4|20 1.5|40 1.5|50 270|51 90",
        line("0", "0", "0", "3"),
    ]
    found, warnings = of_dxf(tmp_path, *slot, tolerance=T)
    assert 0 < 12 + math.pi * 1.125 - float(Fraction(found.area())) < 0.005
    assert any("within 1/1000" in warning for warning in warnings)
    assert refused(lambda: of_dxf(tmp_path, *slot)).code == "no-tolerance"


def test_a_gap_is_refused_with_its_place_and_closed_by_weld(tmp_path: Path, minkref: Any) -> None:
    lines = [line("0", "0", "4", "0"), line("4", "0.001", "4", "4"), line("4", "4", "0", "0")]
    error = refused(lambda: of_dxf(tmp_path, *lines))
    assert error.code == "open-chain" and "ends at (4, 0)" in error.what
    ran = minkref("repair", tmp_path / "a.dxf", "--weld", "1/100", "-o", tmp_path / "b.json")
    assert ran.code == 0
    assert "(4, 1/1000) moved to (4, 0), squared distance 1/1000000" in ran.out
    assert json.loads((tmp_path / "b.json").read_text())["polygons"][0]["outer"] == [
        ["0", "0"], ["4", "0"], ["4", "4"],
    ]  # fmt: skip


def test_layers_units_and_what_is_left_out_are_told(tmp_path: Path) -> None:
    entities = [
        polyline("0,0 2,0 2,2", "CUT", "|38 7"), polyline("5,0 6,0 6,1", "MARK"), "0 TEXT|8 0|1 a",
    ]  # fmt: skip
    header = "9 $INSUNITS|70 4"
    found, warnings = of_dxf(tmp_path, *entities, header=header)
    assert found.area() == "5/2"
    told = " ".join(warnings)
    for words in ("millimetres", "layers are read together: CUT, MARK", "heights", "1 TEXT"):
        assert words in told
    assert of_dxf(tmp_path, *entities, layer="CUT")[0].area() == "2"
    assert "choose one of CUT, MARK" in refused(lambda: of_dxf(tmp_path, *entities, layer="X")).mend


@pytest.mark.parametrize(
    ("entity", "code"),
    [
        ("0 SPLINE|8 0", "unsupported-geometry"),
        ("0 INSERT|8 0|2 A", "unsupported-geometry"),
        ("0 CIRCLE|8 0|10 0|20 0|40 1|210 1|230 0", "three-dimensional"),
        ("0 CIRCLE|8 0|10 0|20 0|40 -1", "not-a-number"),
        ("0 CIRCLE|8 0|10 nan|20 0|40 1", "coordinate-not-a-number"),
        ("0 LINE|8 0|10 0|20 0", "missing-member"),
        ("0 POLYLINE|70 8", "unsupported-geometry"),
    ],
)
def test_other_entities_are_refused_with_their_line(tmp_path: Path, entity: str, code: str) -> None:
    error = refused(lambda: of_dxf(tmp_path, entity, tolerance=T))
    assert error.code == code and str(tmp_path / "a.dxf") in error.where


def test_a_drawing_of_ezdxf_is_read_as_ezdxf_has_it(tmp_path: Path) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.new("R2010")
    space = drawing.modelspace()
    corners = [(0.1, 0, 0.5), (4.7, 0, 0), (4, 3.3, -0.25), (0, 3, 0)]
    space.add_lwpolyline(corners, format="xyb", close=True)
    space.add_polyline2d([(9, 0), (12, 0), (12, 2)], close=True)
    mirrored = {"extrusion": (0, 0, -1)}
    space.add_lwpolyline(
        [(-20, 0, 0.3), (-22, 0, 0), (-22, 1, 0)], format="xyb", close=True, dxfattribs=mirrored
    )
    drawing.saveas(tmp_path / "a.dxf")
    found, _ = read_drawing(tmp_path / "a.dxf", T)
    from ezdxf import path as paths

    wanted = 0.0
    for entity in space:
        points = [*paths.make_path(entity).flattening(1e-6)]
        wanted += abs(sum(a.x * b.y - a.y * b.x for a, b in pairwise(points))) / 2
    assert abs(float(Fraction(found.area())) - wanted) < 0.02
    assert max(x for rings in found.rings() for x, _ in rings[0]) == 22


@pytest.mark.parametrize(
    ("body", "area"),
    [
        ('<path d="M0 0h4v4h-4zM1 1v2h2V1z"/>', 12.0),
        ('<path d="M0 0h4v4h-4zM1 1h2v2H1z"/>', 16.0),
        ('<path fill-rule="evenodd" d="M0 0h4v4h-4zM1 1h2v2H1z"/>', 12.0),
        ('<g style="fill-rule:evenodd"><path d="M0 0h4v4h-4zM1 1h2v2H1z"/></g>', 12.0),
        ('<g transform="translate(5) rotate(90 1 2) scale(2,3)"><path d="M0,0H1V1H0"/></g>', 6.0),
        ('<rect width="2" height="2"/><rect x="1" width="2" height="2"/>', 6.0),
        ('<circle cx="1" cy="2" r="3"/>', 9 * math.pi),
        ('<ellipse rx="3" ry="2" transform="matrix(1 0 .5 1 0 0)"/>', 6 * math.pi),
        ('<path d="M0 0a2 2 0 0 1 4 0z"/>', 2 * math.pi),
        ('<path d="M0 0a4 2 90 1 0 4 0z"/>', None),
        ('<path d="M2 0a2 1 30 11-4 0 2 1 30 11 4 0"/>', None),
        ('<path d="M0 0C0 3 4 3 4 0S8-3 8 0z"/>', 14.4),
        ('<path d="M0 0Q2 4 4 0T8 0"/>', 2 * 16 / 3),
        ('<rect width="4" height="4" rx="1"/>', 12 + math.pi),
        ('<defs><rect width="9" height="9"/></defs><rect width="1" height="1"/>', 1.0),
        ('<g display="none"><rect width="9" height="9"/></g>', 0.0),
    ],
)
def test_shapes_of_svg_are_what_they_fill(tmp_path: Path, body: str, area: float | None) -> None:
    found, _ = of_svg(tmp_path, body, tolerance=T)
    found.validate()
    if area is not None:
        assert abs(float(Fraction(found.area())) - area) < 0.03


def test_layers_of_inkscape_and_hidden_text_are_told(tmp_path: Path) -> None:
    body = (
        f'<g {INKSCAPE} inkscape:groupmode="layer" inkscape:label="a">'
        '<rect width="2" height="2"/></g>'
        f'<g {INKSCAPE} inkscape:groupmode="layer" id="b"><rect x="5" width="1" height="1"/></g>'
        "<text>x</text>"
    )
    found, warnings = of_svg(tmp_path, body)
    assert found.area() == "5" and "left out: 1 text" in " ".join(warnings)
    assert of_svg(tmp_path, body, layer="b")[0].area() == "1"


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ('<path d="M0 0 L1"/>', "syntax"),
        ('<path d="L1 1"/>', "syntax"),
        ('<rect width="3mm" height="1"/>', "syntax"),
        ('<use href="#a"/>', "unsupported-geometry"),
        ('<g transform="turn(3)"/>', "syntax"),
        ('<circle r="1"/>', "no-tolerance"),
        ("<g>", "syntax"),
        ('<polygon points="0 0 1"/>', "syntax"),
    ],
)
def test_other_svg_is_refused_with_its_element(tmp_path: Path, body: str, code: str) -> None:
    assert refused(lambda: of_svg(tmp_path, body)).code == code


def distance_to_circle(points: Points, center: tuple[float, float], radius: float) -> float:
    """The largest distance of corners and middles of edges from a circle."""
    return max(
        abs(math.hypot(float(x) - center[0], float(y) - center[1]) - radius)
        for a, b in pairwise(points)
        for x, y in (a, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2))
    )


@pytest.mark.parametrize("tolerance", [Fraction(1), Fraction(1, 7), T, Fraction(1, 10**5)])
def test_polylines_are_within_the_tolerance_and_not_much_finer(tolerance: Fraction) -> None:
    most = float(tolerance)
    three = Fraction(3)
    arcs = [circle((Fraction(0), Fraction(0)), three, tolerance)]
    arcs.append(
        arc_by_angles((Fraction(0), Fraction(0)), three, Fraction(20), Fraction(301), tolerance)
    )
    for points in arcs:
        assert distance_to_circle(points, (0, 0), 3) <= most * 1.0001
        assert len(points) < 4 * math.pi * math.sqrt(3 / most) + 8
    p, q = (Fraction(0), Fraction(0)), (Fraction(2), Fraction(0))
    for bulge in (Fraction(1), Fraction(-1, 3), Fraction(5, 2)):
        points = [p, *arc_by_bulge(p, q, bulge, tolerance)]
        assert points[-1] == q
        b = float(bulge)
        center, radius = (1, (1 - b * b) / (2 * b)), (1 + b * b) / abs(2 * b)
        assert distance_to_circle(points, center, radius) <= most * 1.0001
    # The parabola y = x² from -1 to 1: chords lie above it, by a quarter of their squared width.
    parabola = [(Fraction(x), Fraction(y)) for x, y in ((-1, 1), (0, -1), (1, 1))]
    points = [parabola[0], *bezier(parabola, tolerance)]
    assert all(abs(float(y - x * x)) <= most / 30 for x, y in points)
    assert max(float(b[0] - a[0]) ** 2 / 4 for a, b in pairwise(points)) < 4 * most


COMMANDS = ("sum {} g1", "events {} g1", "erode g1 {}", "union {}", "features {}", "sum {} disc:1")


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_take_drawings_by_their_ending(minkref: Any, tmp_path: Path, command: str) -> None:
    (tmp_path / "a.dxf").write_text(dxf_text(polyline("0,0 1,0 0,1")))
    ran = minkref(*(word.format(tmp_path / "a.dxf") for word in command.split()), "--json")
    assert ran.code == 0, ran.out


def test_a_sum_written_as_dxf_is_read_as_the_same_set(minkref: Any, tmp_path: Path) -> None:
    pytest.importorskip("ezdxf")
    words = [
        "POLYGON((0 0,1 0,1 1,0 1,0 0))",
        "POLYGON((0 0,8 0,8 8,0 8,0 0),(3 3,3 5,5 5,5 3,3 3))",
    ]
    first = json.loads(minkref("sum", *words, "-o", tmp_path / "a.dxf", "--json").out)
    assert first["output_exact"] is True
    again = json.loads(minkref("union", tmp_path / "a.dxf", "--json").out)
    assert again["digest"] == first["digest"] and again["holes"] == 1


def test_curves_of_too_many_corners_are_refused(tmp_path: Path) -> None:
    for text in ("0 CIRCLE|8 0|10 0|20 0|40 1e30", "0 ARC|8 0|10 0|20 0|40 1e400|50 1|51 9"):
        error = refused(lambda text=text: of_dxf(tmp_path, text, tolerance=T))  # type: ignore[misc]
        assert error.code == "too-many-vertices"
    for body in ('<circle r="1e30"/>', '<path d="M0 0Q1e30 0 0 1e30"/>'):
        error = refused(lambda body=body: of_svg(tmp_path, body, tolerance=T))  # type: ignore[misc]
        assert error.code == "too-many-vertices"


def test_group_codes_are_decimal_digits(tmp_path: Path) -> None:
    (tmp_path / "a.dxf").write_text("\u00b32\nSECTION\n")
    assert refused(lambda: read_drawing(tmp_path / "a.dxf")).code == "syntax"


def test_python_reads_drawings_by_their_ending(tmp_path: Path) -> None:
    (tmp_path / "a.dxf").write_text(dxf_text(polyline("0,0 1,0 0,1")))
    assert read_file(tmp_path / "a.dxf").area() == "1/2"


def test_read_file_issues_the_warnings_of_a_drawing(tmp_path: Path) -> None:
    text = '<svg xmlns="http://www.w3.org/2000/svg"><text>a</text><path d="M0 0L9 0L0 9Z"/></svg>'
    (tmp_path / "a.svg").write_text(text)
    with pytest.warns(UserWarning, match="a.svg: left out: 1 text"):
        assert read_file(tmp_path / "a.svg").vertices == 3


def test_options_of_drawings_are_refused_for_other_operands(minkref: Any) -> None:
    ran = minkref("repair", "POINT (0 0)", "--layer", "a", "--tolerance", "1")
    assert ran.code == 2 and "no drawing" in ran.err


def test_a_dxf_file_that_ends_early_is_refused(tmp_path: Path) -> None:
    """Half a drawing is no drawing."""
    whole = dxf_text(polyline("0,0 4,0 4,4"), polyline("9,0 9,4 12,0"))
    (tmp_path / "a.dxf").write_text(whole[: whole.index("ENDSEC", whole.index("ENTITIES")) - 3])
    assert refused(lambda: read_drawing(tmp_path / "a.dxf")).code == "truncated"


def test_texts_in_old_encodings_end_no_line(tmp_path: Path) -> None:
    """The byte 85 is an ellipsis in Windows-1252, and a line's end elsewhere."""
    text = dxf_text("0 TEXT|8 0|1 see below*", polyline("0,0 4,0 4,4")) + "\n\n"
    (tmp_path / "a.dxf").write_bytes(text.encode().replace(b"*", bytes([0x85])))
    found, told = read_drawing(tmp_path / "a.dxf")
    assert (found.area(), told) == ("8", [f"{tmp_path / 'a.dxf'}: left out: 1 TEXT"])
