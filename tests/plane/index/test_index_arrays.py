"""The index's arrays through Python: their forms and lifetimes."""

from __future__ import annotations

import gc
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy
import pytest
from indexed_sums import (
    FORMS,
    LONG,
    Index,
    arrays,
    exact_tracks,
    integers,
    operands,
    points,
    scales,
)
from minkref import _core
from numpy.typing import NDArray
from thoroughness import draws


@pytest.mark.parametrize("form", FORMS)
def test_arrays_are_contiguous_views_that_cannot_be_written(index: Index, form: str) -> None:
    kinds = {"ring_ends": "uint32", "edges": "uint32", "x": "float64", "y": "float64",
             "homogeneous": "uint64", "rational": "uint64", "tracks": "uint32"}  # fmt: skip
    per = {"homogeneous": 3, "rational": 4}
    rings = index.rings(scales(index)[0], form)
    for name, array in arrays(rings):
        assert array.dtype == numpy.dtype(kinds[name])
        assert array.flags.c_contiguous and array.flags.aligned
        assert array.size == 0 or not (array.flags.writeable or array.flags.owndata)
        if name == "ring_ends":
            assert array.shape == (len(rings.features()),)
            assert array.tolist() == sorted(set(array.tolist()))
            assert array.size == 0 or (array[0] > 0 and array[-1] == len(rings))
        elif name in per:
            assert array.shape[:2] == (len(rings), per[name])
            assert array.shape[2] >= 1
        else:
            assert array.shape == (len(rings),)
        if array.size == 0:
            continue
        with pytest.raises(ValueError):
            array[...] = 0
        assert numpy.shares_memory(array, getattr(rings, name))


def test_tracks_are_told_in_integers_doubles_and_texts_alike(index: Index) -> None:
    exact, words, doubles = exact_tracks(index), index.track_integers, index.track_doubles
    assert words.dtype == numpy.uint64 and doubles.dtype == numpy.float64
    assert words.shape[:2] == (len(exact), 5) and doubles.shape == (len(exact), 4)
    for array in (words, doubles):
        assert array.flags.c_contiguous and not array.flags.writeable
        with pytest.raises(ValueError):
            array[...] = 0
    for (a, b), (x0, y0, x1, y1, c), near in zip(
        exact, integers(words), doubles.tolist(), strict=True
    ):
        assert c > 0
        assert (a, b) == ((Fraction(x0, c), Fraction(y0, c)), (Fraction(x1, c), Fraction(y1, c)))
        for coordinate, double in zip((*a, *b), near, strict=True):
            assert abs(Fraction(double) - coordinate) <= abs(coordinate) / 2**52


def test_integers_have_as_many_words_as_they_need_and_their_signs(
    indices: dict[str, Index],
) -> None:
    scale = "1" + 25 * "0" + "/7"
    for form in ("homogeneous", "rational"):
        short, long = (
            getattr(indices[name].rings(at, form), form)
            for name, at in (("letters", "1"), (LONG, scale))
        )
        assert short.shape[2] == 1
        assert long.shape[2] >= 3
        for words in (short, long):
            numbers = [number for row in integers(words) for number in row]
            assert min(numbers) < 0 < max(numbers)
        numbers = [number for row in integers(long) for number in row]
        assert max(abs(number) for number in numbers) > 2**128
    assert indices["letters"].track_integers.shape[2] == 1
    assert indices[LONG].track_integers.shape[2] >= 3
    # Words use two's complement, not sign and magnitude: -1 is all ones.
    whole = Index(
        _core.read_text("POLYGON((-1 -1,0 -1,0 0,-1 0,-1 -1))", "wkt"),
        _core.read_text("POINT(0 0)", "wkt"),
    )
    found = {tuple(row.ravel().tolist()) for row in whole.rings("1", "rational").rational}
    ones = 2**64 - 1
    assert found == {(ones, 1, ones, 1), (ones, 1, 0, 1), (0, 1, ones, 1), (0, 1, 0, 1)}


@pytest.mark.parametrize("shift", [2**k + d for k in (62, 63, 64, 127, 128) for d in (-1, 0, 1)])
def test_numbers_at_the_ends_of_words(shift: int) -> None:
    triangle = _core.read_text("POLYGON((0 0,1 0,0 1,0 0))", "wkt")
    for sign in ("", "-"):
        point = _core.read_text(f"POINT({sign}{shift} 0)", "wkt")
        index = Index(triangle, point, "1", "2")
        x = int(f"{sign}{shift}")
        for form in ("homogeneous", "rational", "track"):
            found = points(index, index.rings("1", form))
            assert set(found) == {(x, 0), (x + 1, 0), (x, 1)}, form
        rounded = index.rings("1")
        for double in rounded.x.tolist():
            assert min(abs(Fraction(double) - x - d) for d in (0, 1)) <= Fraction(rounded.error)


@pytest.mark.parametrize("opened", [False, True])
def test_arrays_outlive_the_index_and_the_rings(tmp_path: Path, opened: bool) -> None:
    P, Q = operands("several components")
    made = Index(P, Q)
    path = tmp_path / "kept.index"
    made.save(str(path))
    index = Index.open(str(path)) if opened else Index(P, Q)
    del made
    kept: list[NDArray[Any]] = [index.track_integers, index.track_doubles]
    for form in FORMS:
        kept += [array for _, array in arrays(index.rings("7/5", form))]
    kept += [array for rings in index.batch(["1", "2"], "double", 2) for _, array in arrays(rings)]
    before = [array.copy() for array in kept]
    rings = index.rings("7/5", "homogeneous")
    path.unlink()
    del index
    gc.collect()
    others = [Index(P, Q).rings("7/5", "homogeneous").homogeneous for _ in range(draws(5, 20))]
    gc.collect()
    assert all(numpy.array_equal(a, b) for a, b in zip(kept, before, strict=True))
    # Rings need no index either.
    assert numpy.array_equal(rings.homogeneous, others[0])
    assert len(rings) == len(rings.edges)
