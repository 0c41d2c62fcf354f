"""Cases that users of other programs reported, with our own numbers and answers by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref as package
import pytest
from minkref import PolygonSet

Minkref = Callable[..., Any]
C_PART = PolygonSet(
    [(0, 0), (10, 0), (10, 4), (8, 4), (8, 2), (2, 2), (2, 8), (8, 8), (8, 6), (10, 6), (10, 10),
     (0, 10)]
)  # fmt: skip


def square(side: int) -> PolygonSet:
    return PolygonSet([(0, 0), (side, 0), (side, side), (0, side)])


def points_of(rows: Any) -> list[Any]:
    return [row["points"] for row in rows]


@pytest.mark.parametrize("radius", ["1/7", "1", "3/2"])
def test_an_inset_lies_within_the_set(radius: str) -> None:
    """GEOS issue 1208: a negative buffer partly outside of its input."""
    P = PolygonSet([(10**8, 0), (10**8 + 9_000_001, 1), (10**8 + 9_000_000, 4),
                    (10**8 + 4_500_000, 5), (10**8 + 1, 3)])  # fmt: skip
    found = package.inset(P, radius)
    assert found.components == 1
    for ring in (ring for rings in found.drawn_rings() for ring in rings):
        assert all((Fraction(step[1]), Fraction(step[2])) in P for step in ring)
    assert package.opening_by_disc(P, radius).area[1] <= Fraction(P.area())


def test_a_corner_cut_off_does_not_empty_an_inset() -> None:
    """GEOS issue 984: empty long before the inradius, for four corners that are nearly three."""
    P = PolygonSet([(0, 0), ("19/5", 0), ("16/5", "3/5"), (0, 3)])
    (largest,) = package.inradius(P)
    assert largest.radius == (1.0, 1.0)
    assert package.inset(P, "999/1000").components == 1
    last = package.inset(P, 1)
    assert (last.components, [points for points, *_ in last.tight_passages()]) == (
        0, [[("1", "1")]],
    )  # fmt: skip
    assert package.inset(P, "1001/1000").tight_passages() == []


def test_an_island_exactly_two_radii_from_the_wall() -> None:
    """CavalierContours issue 35: no answer where offsets of an island and of the wall overlap."""
    P = PolygonSet([[(0, 0), (10, 0), (10, 10), (0, 10)], [(7, 4), (7, 6), (8, 6), (8, 4)]])
    found = package.inset(P, 1)
    assert (found.components, found.holes) == (1, 0)
    assert found.area[0] <= 56 - math.pi <= found.area[1]
    assert [points for points, *_ in found.tight_passages()] == [[("9", "4"), ("9", "6")]]


def test_a_hole_collapses_to_a_point() -> None:
    """Clipper2 issue 593: a hole left behind by an offset that fills it."""
    P = PolygonSet([[(0, 0), (10, 0), (10, 10), (0, 10)], [(4, 4), (4, 6), (6, 6), (6, 4)]])
    found = package.offset(P, 1)
    assert (found.components, found.holes) == (1, 0)
    assert [points for points, *_ in found.tight_passages()] == [[("5", "5")]]
    assert package.offset(P, "99/100").holes == 1


def test_a_frame_thinner_than_its_inset() -> None:
    """Clipper2 issue 1110: pieces of a frame that is narrower than the offset."""
    P = PolygonSet([[(0, 0), (20, 0), (20, 20), (0, 20)], [(2, 2), (2, 18), (18, 18), (18, 2)]])
    corners = package.inset(P, 1)
    assert (corners.components, len(corners.tight_passages())) == (4, 4)
    gone = package.inset(P, "6/5")
    assert (gone.components, gone.area, gone.tight_passages()) == (0, (0.0, 0.0), [])


def test_a_bow_tie_keeps_both_lobes(minkref: Minkref, tmp_path: Path) -> None:
    """Shapely issue 462: a buffer of 0 keeps one lobe, and not the larger one."""
    ran = minkref("repair", "POLYGON ((0 0,12 6,12 0,0 2,0 0))", "-o", str(tmp_path / "a.json"))
    assert ran.code == 0
    lobes = package.read_file(tmp_path / "a.json")
    assert sorted(Fraction(PolygonSet([p]).area()) for p in lobes.rings()) == [3, 27]


def test_no_fit_of_a_shape_with_itself() -> None:
    """babushka issue 1: no polygon for two equal shapes."""
    assert package.no_fit(square(2), square(2)).region == square(4).translated("-2", "-2")
    ell = PolygonSet([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
    found = package.no_fit(ell, ell)
    assert (found.region.area(), found.components, found.holes) == ("14", 1, 0)
    assert (0, 0) in found.region


def test_a_part_inside_a_part_with_a_narrow_mouth() -> None:
    """DeepNestPort issue 16, SVGnest issue 73: a pocket that is never filled, and space that is
    skipped because it is as wide as the part."""
    found = package.no_fit(C_PART, square(3))
    assert (found.components, found.holes) == (1, 1)
    assert Fraction(found.region.area()) == 13 * 13 - 9
    assert points_of(package.no_fit(C_PART, square(6)).exact_fits) == [[(2, 2)]]
    assert points_of(package.no_fit(C_PART, square(2)).exact_fits) == [[(6, 4), (10, 4)]]
