"""`minkref features P`: the document, the table, files, refusals."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import minkref as package
import pytest
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]
SLOT = "POLYGON ((0 0, 6 0, 6 6, 4 6, 4 1, 2 1, 2 6, 0 6, 0 0))"
SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"


def test_the_document_follows_the_published_schema(minkref: Minkref) -> None:
    for options in (
        (),
        ("--alpha", "5"),
        ("--from", "1", "--to", "3/2"),
        ("--alpha", "5/2", "--regions", "--rest"),
    ):
        for shape in (SLOT, SQUARE, "g1", "POINT (1 2)"):
            ran = minkref("features", shape, *options, "--json")
            assert (ran.code, ran.err) == (0, ""), ran.err
            jsonschema.validate(ran.json, result_schema("features"))
            jsonschema.validate(ran.json, schema("features"))


def test_the_document_has_the_value(minkref: Minkref) -> None:
    ran = minkref("features", SLOT, "--alpha", "5", "--json").json
    found = package.features(package.read_text(SLOT, "wkt"))
    assert ran["digest"] == found.digest
    assert ran["digest"] == hashlib.sha256(found.canonical_json().encode()).hexdigest()
    assert [bar["death"] for bar in ran["bars"]] == [None, {"low": 2, "high": 2}]
    (alive,) = ran["features"]
    assert alive["squared_depth"] == "25" and alive["tie"]
    assert sorted(alive["bridges"][0]["near"]) == [[2, 6], [4, 6]]
    assert [node["kind"] for node in ran["tree"]] == ["reflex", "reflex", "merge", "outside"]


def test_regions_and_rest(minkref: Minkref, tmp_path: Path) -> None:
    ran = minkref("features", SLOT, "--alpha", "5/2", "--regions", "--rest", "--json").json
    (region,), (rest,) = ran["regions"]["of_features"], ran["rest"]["of_features"]
    assert region["terms"] == [{"factor": "10", "root": "1"}]
    assert region["node"] == rest["node"] == ran["features"][0]["node"]
    assert (ran["regions"]["components"], ran["regions"]["holes"]) == (1, 0)
    assert rest["components"] == 1 and 9 < rest["area"]["low"] < 10
    file = tmp_path / "f.svg"
    ran = minkref("features", SLOT, "--alpha", "5/2", "--regions", "--rest", "-o", file)
    assert ran.code == 0 and "1 region" in ran.out and "1 component" in ran.out, ran.err
    picture = file.read_text()
    assert picture.count('class="region"') == picture.count('class="rest"') == 1
    for option in ("--regions", "--rest"):
        refused = minkref("features", SLOT, option)
        assert refused.code == 2 and "add --alpha A" in refused.err


def test_a_window_keeps_the_bars_that_meet_it(minkref: Minkref) -> None:
    kept = minkref("features", SLOT, "--from", "5/2", "--json").json
    assert len(kept["bars"]) == 1 and kept["from"] == "5/2"


def test_files(minkref: Minkref, tmp_path: Path) -> None:
    for name in ("f.json", "f.svg", "f.dxf"):
        ran = minkref("features", SLOT, "--alpha", "5", "-o", tmp_path / name)
        assert ran.code == 0, ran.err
    value = json.loads((tmp_path / "f.json").read_text())
    jsonschema.validate(value, result_schema("features"))
    assert value["seconds"] is None
    picture = (tmp_path / "f.svg").read_text()
    assert picture.count('class="bridge"') == 1
    assert picture.count('class="leaf"') + picture.count('class="deepest"') == 2
    ezdxf = pytest.importorskip("ezdxf")
    lines = ezdxf.readfile(tmp_path / "f.dxf").modelspace().query("LINE")
    assert [sorted([tuple(line.dxf.start)[:2], tuple(line.dxf.end)[:2]]) for line in lines] == [
        [(2, 6), (4, 6)]
    ]


def test_the_index_of_all_radii_gives_the_same(minkref: Minkref, tmp_path: Path) -> None:
    file = tmp_path / "index.json"
    assert minkref("index", SLOT, "disc", "-o", file).code == 0
    told = [minkref("features", SLOT, *more, "--json").json for more in ((), ("--index", file))]
    assert told[0]["digest"] == told[1]["digest"]
    refused = minkref("features", SQUARE, "--index", file)
    assert refused.code == 2 and "does not belong" in refused.err


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("-o", "f.dxf"), "bridges are of one alpha"),
        (("--from", "3", "--to", "2"), "the window is empty"),
        (("--alpha", "0"), "not above 0"),
        (("-o", "f.wkt"), ""),
    ],
)
def test_refusals(minkref: Minkref, options: tuple[str, ...], told: str) -> None:
    ran = minkref("features", SLOT, *options)
    assert ran.code == 2 and told in ran.err


def test_the_table_begins_with_the_longest_bar(minkref: Minkref) -> None:
    lines = minkref("features", SLOT).out.splitlines()
    assert "2 bars" in lines[0] and lines[2].split()[0] == "infinite"
    assert "2 bars, 1 feature at alpha 5" in minkref("features", SLOT, "--alpha", "5").out


def test_work_that_needs_more_memory_than_it_may_have_is_refused(minkref: Minkref) -> None:
    ran = minkref("features", "cells1815", "--memory", "30", "--json")
    assert (ran.code, ran.json["error"]["code"]) == (2, "memory-limit")
    assert "cells1815" in ran.json["error"]["where"]


def test_a_proof_of_the_bridges(minkref: Minkref, tmp_path: Path) -> None:
    """Written beside its case, and verified; at an event what cannot be claimed is counted."""
    file = tmp_path / "b.cert.json"
    ran = minkref("features", SLOT, "--alpha", "5", "--certify", file)
    assert ran.code == 0 and "1 claim" in ran.out and "checked: verified" in ran.out, ran.err
    assert minkref("check", file).code == 0
    assert json.loads(file.read_text())["square"] == "25/4"
    at_event = tmp_path / "e.cert.json"
    ran = minkref("features", SLOT, "--alpha", "2", "--certify", at_event, "--json")
    assert (ran.code, ran.json["certificate"]["verified"]) == (0, True), ran.err
    assert any("left out" in warning for warning in ran.json["warnings"])
    refused = minkref("features", SLOT, "--certify", tmp_path / "c.cert.json")
    assert refused.code == 2 and "add --alpha A" in refused.err
    refused = minkref("features", SQUARE, "--alpha", "1", "--certify", tmp_path / "d.cert.json")
    assert refused.code == 2 and "no bridge at this alpha" in refused.err
    assert not (tmp_path / "d.cert.json").exists()
