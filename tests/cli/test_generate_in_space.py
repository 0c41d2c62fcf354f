"""`minkref generate` and `minkref families` for degenerate or invalid solids."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.degeneracies.catalogue import SPACE_FAMILIES
from minkref.degeneracies.invalid.catalogue import INVALID_MESH_FAMILIES
from minkref.schemas import schema


def test_all_families_in_space_at_once(minkref: Any, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = minkref("generate", "space", "--count", "1", "-o", out, "--json")
    jsonschema.validate(ran.json, schema("generate"))
    assert ran.code == 0 and {row["family"] for row in ran.json["cases"]} == set(SPACE_FAMILIES)
    checked = minkref("check", out, "--json")
    assert checked.code == 0 and len(checked.json["files"]) == len(SPACE_FAMILIES)
    ran = minkref("generate", "with-itself", "--count", "1", "-o", tmp_path / "one")
    assert ran.out.splitlines()[-1].startswith("check them: minkref check")


def test_a_member_alone_is_that_of_the_run(minkref: Any, tmp_path: Path) -> None:
    words = ("generate", "needle-and-plate", "--seed", "4")
    minkref(*words, "--count", "3", "-o", tmp_path / "all")
    ran = minkref(*words, "--index", "2", "-o", tmp_path / "one", "--json")
    (row,) = ran.json["cases"]
    path = Path(row["case"])
    assert json.loads(path.read_text(encoding="utf-8"))["source"] == (
        "minkref generate needle-and-plate --seed 4 --index 2"
    )
    for each in (path, Path(row["certificate"])):
        other = tmp_path / "all" / each.relative_to(tmp_path / "one")
        assert other.read_bytes() == each.read_bytes()


def test_sizes(minkref: Any, tmp_path: Path) -> None:
    words = ("generate", "many-sided-facets", "--count", "1")
    ran = minkref(*words, "--size", "100", "-o", tmp_path / "large", "--json")
    value = json.loads(Path(ran.json["cases"][0]["case"]).read_text(encoding="utf-8"))
    assert len(value["P"]["vertices"]) + len(value["Q"]["vertices"]) > 60
    assert value["source"].endswith("--index 0 --size 100")
    assert minkref(*words, "--size", "9000", "-o", tmp_path / "none").code == 2
    ran = minkref("generate", "invalid-mesh-dent", "--size", "20", "-o", tmp_path / "none")
    assert ran.code == 2 and not (tmp_path / "none").exists()


def test_invalid_meshes_at_once(minkref: Any, tmp_path: Path) -> None:
    """Each mesh is refused for the reason stated beside it."""
    out = tmp_path / "out"
    ran = minkref("generate", "invalid-mesh", "--count", "2", "-o", out, "--json")
    assert {row["family"] for row in ran.json["cases"]} == set(INVALID_MESH_FAMILIES)
    for path in sorted(out.rglob("*.refusal.json")):
        told = json.loads(path.read_text(encoding="utf-8"))
        if not told["file"].endswith(".json"):  # a damaged one may not be known for a mesh
            # `sum` takes polyhedra of any shape.
            command = "convolution" if told["code"] == "not-convex" else "sum"
            bad = minkref(command, path.with_name(told["operand"]), "gs3", "--json")
            assert (bad.code, bad.json["error"]["code"]) == (2, told["code"]), told
            assert all(place in bad.err for place in told["place"]), told


def test_families_name_their_dimension(minkref: Any) -> None:
    listed = minkref("families", "--json").json
    jsonschema.validate(listed, schema("families"))
    rows = {row["name"]: row for row in listed["families"]}
    assert len(rows) == len(listed["families"])
    for name, family in (*SPACE_FAMILIES.items(), *INVALID_MESH_FAMILIES.items()):
        assert rows[name] == {
            "name": name, "dimension": 3, "title": family.title, "command": "generate",
        }  # fmt: skip


@pytest.mark.parametrize("word", ["bodies", "invalid-mesh-", "space-convex"])
def test_what_is_no_family_is_refused(minkref: Any, tmp_path: Path, word: str) -> None:
    ran = minkref("generate", word, "-o", tmp_path / "out")
    assert ran.code == 2 and "space" in ran.err and not (tmp_path / "out").exists()
