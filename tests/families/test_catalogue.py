"""The families: deterministic, valid, small ones first, quick."""

from __future__ import annotations

import json
import time
from hashlib import sha256

import pytest
from members import text_of
from minkref import _core
from minkref.fuzz.plane.families.catalogue import FAMILIES
from thoroughness import draws

SEED = 11
COUNT = 50
LATE = range(600, 720, draws(8, 3))
# Digests of the first pairs of each family: a change here changes every case that a family names.
FINGERPRINTS = {
    "random": "fa5aa64472adb6de",
    "convex": "33a56d7ce74e885b",
    "holes": "3aeacd669019634c",
    "small-holes": "8a773aaab4ac3094",
    "dents": "c4efcf724d014ebd",
    "fit": "c8e135a371be4f3a",
    "collinear": "a7f885392598f27e",
    "touching": "74faf6ff0fd44c5b",
    "passing": "04dca53217a06274",
    "cells": "32b59382d0c560ab",
    "nested": "6af138a6dbbcc800",
    "comb": "f65c020a2f9b5de4",
    "star": "bda9f31e63e02fb2",
    "spiral": "79f3dfd2170812f5",
    "degenerate": "2f195327daf4bb6b",
    "lattice": "5bc7d47038abb79e",
    "rational": "c8e104329c52e6d3",
    "thin": "c20b58e0b61220b2",
    "leaning": "6f4c47aa8c21b36b",
    "offset": "c1947d8db4eaa510",
    "magnitude": "2612cbb52608a685",
}


def vertices(text: str) -> int:
    return _core.PolygonSet.from_json(text).vertices


@pytest.mark.parametrize("name", FAMILIES)
def test_the_first_pairs_are_pinned(name: str) -> None:
    """Under each hash seed: test_hash_seeds.py."""
    text = "".join(text_of(FAMILIES[name].pair(SEED, index)) for index in range(COUNT))
    assert sha256(text.encode()).hexdigest()[:16] == FINGERPRINTS[name]


def test_names_and_titles() -> None:
    assert all(name == family.name for name, family in FAMILIES.items())
    assert len({family.title for family in FAMILIES.values()}) == len(FAMILIES)


@pytest.mark.parametrize("name", FAMILIES)
def test_operands_are_valid_and_pairs_differ(name: str) -> None:
    numbers = (*range(draws(12, 40)), *LATE)
    pairs = [FAMILIES[name].pair(SEED, index) for index in numbers]
    for pair in pairs:
        for text in (pair.P, pair.Q):
            _core.PolygonSet.from_json(text).validate(f"{name}:{SEED}:{pair.index}")
            for polygon in json.loads(text)["polygons"]:
                assert all(isinstance(n, str) for point in polygon["outer"] for n in point)
    assert [pair.index for pair in pairs] == [*numbers]
    assert len({pair.P + pair.Q for pair in pairs}) >= 0.9 * len(pairs)
    assert FAMILIES[name].pair(SEED + 1, 7) != FAMILIES[name].pair(SEED, 7)


@pytest.mark.parametrize("name", FAMILIES)
def test_small_pairs_come_first(name: str) -> None:
    early, late = (
        [vertices(pair.P) + vertices(pair.Q) for pair in (FAMILIES[name].pair(SEED, i) for i in k)]
        for k in (range(12), LATE)
    )
    assert max(early) <= 26 and sum(early) / len(early) <= 18
    assert max(late) <= 80
    if name != "random":  # its grid grows, not its number of vertices
        assert sum(late) / len(late) >= 1.2 * sum(early) / len(early)


@pytest.mark.parametrize("name", FAMILIES)
def test_scales_other_than_one_occur_late_only(name: str) -> None:
    early, late = range(0, 60, draws(6, 1)), range(2000, 2000 + draws(20, 60))
    assert {FAMILIES[name].pair(SEED, index).scale for index in early} == {"1"}
    assert {FAMILIES[name].pair(SEED, index).scale for index in late} > {"1"}


@pytest.mark.parametrize("name", FAMILIES)
def test_a_pair_takes_some_milliseconds(name: str) -> None:
    begin = time.process_time()
    for index in LATE:
        FAMILIES[name].pair(SEED, index)
    assert (time.process_time() - begin) / len(LATE) < 0.02
