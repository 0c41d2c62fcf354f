"""`minkref.offset`."""

from __future__ import annotations

import copy
import json
import math
from fractions import Fraction
from typing import Any

import minkref
import pytest

FRAME = minkref.PolygonSet([[(0, 0), (6, 0), (6, 6), (0, 6)], [(2, 2), (2, 4), (4, 4), (4, 2)]])


def test_a_hole_closes_with_the_radius() -> None:
    assert minkref.offset(FRAME, "99/100").holes == 1
    assert minkref.offset(FRAME, 1).holes == 0
    assert minkref.offset(FRAME, Fraction(1, 2)).holes == 1


def test_the_square_of_the_radius_does_as_well() -> None:
    found = minkref.offset(FRAME, "1/2")
    assert found == minkref.offset(FRAME, squared_radius="1/4") == copy.deepcopy(found)
    assert hash(found) == hash(minkref.offset(FRAME, "2/4"))
    assert found != minkref.offset(FRAME, "1/3")
    assert found != "an offset"
    root = minkref.offset(FRAME, squared_radius=2)
    assert json.loads(root.canonical_json())["squared_radius"] == "2"


@pytest.mark.parametrize("threads", [1, 2, 7])
def test_threads_change_nothing(threads: int) -> None:
    assert minkref.offset(FRAME, "1/3", threads=threads) == minkref.offset(FRAME, "1/3")


@pytest.mark.parametrize("radius", ["1/3", 1, "7/5", 9])
def test_both_routes_give_one_form(radius: int | str) -> None:
    by_winding = minkref.offset(FRAME, radius, route="paper")
    assert by_winding == minkref.offset(FRAME, radius, route="definition")
    assert by_winding.canonical_json() == minkref.offset(FRAME, radius).canonical_json()


def test_area_and_length_of_a_stadium() -> None:
    found = minkref.offset(minkref.read_text("LINESTRING (0 0, 3 4)", "wkt"), 2)
    assert found.area[0] <= 20 + 4 * math.pi <= found.area[1]
    assert found.length[0] <= 10 + 4 * math.pi <= found.length[1]
    assert found.area[1] - found.area[0] < 1e-12


def test_the_empty_set_stays_empty() -> None:
    found = minkref.offset(minkref.PolygonSet([]), 1)
    assert (found.components, found.holes, found.curves, found.area) == (0, 0, 0, (0, 0))


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"radius": 0}, "bad-radius"),
        ({"radius": "-1"}, "bad-radius"),
        ({"squared_radius": 0}, "bad-radius"),
        ({"squared_radius": "x"}, None),
        ({"radius": "x"}, None),
        ({}, None),
        ({"radius": 1, "squared_radius": 1}, None),
        ({"radius": 1, "route": "winding"}, "unknown-route"),
    ],
)
def test_what_it_refuses(given: dict[str, Any], code: str | None) -> None:
    with pytest.raises((minkref.BadInput, minkref.Refusal)) as raised:
        minkref.offset(FRAME, **given)
    assert code is None or raised.value.code == code


def test_a_float_is_no_exact_number() -> None:
    with pytest.raises(TypeError):
        minkref.offset(FRAME, 0.5)  # type: ignore[arg-type]


def test_an_invalid_set_is_refused() -> None:
    bow = minkref.PolygonSet.from_json('{"polygons":[{"outer":[[0,0],[1,1],[1,0],[0,1]]}]}')
    with pytest.raises(minkref.BadInput):
        minkref.offset(bow, 1)
