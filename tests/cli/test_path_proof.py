"""`minkref path --certify` and `minkref trap --certify`."""

from __future__ import annotations

import gzip
import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.degeneracies import lint
from minkref.reports.evidence.certificates.checkers import in_cpp, verdicts
from minkref.schemas import schema

PART = "POLYGON((2 0,3 0,3 1,2 1,2 0))"
WALLS = "MULTIPOLYGON(((1 0,4 0,4 1,1 1,1 0)),((6 0,9 0,9 1,6 1,6 0)))"
SQUARE = "POLYGON((-0.5 -0.5,0.5 -0.5,0.5 0.5,-0.5 0.5,-0.5 -0.5))"
ROOM = "POLYGON((-1 -1,5 -1,5 1.5,4 1.5,4 0,0 0,0 4,4 4,4 2.5,5 2.5,5 5,-1 5,-1 -1))"
PATH = ("path", PART, WALLS, "POINT (0 0)")
TRAP = ("trap", SQUARE, ROOM, "--at", "2,2")


@pytest.mark.parametrize("command", [PATH, TRAP], ids=["path", "trap"])
@pytest.mark.parametrize("contact", ["allowed", "forbidden"])
@pytest.mark.parametrize("ending", [".cert.json", ".cert.json.gz"])
def test_the_answer_is_certified(
    minkref: Any, tmp_path: Path, command: tuple[str, ...], contact: str, ending: str
) -> None:
    file = tmp_path / f"it{ending}"
    ran = minkref(*command, "--contact", contact, "--certify", str(file), "--json")
    assert ran.code == 0, ran.err
    jsonschema.validate(ran.json, schema(command[0]))
    told = ran.json["certificate"]
    assert (told["output"], told["verified"]) == (str(file), True)
    assert told["case"] == str(tmp_path / "it.case.json")
    checked = minkref("check", str(tmp_path), "--json")
    (row,) = checked.json["files"]
    assert (checked.code, row["verdict"], len(row["claims"])) == (0, "verified", told["claims"])
    packed = file.read_bytes()
    plain = tmp_path / "plain.json"
    plain.write_bytes(gzip.decompress(packed) if ending.endswith(".gz") else packed)
    (verdict,) = verdicts(in_cpp(), [plain])
    assert verdict.code == 0
    ranges = ran.json["valid" if command is PATH else "scales"]
    answer = json.loads(plain.read_text(encoding="utf-8"))["claims"][-1]
    assert answer["valid" if command is PATH else "trapped"] == ranges
    words = row["claims"][-1]
    assert all(f"{one['from']}, " in words for one in ranges)


@pytest.mark.parametrize("route", ["pieces", "contacts", "index"])
def test_the_answer_of_each_route_is_certified(minkref: Any, tmp_path: Path, route: str) -> None:
    file = tmp_path / "it.cert.json"
    ran = minkref(*PATH, "--route", route, "--from", "1/4", "--to", "5", "--certify", str(file))
    assert ran.code == 0, ran.err
    assert "checked: verified" in ran.out
    claims = json.loads(file.read_text(encoding="utf-8"))["claims"]
    assert [one["scales"]["from"] for one in claims] == ["1/4", "1/3", "2", "2", "9/2", "1/4"]


def test_without_it_there_is_no_certificate(minkref: Any) -> None:
    for command in (PATH, TRAP):
        value = minkref(*command, "--json").json
        jsonschema.validate(value, schema(command[0]))
        assert value["certificate"] is None


@pytest.mark.parametrize(
    ("name", "why"),
    [("it.json", "not a name for a certificate"), ("-", "two files"),
     ("no/it.cert.json", "no/it.cert.json")],
)  # fmt: skip
def test_names_that_are_none(minkref: Any, tmp_path: Path, name: str, why: str) -> None:
    file = name if name == "-" else str(tmp_path / name)
    for command in (PATH, TRAP):
        ran = minkref(*command, "--certify", file)
        assert ran.code == 2
        assert why in ran.err
    assert list(tmp_path.iterdir()) == []


def test_no_file_is_lost(minkref: Any, tmp_path: Path) -> None:
    """Keeps the files of an operand, of another output, and of another case."""
    part = tmp_path / "part.case.json"
    part.write_text('{"polygons": [{"outer": [[2, 0], [3, 0], [3, 1], [2, 1]]}]}', "utf-8")
    before = part.read_bytes()
    ran = minkref(*PATH, "--certify", str(tmp_path / "part.cert.json"))
    assert (ran.code, "another file has the name of the case" in ran.err) == (2, True)
    assert "give --certify another name" in ran.err
    wall = tmp_path / "wall.cert.json"
    wall.write_bytes(before)
    ran = minkref("path", PART, str(wall), "POINT (0 0)", "--certify", str(wall))
    assert (ran.code, "the file of an operand" in ran.err) == (2, True)
    for name in ("it.cert.json", "it.case.json"):
        ran = minkref(*PATH, "--certify", str(tmp_path / "it.cert.json"), "-o",
                      str(tmp_path / name))  # fmt: skip
        assert (ran.code, "one name" in ran.err) == (2, True)
    assert part.read_bytes() == wall.read_bytes() == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part.case.json", "wall.cert.json"]


def test_what_has_no_certificate_is_refused(minkref: Any, tmp_path: Path) -> None:
    """A segment may touch along a seam of pieces; with contact forbidden a proof exists."""
    file = tmp_path / "it.cert.json"
    way = ("path", "LINESTRING (0 0, 1 0)", WALLS, "LINESTRING (0 2, 9 2)", "--certify", str(file))
    ran = minkref(*way)
    assert (ran.code, "seam" in ran.err) == (2, True), ran.err
    assert not file.exists()
    ran = minkref(*way, "--contact", "forbidden")
    assert (ran.code, "verified" in ran.out) == (0, True), ran.err


def test_the_case_is_of_the_form_of_generated_ones(minkref: Any, tmp_path: Path) -> None:
    for number, command in enumerate((PATH, TRAP)):
        assert minkref(*command, "--certify", str(tmp_path / f"{number}.cert.json")).code == 0
        value = json.loads((tmp_path / f"{number}.case.json").read_text(encoding="utf-8"))
        lint.validator("path-case-v1").validate(value)
