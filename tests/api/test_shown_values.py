"""Values show a text of one line, and pictures in a notebook; areas and volumes are attributes,
exact, and may still be called."""

from __future__ import annotations

import pickle
from fractions import Fraction
from typing import Any
from xml.etree import ElementTree

import minkref
import pytest

SQUARE = minkref.PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
FRAME = minkref.PolygonSet([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 2), (3, 2), (3, 1)]])
SIMPLEX = minkref.Polyhedron(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
)
BODY = minkref.ConvexPolyhedron(SIMPLEX)
EMPTY = minkref.PolygonSet()


def proof() -> minkref.Certificate:
    made = minkref.Certificate(SQUARE, SQUARE)
    made.sum("7/5")
    return made


TEXTS: dict[str, Any] = {
    "<Certificate: claims 1 sum>": proof,
    "<Certificate: claims none>": lambda: minkref.Certificate(SQUARE, SQUARE),
    "<ConvexCertificate: claims none>": lambda: minkref.ConvexCertificate(SIMPLEX, SIMPLEX),
    "<SolidCertificate: claims none>": lambda: minkref.SolidCertificate(SIMPLEX, SIMPLEX),
    "<SolidPointCertificate: claims none>": lambda: minkref.SolidPointCertificate(SIMPLEX, SIMPLEX),
    "<PathCertificate: claims none>": lambda: minkref.PathCertificate(SQUARE, FRAME, [(9, 9)]),
    "<ScaleIndex: scales 1 to 2>": lambda: minkref.build_index(SQUARE, FRAME, 1, 2),
    "<ScaleIndex: scales 0 to infinity>": lambda: minkref.build_index(SQUARE, SQUARE),
    "<ConvexSum: 4 vertices, 6 edges, 4 facets>": lambda: minkref.convex_sum(BODY, BODY),
}
PICTURED: dict[str, Any] = {
    "sum": lambda: minkref.minkowski_sum(FRAME, SQUARE),
    "sum of nothing": lambda: minkref.minkowski_sum(EMPTY, SQUARE),
    "offset": lambda: minkref.offset(FRAME, "1/2"),
    "erosion": lambda: minkref.erode(FRAME, SQUARE),
    "erosion to points": lambda: minkref.erode(SQUARE, SQUARE),
    "no-fit": lambda: minkref.no_fit(SQUARE, FRAME),
    "scene": lambda: minkref.Scene(SQUARE, {"a": FRAME}, [minkref.Copy("a")]),
    "decomposition": lambda: minkref.decompose(FRAME),
    "set": lambda: FRAME,
}


@pytest.mark.parametrize("text", TEXTS)
def test_a_text_of_one_line(text: str) -> None:
    assert repr(TEXTS[text]()) == text


@pytest.mark.parametrize("name", PICTURED)
def test_pictures_are_whole_documents(name: str) -> None:
    picture = PICTURED[name]()._repr_svg_()
    root = ElementTree.fromstring(picture)
    assert root.tag == "{http://www.w3.org/2000/svg}svg"


def test_a_picture_of_a_sum_has_its_tight_passages() -> None:
    found = minkref.minkowski_sum(SQUARE, FRAME)
    assert found.tight_passages
    assert 'class="tight"' in found._repr_svg_()  # type: ignore[attr-defined]


def test_events_are_a_table() -> None:
    found = minkref.events(SQUARE, FRAME, "arrangement")
    table = found._repr_html_()  # type: ignore[attr-defined]
    assert table.count("<tr>") == 1 + min(len(found), 20)
    assert f"{len(found)} arrangement events" in table


def test_area_and_volume_are_exact_attributes() -> None:
    assert FRAME.area == Fraction(14) and SQUARE.scaled("1/3").area + 1 == Fraction(10, 9)
    assert minkref.minkowski_sum(FRAME, SQUARE).area == Fraction(25)
    assert minkref.erode(FRAME, SQUARE).area == minkref.erode(FRAME, SQUARE).region.area
    assert BODY.volume == Fraction(1, 6) == minkref.PolyhedralSet(SIMPLEX).volume
    assert repr(SQUARE.area) == "Fraction(1, 1)" and f"{FRAME.area}" == "14"
    assert pickle.loads(pickle.dumps(FRAME.area)) == 14


def test_area_and_volume_may_be_called_as_before() -> None:
    assert SQUARE.scaled("1/3").area() == "1/9"
    assert minkref.PolyhedralSet(SIMPLEX).volume() == "1/6"


def test_places_of_points() -> None:
    places = [FRAME.locate(point) for point in ((0, 0), (2, "3/2"), ("1/2", "1/2"), (9, 9))]
    assert places == ["boundary", "outside", "inside", "outside"]
