"""The plain sum without a fault agrees with the reference on every family."""

from __future__ import annotations

import json

import pytest
from minkref import _core
from minkref.fuzz.geometry.region import region_of_rings, region_of_sum
from minkref.fuzz.plane.families.catalogue import FAMILIES
from plain_geometry import area
from plain_sum import PlainSum
from seeded_sums import sound

SEED = 4
INDICES = (*range(12), *range(12, 300, 24))


@pytest.mark.parametrize("family", FAMILIES)
def test_sound_agrees_with_the_reference(family: str) -> None:
    for index in INDICES:
        pair = FAMILIES[family].pair(SEED, index)
        P = _core.PolygonSet.from_json(pair.P).scaled(pair.scale)
        Q = _core.PolygonSet.from_json(pair.Q)
        found = region_of_rings(sound(json.loads(P.to_json()), json.loads(pair.Q)), turned=True)
        expected = region_of_sum(_core.minkowski_sum(P, Q, "1"))
        assert found.json == expected.json, f"{family}:{SEED}:{index}"
        assert found.overlap is None and found.degenerate is None
        assert found.holes == expected.holes and found.components == expected.components


def test_the_pieces_are_convex_and_fill_the_polygon() -> None:
    plain = PlainSum()
    for index in range(0, 400, 5):
        operand = json.loads(FAMILIES["touching"].pair(SEED, index).P)
        read = plain.read(operand)
        for polygon in plain.on_grid(read, plain.unit(read, [])):
            pieces = plain.pieces(polygon)
            assert all(plain.is_convex(piece) for piece in pieces)
            assert sum(area(piece) for piece in pieces) == sum(area(ring) for ring in polygon)


def test_a_sum_without_area_is_outside_its_capabilities() -> None:
    point = {"polygons": [{"outer": [["1", "2"]], "holes": []}]}
    assert sound(point, point) is None
