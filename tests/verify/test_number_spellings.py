"""One grammar reads other programs' numbers in every place: ASCII digits, no underscores, exponents
of four digits at most. Any other text is refused at once."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.errors import Refusal
from minkref.exact import read_point, read_scale
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.region import region_of_rings
from minkref.fuzz.plane.protocol import plane_answer
from minkref.fuzz.run.case_files import scales_in
from minkref.fuzz.space.protocol import solid_answer
from minkref.fuzz.targets.declaration import PLANE, Declaration, DeclarationError, read_declaration
from minkref.fuzz.targets.numbers import Unreadable, received_scale

REFUSALS = (ValueError, Unreadable, DeclarationError, Refusal, _core.BadInput)
TEXT = Declaration("t", capabilities=PLANE | {"space"})
SECONDS = 2.0

NUMBERS = {
    "1": "1",
    "+7": "7",
    "007": "7",
    "1.": "1",
    ".5": "1/2",
    "6/4": "3/2",
    "+6/04": "3/2",
    "2e-3": "1/500",
    "1E+2": "100",
    "1.5e0002": "150",
    "4.e1": "40",
}
NO_NUMBERS = [
    "",
    "+",
    ".",
    "e5",
    "1e",
    "1/",
    "/2",
    "--1",
    "+-1",
    "1/-2",
    "1/+2",
    "1/0",
    "1/00",
    "1.5/2",
    "1/2e3",
    "1e1.5",
    "1,5",
    "0x10",
    "inf",
    "nan",
    "Infinity",
    "1_0",
    "1e1_0",
    "1/1_0",
    "1e1_000_000_000",
    "1e1000000000",
    "1e-1000000000",
    "1e00001000000000",
    "1 0",
    "1\x00",
    "\u0661",
    "\uff11",
    "1e\u0661",
    "\u00bd",
    "\u00b2",
    "\u22121",
    "1" * 100_000 + "x",
    "1/" + "0" * 99_000,
]
SPACES = [" 1", "1 ", "\n1", "1\n", "\u00a01"]  # the command line forgives them


def ring_of(text: Any) -> list[Any]:
    return [[text, "-9"], ["70000", "-9"], ["0", "9"]]


def first(ring: list[list[str]]) -> Fraction:
    (x,) = (Fraction(x) for x, y in ring if y == "-9" and x != "70000")
    return x


def set_of_an_answer(text: Any) -> Fraction:
    answer = plane_answer({"polygons": [{"outer": ring_of(text)}]}, TEXT, 0.0)
    assert answer.region is not None, answer.message
    return first(json.loads(answer.region.json)["polygons"][0]["outer"])


def rings_of_an_answer(text: Any) -> Fraction:
    answer = plane_answer({"rings": [ring_of(text)]}, TEXT, 0.0)
    assert answer.region is not None
    return first(json.loads(answer.region.json)["polygons"][0]["outer"])


def hole_of_an_answer(text: Any) -> Fraction:
    outer = [["-99", "-99"], ["90000", "-99"], ["90000", "99"], ["-99", "99"]]
    value = {"polygons": [{"outer": outer, "holes": [ring_of(text)]}]}
    answer = plane_answer(value, TEXT, 0.0)
    assert answer.region is not None
    return first(json.loads(answer.region.json)["polygons"][0]["holes"][0])


def solid_of_an_answer(text: Any) -> Fraction:
    vertices = [[text, "0", "0"], ["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    solid = solid_answer({"vertices": vertices, "faces": faces}, TEXT, 0.0).solid
    assert solid is not None
    return solid.vertices[0][0]


def scale_of_an_event(text: Any) -> Fraction:
    return Fraction(received_scale(text, TEXT))


def scale_of_an_event_under_double(text: Any) -> Fraction:
    return Fraction(received_scale(text, Declaration("t", numbers="double")))


def answer_of_a_function(text: Any) -> Fraction:
    region = region_of_rings({"polygons": [{"outer": ring_of(text), "holes": []}]}, True)
    return first(json.loads(region.json)["polygons"][0]["outer"])


def segment_of_a_function(text: Any) -> Fraction:
    """The function also looks at a ring that is no region."""
    region = region_of_rings({"polygons": [{"outer": [[text, "0"], ["9", "0"]], "holes": []}]})
    assert region.degenerate is not None
    return Fraction(region.degenerate[0])


def tolerance(text: Any) -> Fraction:
    value = {"arithmetic": "float64", "tolerance": {"relative": text}}
    return read_declaration(value, "t").relative


def unit_of_the_grid(text: Any) -> Fraction | None:
    return read_declaration({"grid": {"unit": text}}, "t").unit


def plain_json(text: Any) -> Fraction:
    value = {"polygons": [{"outer": ring_of(text), "holes": []}]}
    read = _core.PolygonSet.from_json(json.dumps(value)).to_json()
    return first(json.loads(read)["polygons"][0]["outer"])


def mesh_json(text: Any) -> Fraction:
    vertices = [[text, "0", "0"], ["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
    value = {"vertices": vertices, "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}
    surface, _ = _core.read_mesh_text(json.dumps(value).encode(), "json", "t")
    return Fraction(surface.points()[0][0])


def scale_given(text: Any) -> Fraction:
    return Fraction(read_scale(text))


def point_given(text: Any) -> Fraction:
    return Fraction(read_point(f"{text},0")[0])


def scale_of_a_solid_case(text: Any) -> Fraction:
    value = {"schema": "case-v1", "dimension": 3, "scales": [[text, text, text]]}
    return Fraction(scales_in(Path("t"), value)[0])


READERS: list[Callable[[Any], Any]] = [
    set_of_an_answer,
    rings_of_an_answer,
    hole_of_an_answer,
    solid_of_an_answer,
    scale_of_an_event,
    scale_of_an_event_under_double,
    answer_of_a_function,
    segment_of_a_function,
    tolerance,
    unit_of_the_grid,
    plain_json,
    mesh_json,
]
LENIENT: list[Callable[[Any], Any]] = [scale_given, point_given, scale_of_a_solid_case]


@pytest.mark.parametrize("reader", [*READERS, *LENIENT])
def test_a_number_is_read_as_what_it_says(reader: Callable[[Any], Any]) -> None:
    for text, value in NUMBERS.items():
        assert reader(text) == Fraction(value), text


@pytest.mark.parametrize("reader", [*READERS, *LENIENT])
def test_what_is_no_number_is_refused_at_once(reader: Callable[[Any], Any]) -> None:
    for text in [*NO_NUMBERS, *([] if reader in LENIENT else SPACES)]:
        since = time.monotonic()
        with pytest.raises(REFUSALS):
            value = reader(text)
            print(f"{text[:40]!r} was read as {str(value)[:40]}")
        assert time.monotonic() - since < SECONDS, text[:40]


@pytest.mark.parametrize("reader", READERS)
def test_values_that_are_neither_texts_nor_integers_are_refused(
    reader: Callable[[Any], Any],
) -> None:
    values: list[Any] = [True, [], {}, ["1"], {"n": 1}]
    for value in values if reader is unit_of_the_grid else [*values, None]:  # null: there is none
        with pytest.raises(REFUSALS):
            reader(value)


@pytest.mark.parametrize(
    ("interval", "scale"),
    [
        ({"from": "0", "to": "1/2"}, "1/2"),
        ({"from": "3/2"}, "3/2"),
        ({"from": "1e1000000000"}, "1"),
        ({"to": "1e-1000000000"}, "1"),
        ({"from": "1e1_000_000_000", "to": "2"}, "1"),
        ({"from": "\u0663"}, "1"),
    ],
)
def test_an_interval_whose_ends_are_no_numbers_is_left_to_the_reader(
    interval: dict[str, str], scale: str
) -> None:
    since = time.monotonic()
    assert scales_in(Path("t"), {"schema": "case-v1", "interval": interval}) == [scale]
    assert time.monotonic() - since < SECONDS


@pytest.mark.parametrize("text", [*NO_NUMBERS, *SPACES, "1.5", "1e2", ".5"])
def test_a_polyhedron_of_ours_takes_integers_and_fractions_only(text: str) -> None:
    vertices = [[text, "0", "0"], ["1", "0", "0"], ["0", "1", "0"]]
    with pytest.raises(ValueError, match=r"three exact numbers|Exceeds the limit"):
        Polyhedron.from_document({"vertices": vertices, "faces": [[0, 1, 2]]})
