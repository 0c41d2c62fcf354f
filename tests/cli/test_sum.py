"""`minkref sum`: results, documents, files."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]


def canonical_text(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), sort_keys=True)


def test_sum_of_two_squares_is_the_square_of_the_summed_sides(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    value = minkref("sum", *squares, "--scale", "3/2", "--json").json
    assert value["area"] == "16"
    assert value["area_approximate"] == 16.0
    assert (value["components"], value["holes"], value["vertices"]) == (1, 0, 4)
    assert value["result"] == {
        "polygons": [{"holes": [], "outer": [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]}]
    }


def test_digest_is_the_sha256_of_the_canonical_json(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    value = minkref("sum", *squares, "--scale", "1/3", "--json").json
    expected = hashlib.sha256(canonical_text(value["result"]).encode()).hexdigest()
    assert value["digest"] == expected


def test_document_follows_the_published_schema(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    jsonschema.Draft202012Validator.check_schema(schema("sum"))
    for extra in (
        [],
        ["--arithmetic", "double"],
        ["--arithmetic", "mpfr:24"],
        ["--route", "winding"],
    ):
        ran = minkref("sum", *squares, "--json", *extra)
        assert (ran.code, ran.err) == (0, "")
        jsonschema.validate(ran.json, schema("sum"))


FRAME = "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,2 1,1 1))"


@pytest.mark.parametrize("route", ["paper", "winding", "definition"])
def test_peg_that_fits_a_hole_exactly_is_a_tight_passage_with_what_it_touches(
    minkref: Minkref, tmp_path: Path, squares: tuple[Path, Path], route: str
) -> None:
    frame = tmp_path / "frame.wkt"
    frame.write_text(FRAME, encoding="utf-8")
    value = minkref("sum", frame, squares[1], "--route", route, "--json").json
    jsonschema.validate(value, schema("sum"))
    # Each side of the hole at the peg's first vertex along that side.
    sides = [((1, 0), (0, 2)), ((1, 1), (0, 1)), ((1, 2), (0, 0)), ((1, 3), (0, 3))]
    contacts = [{"kind": "S", "edge": list(edge), "vertex": list(vertex)} for edge, vertex in sides]
    assert value["tight_passages"] == [{"points": [["2", "2"]], "contacts": [contacts]}]
    assert "1 point" in minkref("sum", frame, squares[1]).out


def test_tight_passages_are_null_for_another_arithmetic_than_rational(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    assert minkref("sum", *squares, "--json").json["tight_passages"] == []
    for arithmetic in ("interval", "double", "mpfr:53"):
        value = minkref("sum", *squares, "--arithmetic", arithmetic, "--json").json
        assert value["tight_passages"] is None
    assert "null" in result_schema("sum")["properties"]["tight_passages"]["description"]


@pytest.mark.parametrize(
    ("text", "exact"),
    [
        ("0.1", "1/10"),
        ("7/5", "7/5"),
        ("14/10", "7/5"),
        ("1e-3", "1/1000"),
        ("+2", "2"),
        (".5", "1/2"),
    ],
)
def test_scale_is_the_exact_number_that_its_text_says(
    minkref: Minkref, squares: tuple[Path, Path], text: str, exact: str
) -> None:
    value = minkref("sum", *squares, "--scale", text, "--json").json
    assert value["scale"] == exact
    assert Fraction(value["area"]) == (2 * Fraction(exact) + 1) ** 2


def test_all_routes_have_one_digest(minkref: Minkref) -> None:
    digests = {
        minkref("sum", "g1", "g3", "--scale", "7/5", "--route", route, "--json").json["digest"]
        for route in ("paper", "winding", "definition")
    }
    assert len(digests) == 1


def test_sum_is_commutative(minkref: Minkref) -> None:
    one = minkref("sum", "g1", "g2", "--json").json
    other = minkref("sum", "g2", "g1", "--json").json
    assert one["digest"] == other["digest"]


@pytest.mark.parametrize("arithmetic", ["interval", "double", "mpfr:53", "mpfr:256"])
def test_other_arithmetics_report_what_is_true_beside_what_they_got(
    minkref: Minkref, arithmetic: str
) -> None:
    exact = minkref("sum", "g1", "g2", "--scale", "7/5", "--json").json
    value = minkref("sum", "g1", "g2", "--scale", "7/5", "--arithmetic", arithmetic, "--json").json
    assert exact["exact"] is None
    assert value["exact"]["digest"] == exact["digest"]
    assert value["exact"]["area"] == exact["area"]
    same = None if value["undecided"] else value["digest"] == exact["digest"]
    assert value["exact"]["equal"] is same
    if arithmetic == "interval" and not value["undecided"]:
        assert value["exact"]["equal"]


def test_shares_of_the_signs_add_up(minkref: Minkref) -> None:
    signs = minkref("sum", "glyph275", "g1", "--json").json["signs"]
    assert signs["by_float"] + signs["by_integer"] + signs["by_rational"] == signs["total"] > 0
    assert sum(signs["shares"].values()) == pytest.approx(1)


@pytest.mark.parametrize("ending", ["wkt", "geojson", "poly", "json"])
def test_written_file_is_read_back_as_the_same_set_where_it_says_so(
    minkref: Minkref, squares: tuple[Path, Path], tmp_path: Path, ending: str
) -> None:
    for scale in ("1/4", "1/3"):
        output = tmp_path / f"sum.{ending}"
        ran = minkref("sum", *squares, "--scale", scale, "--json", "-o", output)
        assert (ran.code, ran.json["output"]) == (0, str(output))
        assert ran.json["output_exact"] == (scale == "1/4" or ending == "json")
        text = _core.read_file(str(output)).canonical_json()
        same = hashlib.sha256(text.encode()).hexdigest() == ran.json["digest"]
        assert same == ran.json["output_exact"]


def test_svg_is_well_formed_xml(minkref: Minkref, tmp_path: Path) -> None:
    import xml.etree.ElementTree as ElementTree

    output = tmp_path / "sum.svg"
    assert minkref("sum", "g1", "g3", "-o", output).code == 0
    assert ElementTree.parse(output).getroot().tag == "{http://www.w3.org/2000/svg}svg"


def test_written_file_has_the_usual_rights_and_leaves_nothing_beside(
    minkref: Minkref, squares: tuple[Path, Path], tmp_path: Path
) -> None:
    folder = tmp_path / "out"
    folder.mkdir()
    assert minkref("sum", *squares, "-o", folder / "sum.wkt").code == 0
    assert [path.name for path in folder.iterdir()] == ["sum.wkt"]
    plain = folder / "plain"
    plain.touch()
    assert (folder / "sum.wkt").stat().st_mode == plain.stat().st_mode


@pytest.mark.parametrize("command", ["sum", "events"])
@pytest.mark.parametrize("position", [0, 1])
def test_the_file_of_an_operand_is_not_overwritten(
    minkref: Minkref, tmp_path: Path, command: str, position: int
) -> None:
    file = tmp_path / "P.json"
    file.write_text('{"polygons":[{"outer":[["0","0"],["1","0"],["0","1"]]}]}', encoding="utf-8")
    link = tmp_path / "link.json"
    link.symlink_to(file)
    before = file.read_bytes()
    operands = [file, "g1"] if position == 0 else ["g1", file]
    for target in (file, link):
        ran = minkref(command, *operands, "-o", target)
        assert ran.code == 2 and "operand" in ran.err
        assert file.read_bytes() == before


def test_a_link_to_itself_is_refused_and_stays(minkref: Minkref, tmp_path: Path) -> None:
    link = tmp_path / "loop.json"
    link.symlink_to(link)
    assert minkref("sum", "g1", "g2", "-o", link).code == 2
    assert link.is_symlink()


def test_a_pipe_is_written_to_and_stays_a_pipe(minkref: Minkref, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.wkt"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
        assert minkref("sum", "g1", "g2", "-o", pipe).code == 0
        read, _ = reader.communicate(timeout=30)
    assert read.startswith("POLYGON") and pipe.is_fifo()


def test_table_for_people_names_area_holes_and_digest(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    ran = minkref("sum", *squares)
    digest = minkref("sum", *squares, "--json").json["digest"]
    assert ran.code == 0
    for text in ("area               9\n", "components, holes", digest, "tight passages     none"):
        assert text in ran.out


def test_warnings_of_a_reader_are_handed_on(minkref: Minkref, tmp_path: Path) -> None:
    """Two numbers run together, as in the paper's bird."""
    path = tmp_path / "run_together.poly"
    path.write_text("1\n3 out\n0 0\n4.50.5\n0 4\n", encoding="utf-8")
    ran = minkref("sum", path, "g1", "--json")
    assert ran.code == 0
    assert any("4.50.5" in warning or "line 4" in warning for warning in ran.json["warnings"])
