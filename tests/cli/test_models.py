"""Models by name: shipped models, and models from the folder MINKREF_MODELS."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from model_sizes import SHIPPED

Minkref = Callable[..., Any]
POLYHEDRA = {
    "ellipsoid": (482, 960),
    "gs3": (162, 320),
    "gs4": (252, 500),
    "rod": (164, 84),
    "ti": (120, 236),
}
PAPER = {"monkey": (1204, 0), "bird": (275, 0), "neuron": (1815, 18)}


def test_shipped_models_have_the_sizes_that_their_names_promise(
    minkref: Minkref, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("MINKREF_MODELS", raising=False)
    value = minkref("models", "--json").json
    assert {row["name"]: (row["vertices"], row["holes"]) for row in value["models"]} == SHIPPED
    assert {row["name"] for row in value["absent"]} == set(PAPER)


def test_polyhedra_are_listed_apart_with_their_facets(minkref: Minkref) -> None:
    rows = minkref("models", "--json").json["polyhedra"]
    assert {row["name"]: (row["vertices"], row["facets"]) for row in rows} == POLYHEDRA
    assert all(Path(row["file"]).read_text(encoding="ascii").startswith("OFF") for row in rows)
    lines = [line.split() for line in minkref("models").out.splitlines()]
    assert ["gs3", "162", "320", "shipped"] in [words[:4] for words in lines]


def test_polyhedron_is_refused_as_an_operand_in_the_plane(minkref: Minkref, tmp_path: Path) -> None:
    ran = minkref("index", "gs3", "g1", "-o", tmp_path / "i.index", "--json")
    assert ran.code == 2
    assert ran.json["error"]["code"] == "mixed-dimensions"


def test_absent_model_of_the_paper_names_its_look_alike(
    minkref: Minkref, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("MINKREF_MODELS", raising=False)
    ran = minkref("sum", "monkey", "bird")
    assert ran.code == 2
    assert "MINKREF_MODELS" in ran.err
    assert "glyph1204" in ran.err


def test_folder_of_models_adds_names_and_replaces_none(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    triangle = "1\n3 out\n0 0\n1 0\n0 1\n"
    for name in ("bird.poly", "mine.poly", "g1.poly"):
        (tmp_path / name).write_text(triangle, encoding="utf-8")
    monkeypatch.setenv("MINKREF_MODELS", str(tmp_path))
    value = minkref("models", "--json").json
    rows = {row["name"]: row for row in value["models"]}
    assert rows["bird"]["origin"] == rows["mine"]["origin"] == "MINKREF_MODELS"
    assert rows["g1"]["vertices"] == 30
    assert {row["name"] for row in value["absent"]} == {"monkey", "neuron"}
    assert minkref("sum", "bird", "mine", "--json").json["area"] == "2"


def test_folder_that_does_not_exist_is_refused(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MINKREF_MODELS", str(tmp_path / "absent"))
    ran = minkref("models")
    assert ran.code == 2
    assert "does not exist" in ran.err


@pytest.mark.skipif(not os.environ.get("MINKREF_MODELS"), reason="MINKREF_MODELS not set")
def test_models_of_the_paper_have_its_sizes(minkref: Minkref) -> None:
    rows = {row["name"]: row for row in minkref("models", "--json").json["models"]}
    for name, size in PAPER.items():
        assert (rows[name]["vertices"], rows[name]["holes"]) == size
