"""The slow engine's reader: exact numbers, and clear words about what is no operand."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest
from minkref.oracle.slow import InputError, read_operand
from minkref.oracle.slow.exact import number

SQUARE = [(Fraction(x), Fraction(y)) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))]


def written(folder: Path, name: str, text: str) -> str:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.1", Fraction(1, 10)),
        ("-3/7", Fraction(-3, 7)),
        ("1e400", Fraction(10**400)),
        ("2.5E-3", Fraction(1, 400)),
        (".5", Fraction(1, 2)),
        ("12345678901234567890123456789", Fraction(12345678901234567890123456789)),
    ],
)
def test_number_is_what_its_text_names(text: str, value: Fraction) -> None:
    assert number(text) == value


@pytest.mark.parametrize(
    "text",
    [
        "",
        "NaN",
        "Infinity",
        "1/0",
        "0x1",
        "1_0",
        "1e99999",
        "1" * 5000,
        "1/" + "0" * 3,
        "٣",
        "1/-2",
    ],
)
def test_what_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(InputError):
        number(text)


def test_rings_are_turned_and_their_closing_vertex_is_dropped(tmp_path: Path) -> None:
    text = "polygon ((0 0, 0 9, 9 9, 9 0, 0 0), (1 1, 2 1, 1 2, 1 1))"
    found = read_operand(written(tmp_path, "a.wkt", text))
    ring = found.polygons[0].outer
    at = ring.index(SQUARE[0])
    assert ring[at:] + ring[:at] == SQUARE
    assert len(found.polygons[0].holes) == 1


@pytest.mark.parametrize(
    ("text", "ends", "polygons"),
    [
        ("POINT (1/3 2)", 1, 0),
        ("LINESTRING (0 0, 1 1)", 2, 0),
        ("POLYGON EMPTY", 0, 0),
        ("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))", 0, 2),
        ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), POLYGON EMPTY)", 0, 1),
    ],
)
def test_geometries_of_well_known_text(tmp_path: Path, text: str, ends: int, polygons: int) -> None:
    found = read_operand(written(tmp_path, "a.wkt", text))
    assert (len(found.ends), len(found.polygons)) == (ends, polygons)


def test_poly_splits_two_numbers_run_together_and_finds_the_outer_ring(tmp_path: Path) -> None:
    text = "3\n4 out\n0 0\n9 0\n9 9\n0 9\n1 2 3 4\n3 out\n20 0 # far\n21 0\n20 1\n3 in\n1 1\n1 2\n"
    found = read_operand(written(tmp_path, "a.poly", text + "7.84688.042924\n1 2 3\n"))
    assert [len(part.holes) for part in found.polygons] == [1, 0]
    assert (Fraction("7.84688"), Fraction("0.042924")) in found.polygons[0].holes[0]


def test_poly_has_comments_at_the_start_of_words_only(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="#IND"):
        read_operand(written(tmp_path, "a.poly", "1\n3 out\n0 -1.#IND\n1 0\n0 1\n"))


def test_json_numbers_never_pass_through_a_double(tmp_path: Path) -> None:
    text = '{"polygons":[{"outer":[[0,0],[0.1,0],[0,12345678901234567891]]}]}'
    ring = read_operand(written(tmp_path, "a.json", text)).polygons[0].outer
    assert (Fraction(1, 10), Fraction(0)) in ring
    assert (Fraction(0), Fraction(12345678901234567891)) in ring


def test_operands_of_a_case_are_named_and_their_orientation_counts(tmp_path: Path) -> None:
    ring = [["0", "0"], ["1", "0"], ["0", "1"]]
    sides = {"P": ring, "Q": [["5", "5"]]}
    case = {"schema": "case-v1", "id": "one", "dimension": 2, "scales": ["1"]}
    case |= {k: {"polygons": [{"outer": r}]} for k, r in sides.items()}
    name = written(tmp_path, "case.json", json.dumps(case))
    assert len(read_operand(name + "#P").polygons) == 1
    assert read_operand(name + "#Q").ends == [(Fraction(5), Fraction(5))]
    case["P"] = {"polygons": [{"outer": ring[::-1]}]}
    written(tmp_path, "case.json", json.dumps(case))
    with pytest.raises(InputError, match="wrong way"):
        read_operand(name + "#P")


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.wkt", "POLYGON ((0 0, 1 0, 0 1))", "repeats its first"),
        ("a.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0)", "expected"),
        ("a.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0)) x", "after the geometry"),
        ("a.wkt", "POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))", "expected"),
        ("a.wkt", "CIRCLE (0 0)", "no geometry"),
        ("a.wkt", "POLYGON ((0 0, 1 1, 2 2, 0 0))", "area"),
        ("a.wkt", "POLYGON ((0 0, 0 0, 1 1, 0 1, 0 0))", "repeats the one before"),
        ("a.json", '{"polygons":[{"outer":[[0,0],[1,0],[0,1]],"hole":[]}]}', "unknown member"),
        ("a.json", '{"polygons":[],"polygons":[]}', "twice"),
        ("a.json", '{"polygons":[{"outer":[[0,0],[NaN,0],[0,1]]}]}', "not a number"),
        ("a.json", '{"polygons":[{"outer":[[0,0]]},{"outer":[[1,0]]}]}', "alone"),
        ("a.json", '{"polygons":[{"outer":[[0,0],[0,0]]}]}', "different ends"),
        ("a.json", '{"polygons":[{"outer":[]}]}', "different ends"),
        ("a.json", '{"polygons":[{"outer":[[true,0],[1,0],[0,1]]}]}', "coordinate"),
        ("a.json", "{", "no JSON"),
        ("a.json", "[" * 100000, "no JSON"),
        ("a.json", "[]", "polygons"),
        ("a.poly", "1\n3 out\n0 0\n1 0", "poly"),
        ("a.poly", "", "poly"),
        ("a.poly", "1\n3 in\n0 0\n1 0\n0 1\n", "no outer ring"),
        ("a.txt", "POINT (0 0)", "none of"),
    ],
)
def test_malformed_text_is_refused_with_its_file(
    tmp_path: Path, name: str, text: str, words: str
) -> None:
    path = written(tmp_path, name, text)
    with pytest.raises(InputError, match=words) as refused:
        read_operand(path)
    assert path in str(refused.value)


def test_missing_files_and_binary_ones_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read"):
        read_operand(str(tmp_path / "none.wkt"))
    (tmp_path / "b.wkt").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="cannot be read"):
        read_operand(str(tmp_path / "b.wkt"))
