"""The slow engine just below and just above a scale: against scales very near, and against
itself."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from minkref.oracle.slow import Operand, minkowski_sum, operand_from_json, topology
from minkref.oracle.slow.canonical import digest
from minkref.oracle.slow.germ import Germ, bits_needed, side_of
from minkref.oracle.slow.operand import Polygon
from minkref.oracle.slow.state import State
from random_pairs import as_json, pair
from thoroughness import draws

SEED = 20122
SCALES = [Fraction(1), Fraction(2), Fraction(1, 2), Fraction(3, 2), Fraction(2, 3), Fraction(3)]


def operands(index: int) -> tuple[Operand, Operand]:
    P, Q = (source.operand() for source in pair(SEED, index))
    return (P, Q) if not (P.ends and Q.ends) else operands(index + 1000)


def moved_on(state: State, step: Fraction) -> str:
    """The state's digest, with each vertex moved along its track."""
    parts = [
        [[(x.value + x.slope * step, y.value + y.slope * step) for x, y in ring] for ring in part]
        for part in state.rings
    ]
    return digest([Polygon(part[0], part[1:]) for part in parts])


@pytest.mark.parametrize("index", range(draws(36, 120)))
def test_tracks_lead_to_the_sums_very_near(index: int) -> None:
    P, Q = operands(index)
    scale = SCALES[index % len(SCALES)]
    found = topology(P, Q, scale)
    assert found.below.area[0] == found.at.area[0] == found.above.area[0]
    for state, sign in ((found.below, -1), (found.above, 1)):
        near = [sign * Fraction(1, 10**k) for k in (6, 7)]
        sums = [minkowski_sum(P, Q, scale + step) for step in near]
        # An event between them would show: no seed of this test has such an event, and no case is
        # skipped.
        assert [len(r) for p in sums[0].polygons for r in (p.outer, *p.holes)] == [
            len(r) for p in sums[1].polygons for r in (p.outer, *p.holes)
        ]
        for step, result in zip(near, sums, strict=True):
            assert moved_on(state, step) == result.digest, (SEED, index, scale)
            assert (len(state.interior), len(state.complement)) == (result.components, result.holes)
            a, b, c = state.area
            assert a + b * step + c * step * step == result.area


@pytest.mark.parametrize("index", range(draws(12, 40)))
def test_packed_numbers_and_germs_that_check_their_degree_agree(index: int) -> None:
    P, Q = operands(index)
    scale = SCALES[index % len(SCALES)]
    packed, explicit = topology(P, Q, scale), topology(P, Q, scale, explicit=True)
    for one, other in (
        (packed.below, explicit.below),
        (packed.at, explicit.at),
        (packed.above, explicit.above),
    ):
        assert one.rings == other.rings, (SEED, index, scale)
        assert one.area == other.area
    assert packed.holes == explicit.holes
    assert packed.components == explicit.components
    assert packed.result == explicit.result


@pytest.mark.parametrize("index", range(draws(24, 60)))
def test_nothing_changes_at_a_scale_beside_all_events(index: int) -> None:
    """At s0 + 1/10^7, which is no event, the state is the same on both sides and goes on."""
    P, Q = operands(index)
    found = topology(P, Q, SCALES[index % len(SCALES)] + Fraction(1, 10**7))
    assert not found.boundary_changes, (SEED, index)
    assert not found.topology_changes
    assert all(link.change == "same" for link in found.holes + found.components)


@pytest.mark.parametrize("index", range(draws(24, 60)))
def test_links_name_each_hole_and_component_once(index: int) -> None:
    P, Q = operands(index)
    found = topology(P, Q, SCALES[index % len(SCALES)])
    for links, extra, of in (
        (found.holes, 1, lambda state: state.complement),
        (found.components, 0, lambda state: state.interior),
    ):
        for name, state in (("below", found.below), ("at", found.at), ("above", found.above)):
            named = sorted(i for link in links for i in getattr(link, name))
            assert named == list(range(len(of(state)) + extra)), (SEED, index, name)


def test_empty_sums_have_no_state_but_the_outside() -> None:
    square = operand_from_json({"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]]}]})
    for P, Q in ((square, Operand([], [])), (Operand([], []), square)):
        found = topology(P, Q)
        assert not found.boundary_changes and not found.topology_changes
        assert found.components == [] and [link.change for link in found.holes] == ["same"]


def test_product_of_two_germs_is_refused() -> None:
    with pytest.raises(TypeError, match="degree"):
        Germ(1, 1) * Germ(1, 0)  # type: ignore[operator]


def test_order_of_germs_is_that_of_their_leading_parts_first() -> None:
    assert Germ(1, -5) < Germ(1, 0) < Germ(1, 7) < Germ(2, -100)


@pytest.mark.parametrize("side", [-1, 1])
def test_packed_numbers_give_their_coefficients_back(side: int) -> None:
    bits = bits_needed(1000, 7, 12)
    where = side_of(Fraction(3, 7), side, 5, bits, False)
    for x, y in ((0, 0), (1000, -1000), (-1000, 999), (1, 0), (-1, 0)):
        assert where.coefficients(where.of_p * x + where.of_q * y) == (3 * x + 7 * y, side * 7 * x)
        track = where.track(where.of_p * x + where.of_q * y, 1)
        # s x + y over the unit 5, and its derivative with respect to s.
        assert track.value == Fraction(3 * x, 35) + Fraction(y, 5)
        assert track.slope == Fraction(x, 5)


def test_random_operands_are_the_same_for_one_seed() -> None:
    first, again = (json.dumps([as_json(s.operand()) for s in pair(7, 3)]) for _ in range(2))
    assert first == again
