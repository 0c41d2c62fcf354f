"""The generator of random pairs: deterministic, within bounds, valid, varied."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.plane.families.random_pairs import GROWTH, Pair, random_pair

SEED = 11
COUNT = 1500


@pytest.fixture(scope="module")
def pairs() -> list[Pair]:
    print(f"seed {SEED}")
    return [random_pair(SEED, index) for index in range(GROWTH // 2, GROWTH // 2 + COUNT)]


def polygon(text: str) -> Any:
    (only,) = json.loads(text)["polygons"]
    return only


def fingerprint() -> str:
    text = "".join(repr(random_pair(SEED, index)) for index in (0, 1, 500, 2500, 10_007))
    return hashlib.sha256(text.encode()).hexdigest()


def test_a_pair_depends_on_seed_and_index_only() -> None:
    code = (
        "import hashlib; from minkref.fuzz.plane.families.random_pairs import random_pair;"
        f"print(hashlib.sha256(''.join(repr(random_pair({SEED}, i)) for i in"
        " (10007, 2500, 500, 1, 0)[::-1]).encode()).hexdigest())"
    )
    for hash_seed in ("0", "1"):
        environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
        ran = subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            env=environment,
            check=True,
        )
        assert ran.stdout.strip() == fingerprint()


def test_other_seeds_give_other_pairs() -> None:
    texts = {random_pair(seed, 700).P for seed in range(20)}
    assert len(texts) > 15


def test_coordinates_are_integers_of_the_grid(pairs: list[Pair]) -> None:
    for pair in pairs:
        assert 4 <= pair.grid <= 12
        for text in (pair.P, pair.Q):
            only = polygon(text)
            for ring in (only["outer"], *only["holes"]):
                assert all(0 <= int(x) <= pair.grid and 0 <= int(y) <= pair.grid for x, y in ring)


def test_at_most_twelve_outer_vertices_and_three_holes(pairs: list[Pair]) -> None:
    for pair in pairs:
        for text in (pair.P, pair.Q):
            assert 3 <= len(polygon(text)["outer"]) <= 12
            assert len(polygon(text)["holes"]) <= 3


def test_operands_are_valid(pairs: list[Pair]) -> None:
    for pair in pairs:
        _core.PolygonSet.from_json(pair.P).validate(pair.name)
        _core.PolygonSet.from_json(pair.Q).validate(pair.name)


def test_three_in_ten_pairs_are_without_holes_and_three_in_ten_with(pairs: list[Pair]) -> None:
    holes = [len(polygon(pair.P)["holes"]) + len(polygon(pair.Q)["holes"]) for pair in pairs]
    assert sum(count == 0 for count in holes) >= 0.3 * len(pairs)
    assert sum(count > 0 for count in holes) >= 0.3 * len(pairs)
    assert {1, 2, 3} <= {len(polygon(pair.P)["holes"]) for pair in pairs}


def test_small_grids_come_first() -> None:
    grids = [random_pair(SEED, index).grid for index in range(0, GROWTH, 100)]
    assert grids == sorted(grids)
    assert (grids[0], random_pair(SEED, GROWTH - 1).grid) == (4, 12)


def test_scales_other_than_one_occur_late_only(pairs: list[Pair]) -> None:
    assert {pair.scale for pair in pairs if pair.index < GROWTH} == {"1"}
    assert {random_pair(SEED, GROWTH + index).scale for index in range(200)} > {"1", "1/2"}
