"""Laws of scenes, on small random scenes."""

from __future__ import annotations

import copy as copies_of_values
import pickle
import random
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

import minkref
import pytest
from minkref import Copy, PolygonSet, Scene
from scene_draws import FLAT, ROBOTS, Draw, scenes, turned
from thoroughness import draws

SEED = 1107
SOLID = tuple(name for name in ROBOTS if name not in FLAT)


def placed_sum(draw: Draw, copy: Copy) -> PolygonSet:
    shape = draw.shapes[str(copy.shape)]
    if shape.is_region:
        found = minkref.minkowski_sum(shape, turned(draw.robot), copy.scale).region
    else:
        found = minkref.minkowski_sum(turned(draw.robot), shape.scaled(copy.scale)).region
    return found.translated(*copy.place)


def everything(scene: Scene) -> tuple[Any, ...]:
    return scene.digest, scene.components, scene.holes, scene.owners(), scene.passages()


def drawn(count: int, seed: int = SEED, **options: Any) -> list[Draw]:
    return list(scenes(seed, count, **options))


def test_the_union_is_that_of_the_placed_sums() -> None:
    for draw in drawn(draws(35, 210)):
        scene = draw.scene()
        sums = [placed_sum(draw, copy) for copy in draw.copies]
        assert scene.union() == minkref.unite(sums), draw.told
        for number, expected in enumerate(sums):
            assert scene.sum_of(number) == expected, (draw.told, number)


def test_areas_of_up_to_four_copies_are_those_of_inclusion_and_exclusion() -> None:
    for draw in drawn(draws(21, 140), SEED + 1, most=4):
        sums = [placed_sum(draw, copy) for copy in draw.copies]
        total = sum(
            (-1) ** (size - 1) * Fraction(minkref.intersect(list(some)).area())
            for size in range(1, len(sums) + 1)
            for some in combinations(sums, size)
        )
        assert Fraction(draw.scene().union().area()) == total, draw.told


def test_the_order_of_copies_does_not_matter() -> None:
    for draw in drawn(draws(14, 70), SEED + 2):
        dice = random.Random(draw.told)
        order = list(range(len(draw.copies)))
        dice.shuffle(order)
        first = draw.scene(passages=True)
        other = Scene(draw.robot, draw.shapes, [draw.copies[k] for k in order], passages=True)
        assert first.digest == other.digest, draw.told
        assert [p.points for p in first.passages()] == [p.points for p in other.passages()]
        again = [
            [sorted((order[o.copy], o.kind, o.edge, o.vertex) for o in side) for side in ring]
            for ring in other.owners()
        ]
        here = [
            [sorted((o.copy, o.kind, o.edge, o.vertex) for o in side) for side in ring]
            for ring in first.owners()
        ]
        assert again == here, draw.told


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_change_gives_the_scene_made_anew(robot: str) -> None:
    """Set, owners and passages; and the change back is the identity."""
    for draw in drawn(draws(4, 20), SEED + 3, robots=(robot,)):
        dice = random.Random(draw.told)
        scene = draw.scene(passages=True)
        before = everything(scene)
        for _ in range(4):
            at = dice.randrange(len(draw.copies))
            old = draw.copies[at]
            scale = dice.choice([None, *("1/3", "1/2", 1, 2, 5)])
            place = dice.choice([None, (dice.randint(-2, 4), Fraction(dice.randint(-4, 8), 2))])
            changed = scene.change(at, scale, place)
            copies = list(draw.copies)
            copies[at] = Copy(old.shape, scale or old.scale, place or old.place)
            told = (draw.told, at, scale, place)
            anew = Scene(draw.robot, draw.shapes, copies, passages=True)
            assert everything(changed) == everything(anew), told
            assert changed == anew, told
            assert everything(changed.change(at, old.scale, old.place)) == before, told
        assert everything(scene) == before, draw.told


@pytest.mark.parametrize("robot", ROBOTS)
def test_adding_and_removing_give_the_scene_made_anew(robot: str) -> None:
    for draw in drawn(draws(4, 20), SEED + 4, robots=(robot,)):
        grown = Scene(draw.robot, draw.shapes, [], passages=True)
        for number, copy in enumerate(draw.copies):
            grown = grown.add(copy.shape, copy.scale, copy.place)
            anew = Scene(draw.robot, draw.shapes, draw.copies[: number + 1], passages=True)
            assert everything(grown) == everything(anew), (draw.told, number)
        while grown.copies:
            grown = grown.remove(0)
            left = draw.copies[len(draw.copies) - len(grown.copies) :]
            anew = Scene(draw.robot, draw.shapes, left, passages=True)
            assert everything(grown) == everything(anew), (draw.told, len(left))


def test_a_copy_inside_of_the_other_sums_may_go() -> None:
    """The digest stays, as do all sides that it did not own."""
    gone = 0
    for draw in drawn(draws(21, 140), SEED + 5):
        sums = [placed_sum(draw, copy) for copy in draw.copies]
        scene = draw.scene()
        for number in range(len(sums)):
            others = sums[:number] + sums[number + 1 :]
            if not minkref.subtract(sums[number], others).is_empty:
                continue
            gone += 1
            assert scene.remove(number).digest == scene.digest, (draw.told, number)
    assert gone > 3


def test_scaling_and_moving_everything_scales_and_moves_the_union() -> None:
    factor, by = Fraction(3, 2), (Fraction(1, 3), Fraction(-7))
    for draw in drawn(draws(14, 70), SEED + 6):
        copies = [
            Copy(copy.shape, copy.scale * factor, tuple(
                factor * x + move for x, move in zip(copy.place, by, strict=True)
            ))
            for copy in draw.copies
        ]  # fmt: skip
        other = Scene(draw.robot.scaled(factor), draw.shapes, copies)
        expected = draw.scene().union().scaled(factor).translated(*by)
        assert other.union() == expected, draw.told


def test_a_shape_of_two_parts_is_two_copies() -> None:
    """Sums distribute over unions: digest and tight passages stay, if the parts are copies."""
    whole = PolygonSet([[[(0, 0), (1, 0), (1, 1), (0, 1)]], [[(2, 0), (3, 0), (3, 2), (2, 2)]]])
    parts = {"left": PolygonSet(whole.rings()[0]), "right": PolygonSet(whole.rings()[1])}
    for name in ROBOTS:
        for scale in ("1/2", 1, "3/2"):
            one = Scene(ROBOTS[name], [whole], [Copy(0, scale)], passages=True)
            two = Scene(ROBOTS[name], parts, [Copy(p, scale) for p in parts], passages=True)
            assert one.digest == two.digest, (name, scale)
            points = [[p.points for p in scene.passages()] for scene in (one, two)]
            assert points[0] == points[1], (name, scale)


def test_a_copy_alone_is_the_sum_with_its_passages() -> None:
    for draw in drawn(draws(21, 70), SEED + 7, most=1):
        [copy] = draw.copies
        scene = draw.scene(passages=True)
        shape, robot = draw.shapes[str(copy.shape)], turned(draw.robot)
        expected = [
            [(x + copy.place[0], y + copy.place[1]) for x, y in p["points"]]
            for p in minkref.tight_passages(shape.scaled(copy.scale), robot)
        ]
        assert [list(p.points) for p in scene.passages()] == sorted(expected), draw.told


def test_threads_change_nothing() -> None:
    for draw in drawn(draws(7, 35), SEED + 8, most=8):
        many = Scene(draw.robot, draw.shapes, draw.copies, passages=True, threads=3)
        assert everything(many) == everything(draw.scene(passages=True)), draw.told


@pytest.mark.parametrize("robot", SOLID)
def test_passages_touch_every_obstacle_that_they_meet_and_collide_with_none(robot: str) -> None:
    """Asks pairs of triangles, at ends and middles."""
    seen = 0
    for draw in drawn(draws(10, 60), SEED + 11, robots=(robot,)):
        robot_turned = turned(draw.robot)
        for passage in draw.scene(passages=True).passages():
            seen += 1
            ends = list(passage.points)
            middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in pairwise(ends)]
            for x, y in ends + middles:
                met = [
                    minkref.decide(
                        draw.shapes[str(copy.shape)], robot_turned, copy.scale,
                        x - copy.place[0], y - copy.place[1],
                    )["contact"]
                    for copy in draw.copies
                ]  # fmt: skip
                assert "overlapping" not in met and "touching" in met, (draw.told, x, y)
    assert seen or robot == "point"


def test_a_scene_is_a_value() -> None:
    for draw in drawn(draws(7, 14), SEED + 12):
        scene = draw.scene(passages=True)
        again = pickle.loads(pickle.dumps(scene))
        assert again == scene and hash(again) == hash(scene)
        assert everything(again) == everything(scene)
        assert copies_of_values.copy(scene) is scene is copies_of_values.deepcopy(scene)
        other = scene.change(0, scale=7)
        assert other != scene and scene.copies == draw.copies
        assert list(scene.shapes) == list(draw.shapes) and scene.robot == draw.robot
