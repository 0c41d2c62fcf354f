"""The index's file through Python: an opened index gives the saved index's answers."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from indexed_sums import FORMS, Index, arrays, operands, scales
from minkref import _core


def everything(index: Index) -> list[Any]:
    asked = scales(index, 6)
    return [
        index.window,
        index.P.to_json(),
        index.Q.to_json(),
        index.edges(),
        index.counts(),
        index.event_scales(),
        index.boundary_events(),
        index.topology_events(),
        *(index.features(kind) + index.lives(kind) for kind in ("hole", "component")),
        index.tracks(),
        index.track_integers.tolist(),
        index.track_doubles.tolist(),
        *((index.area(s), index.area_polynomial(s), index.components_and_holes(s)) for s in asked),
        *(index.sum(s).region.canonical_json() for s in asked),
        *(
            array.tolist()
            for form in FORMS
            for s in asked
            for _, array in arrays(index.rings(s, form))
        ),
    ]


def test_a_saved_index_gives_the_same_answers(index: Index, tmp_path: Path) -> None:
    path, copy = tmp_path / "sums.index", tmp_path / "copy.index"
    index.save(str(path))
    assert path.stat().st_size == index.counts()["bytes"]
    opened = Index.open(str(path))
    expected = everything(index)
    assert everything(opened) == expected
    assert opened.is_of(index.P, index.Q)
    opened.save(str(copy))
    assert copy.read_bytes() == path.read_bytes()
    # Also over itself, and after the file is no more.
    opened.save(str(path))
    assert everything(opened) == expected
    path.unlink()
    assert everything(opened) == expected
    assert [file.name for file in tmp_path.iterdir()] == ["copy.index"]


@pytest.mark.parametrize("how", ["saved over", "replaced", "deleted", "cut off", "overwritten"])
def test_an_open_index_is_as_it_was_after_its_file_is_another(
    indices: dict[str, Index], tmp_path: Path, how: str
) -> None:
    path, other = tmp_path / "sums.index", tmp_path / "other.index"
    indices["letters"].save(str(path))
    opened = Index.open(str(path))
    if how == "saved over":
        indices["nothing"].save(str(path))
    elif how == "replaced":
        other.write_bytes(b"short")
        os.replace(other, path)
    elif how == "deleted":
        path.unlink()
    elif how == "cut off":
        os.truncate(path, 10)
    else:
        length = path.stat().st_size
        with open(path, "r+b") as file:
            file.write(b"\xff" * length)
    assert everything(opened) == everything(indices["letters"])


def test_whose_index_it_is(indices: dict[str, Index]) -> None:
    P, Q = operands("several components")
    index = indices["several components"]
    assert index.is_of(P, Q)
    assert index.is_of(_core.PolygonSet.from_json(P.to_json()), Q)
    assert not index.is_of(Q, P)
    assert not index.is_of(P, P)
    assert not index.is_of(P.translated("1/1000000000000000000000", "0"), Q)
