"""Free components, places, ways and growth of scenes: by hand, and against the slow engine's
sets."""

from __future__ import annotations

import random
from fractions import Fraction

import minkref
import pytest
from minkref import Copy, PolygonSet, Refusal, Scene, SceneSeam
from scene_draws import POINT, ROBOTS, UNIT, Draw, box, scenes
from thoroughness import draws

SEED = 2203
SOLID = tuple(name for name, robot in ROBOTS.items() if robot.is_region)


def drawn(count: int, seed: int) -> list[Draw]:
    return list(scenes(seed, count, robots=SOLID))


def test_components_with_contact_forbidden_are_those_of_the_complement() -> None:
    """Their areas within a box add up to its area less that of the union."""
    for draw in drawn(draws(20, 100), SEED):
        scene = draw.scene()
        found = scene.free_components("forbidden")
        assert len(found) == scene.holes + 1, draw.told
        assert all(len(one.cells) == 1 for one in found), draw.told
        frame = box(-40, -40, 40, 40)
        area = Fraction(0)
        for one in found:
            [cell] = one.cells
            outer = PolygonSet(list(cell.outer)) if cell.outer else frame
            inner = minkref.unite([PolygonSet(list(reversed(hole))) for hole in cell.holes])
            area += Fraction(minkref.subtract(outer, [inner]).area())
        assert area == 80 * 80 - Fraction(scene.union().area()), draw.told


def test_touching_joins_components_and_never_parts_them() -> None:
    joined = 0
    for draw in drawn(draws(40, 200), SEED + 1):
        scene = draw.scene(passages=True)
        apart = scene.free_components("forbidden")
        together = scene.free_components("allowed")
        cells = sum(len(one.cells) for one in together)
        assert cells == len(apart), draw.told
        joined += any(len(one.cells) > 1 for one in together)
        alone = sum(not one.cells for one in together)
        assert alone <= len(scene.passages()), draw.told
    assert joined > 2


def test_places_are_free_as_their_component_says() -> None:
    for draw in drawn(draws(15, 60), SEED + 2):
        dice = random.Random(draw.told)
        scene = draw.scene()
        union = scene.union()
        for _ in range(8):
            place = (Fraction(dice.randint(-9, 17), 2), Fraction(dice.randint(-9, 17), 2))
            holders = scene.holders(place)
            probe = box(0, 0, 1, 1).scaled("1/1000000").translated(*map(str, place))
            outside = minkref.intersect([probe, union]).is_empty
            assert scene.way([place], "forbidden").free == (not holders), draw.told
            if not holders:
                assert outside, (draw.told, place)
            free = all(holder.contact == "touching" for holder in holders)
            assert scene.way([place], "allowed").free == free, (draw.told, place)


def is_free(draw: Draw, factor: Fraction, place: tuple[Fraction, Fraction], contact: str) -> bool:
    copies = [Copy(c.shape, c.scale * factor, c.place) for c in draw.copies]
    return Scene(draw.robot, draw.shapes, copies).way([place], contact).free


def test_growth_is_the_last_factor_at_which_the_grown_scene_is_free() -> None:
    bounded = 0
    for draw in drawn(draws(15, 60), SEED + 3):
        dice = random.Random(draw.told)
        place = (Fraction(dice.randint(-9, 17), 2), Fraction(dice.randint(-9, 17), 2))
        for contact in ("allowed", "forbidden"):
            growth = draw.scene().growth([place], contact)
            if growth is None or growth.factor is None:
                continue
            bounded += 1

            assert is_free(draw, growth.factor, place, contact) == growth.included, draw.told
            beyond = growth.factor * Fraction(1000001, 1000000)
            assert not is_free(draw, beyond, place, contact), draw.told
            if growth.factor > 1:
                assert is_free(draw, (1 + growth.factor) / 2, place, contact), draw.told
    assert bounded > 5


def test_four_sums_that_touch_at_corners_close_a_room_if_contact_is_forbidden() -> None:
    half = box(0, 0, 1, 1).scaled("1/2")
    places = [(1, 0), (0, 1), (2, 1), (1, 2)]
    scene = Scene(half, [half], [Copy(0, 1, place) for place in places], passages=True)
    assert len(scene.free_components("forbidden")) == 2
    [one] = scene.free_components("allowed")
    assert one.number == 0 and len(one.cells) == 2


def test_a_room_that_the_robot_fits_exactly_is_a_component_of_its_own() -> None:
    walls = [Copy(0, 1, place) for place in ((-3, -2), (1, -2))]
    ends = [Copy(1, 1, place) for place in ((-1, 1), (-1, -3))]
    shapes = [box(0, 0, 2, 5), box(0, 0, 2, 2)]
    scene = Scene(box(-1, -1, 1, 1), shapes, [*walls, *ends], passages=True)
    components = scene.free_components("allowed")
    assert [len(one.cells) for one in components] == [1, 0]
    assert scene.way([(0, 0)], "allowed").free and not scene.way([(0, 0)], "forbidden").free


def test_a_seam_stops_a_point_and_no_copy_does() -> None:
    scene = Scene(POINT, [UNIT], [Copy(0), Copy(0, 1, (1, 0))])
    way = scene.way([(1, -3), (1, 3)], "allowed")
    assert not way.free and way.stopped_by == ()
    grown = scene.growth([(9, 9)], "allowed")
    assert grown is not None and (grown.factor, grown.seam) == (9, None)


def test_a_seam_closes_around_a_point_as_copies_grow() -> None:
    """Corners close at, seams along ways just above, factors."""
    corners = [Copy(0, 1, (x, y)) for x in (-2, 2) for y in (-2, 2)]
    place = Scene(POINT, [box(-1, -1, 1, 1)], corners).growth([(0, 0)])
    assert place is not None and (place.factor, place.included) == (2, False)
    assert place.stop is None and place.seam == SceneSeam((0, 1, 2, 3), 0, 0, (0, 0), (0, 0))
    sides = Scene(POINT, [UNIT, box(-1, 0, 0, 1)], [Copy(0), Copy(1)])
    way = sides.growth([(0, 3), (0, 5)])
    assert way is not None and (way.factor, way.included) == (3, True)
    assert way.seam is not None and way.seam.copies == (0, 1)


@pytest.mark.parametrize("ask", ["free_components", "way", "growth"])
def test_an_unknown_rule_is_refused(ask: str) -> None:
    scene = Scene(UNIT, [UNIT], [Copy(0)])
    arguments = [] if ask == "free_components" else [[(5, 5)]]
    with pytest.raises(Refusal, match="there is no rule"):
        getattr(scene, ask)(*arguments, "sometimes")
