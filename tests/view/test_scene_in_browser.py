"""The page of a scene in headless Chromium: its sums against the exact ones, the free space, the
robot, and what a hand does."""

from __future__ import annotations

import json
import math
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest
from minkref.reports.evidence.framework.browser import Browser, absent
from minkref.scene.scene_file import read_scene_file
from scene_pages import ScenePage, part_of, placed_sums, side_of
from thoroughness import draws

pytestmark = pytest.mark.skipif(absent() is not None, reason=f"no browser: {absent()}")

SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
UNIT = "POLYGON((0 0,1 0,1 1,0 1,0 0))"
SHAPES = {
    "box": "POLYGON((-1 0,1 0,1 1,-1 1,-1 0))",
    "dart": "POLYGON((0 0,2 -1,1 0,2 1,0 0))",
    "frame": "POLYGON((-3 -3,3 -3,3 3,-3 3,-3 -3),(-2 -2,-2 2,2 2,2 -2,-2 -2))",
    "segment": "LINESTRING(0 0,2 1)",
    "point": "POINT(1 1)",
}
ROBOTS = [UNIT, "POLYGON((0 0,1 -1,0 2,-1 -1,0 0))", "LINESTRING(0 0,1 0)", "POINT(1 0)"]
FIVE_BOXES = {
    "robot": "POLYGON((0 0,1 0,1 1,0 1,0 0))",
    "shapes": {"box": UNIT, "bar": "POLYGON((0 0,4 0,4 1,0 1,0 0))"},
    "copies": [
        {"shape": "box", "scale": 1, "place": [0, 0]},
        {"shape": "box", "scale": 2, "place": ["7/2", 0]},
        {"shape": "bar", "scale": "1/2", "place": [0, 5]},
    ],
}


def drawn_scene(seed: int, index: int) -> dict[str, Any]:
    """A random scene on a lattice of halves: sums touch, abut and overlap along edges."""
    dice = random.Random(f"{seed}, {index}")
    robot = ROBOTS[index % len(ROBOTS)]
    flat = {"segment", "point"} if not robot.startswith("POLYGON") else set()
    shapes = {name: text for name, text in SHAPES.items() if name not in flat}
    copies = [
        {
            "shape": dice.choice(list(shapes)),
            "scale": dice.choice(["1/2", "1", "3/2", "2"]),
            "place": [str(Fraction(dice.randint(-8, 12), 2)) for _ in "xy"],
        }
        for _ in range(dice.randint(1, 7))
    ]
    return {"robot": robot, "shapes": shapes, "copies": copies}


def same_rings(got: list[list[float]], wanted: minkref.PolygonSet) -> bool:
    """Whether the rings of a sum are these, up to roundings, in any order from any vertex."""
    rings = [list(zip(ring[::2], ring[1::2], strict=True)) for ring in got]
    left = [[(float(x), float(y)) for x, y in ring] for each in wanted.rings() for ring in each]
    for ring in rings:
        found = next((other for other in left if _is_turn(ring, other)), None)
        if found is None:
            return False
        left.remove(found)
    return not left


def _is_turn(ring: list[Any], other: list[Any]) -> bool:
    return len(ring) == len(other) and any(
        all(math.dist(p, q) < 1e-9 for p, q in zip(ring[k:] + ring[:k], other, strict=True))
        for k in range(len(ring))
    )


@pytest.mark.parametrize("index", range(4))
def test_sums_and_the_robot_are_right_after_changes(
    window: Browser, tmp_path: Path, index: int
) -> None:
    scene = drawn_scene(2012, index)
    page = ScenePage(window, tmp_path, scene)
    dice = random.Random(f"changes, {index}")
    for _ in range(draws(2, 10)):
        number = dice.randrange(len(page.copies))
        place = [str(Fraction(dice.randint(-8, 12), 2)) for _ in "xy"]
        page.run("window.minkref.change(...arguments)", number, page.copies[number]["scale"], place)
    sums = placed_sums(scene, page.copies)
    for got, wanted in zip(page.run("return window.minkref.sums()"), sums, strict=True):
        assert same_rings(got, wanted), (index, page.copies)
    for _ in range(draws(20, 200)):
        at = (Fraction(dice.randint(-12, 20), 2), Fraction(dice.randint(-12, 20), 2))
        sides = {side_of(each, at) for each in sums}
        state = next(side for side in ("blocked", "touching", "free") if side in sides)
        got = page.run("return window.minkref.situation(...arguments)", *map(float, at))
        assert got == state, (index, at)
    page.at_rest()
    assert window.messages() == []


@pytest.mark.parametrize("index", range(4))
def test_one_colour_is_connected_and_different_ones_are_apart(
    window: Browser, tmp_path: Path, index: int
) -> None:
    """One number with contact forbidden means one exact part; two numbers with contact allowed
    mean two."""
    scene = drawn_scene(7, index)
    page = ScenePage(window, tmp_path, scene)
    union = minkref.unite(placed_sums(scene, page.copies))
    dice = random.Random(f"places, {index}")
    places = [
        (Fraction(dice.randint(-96, 160), 16), Fraction(dice.randint(-96, 160), 16))
        for _ in range(60)
    ]
    exact = {at: part_of(union, at) for at in places if side_of(union, at) == "free"}
    assert len(exact) > 10
    for rule in ("forbidden", "allowed"):
        page.click("fit")
        page.click(f"contact-{rule}")
        for wait in (page.drawn, page.at_rest, lambda: zoom_in(page)):
            wait()
            named = [(page.name_at(at), exact[at]) for at in exact]
            for name, part in named:
                if name < 0:
                    continue
                if rule == "forbidden":
                    assert {other for its, other in named if its == name} == {part}, index
                else:
                    assert {its for its, other in named if other == part and its >= 0} == {name}
    assert window.messages() == []


def zoom_in(page: ScenePage) -> None:
    """Shows a part of the scene only."""
    page.turn(page.pixel(2, 2), -600, shift=False)
    page.at_rest()


def test_what_a_wall_beyond_the_picture_parts_is_not_told_apart(
    window: Browser, tmp_path: Path
) -> None:
    wall = {"wall": "POLYGON((-9 0,9 0,9 1,-9 1,-9 0))"}
    copies = [{"shape": "wall", "scale": 1, "place": [0, 0]}]
    page = ScenePage(window, tmp_path, {"robot": UNIT, "shapes": wall, "copies": copies})
    page.turn(page.pixel(0, 0), -900, shift=False)
    above, below = (Fraction(0), Fraction(3, 2)), (Fraction(0), Fraction(-3, 2))
    for rule, same in (("allowed", True), ("forbidden", False)):
        page.click(f"contact-{rule}")
        for wait in (page.drawn, page.at_rest):
            wait()
            names = [page.name_at(above), page.name_at(below)]
            assert min(names) >= 0
            assert (names[0] == names[1]) is same, rule


def ring_of_boxes(gap: str) -> dict[str, Any]:
    """A robot of side 1 among bars around a room, whose door is as wide as `gap`."""
    bars = {"lying": "POLYGON((0 0,6 0,6 1,0 1,0 0))", "standing": "POLYGON((0 0,1 0,1 6,0 6,0 0))"}
    places = [
        ("lying", 0, 0),
        ("lying", 0, 7),
        ("standing", 0, 1),
        ("standing", 6, str(1 + Fraction(gap))),
    ]
    copies = [{"shape": name, "scale": 1, "place": [str(x), str(y)]} for name, x, y in places]
    return {"robot": UNIT, "shapes": bars, "copies": copies}


@pytest.mark.parametrize(
    ("gap", "forbidden", "allowed"), [("0", 2, 2), ("1/2", 2, 2), ("1", 2, 1), ("3/2", 1, 1)]
)
def test_a_door_as_wide_as_the_robot_opens_where_contact_is_allowed(
    window: Browser, tmp_path: Path, gap: str, forbidden: int, allowed: int
) -> None:
    page = ScenePage(window, tmp_path, ring_of_boxes(gap))
    for rule, parts in (("forbidden", forbidden), ("allowed", allowed)):
        page.click(f"contact-{rule}")
        for wait in (page.drawn, page.at_rest):
            wait()
            names = page.run("return window.minkref.free.names")
            assert len(names) == parts, rule
            assert page.text("situation").startswith(f"{parts} free part")
    assert page.run("return window.minkref.free.hasSeams") == (gap == "1")
    page.window.save_screenshot(_shot(f"door-{gap.replace('/', '-')}"))
    assert window.messages() == []


def room(gap: str) -> str:
    """A room of one polygon, with a door of this width."""
    top = Fraction(gap) + 2
    return f"POLYGON((0 0,6 0,6 2,5 2,5 1,1 1,1 5,5 5,5 {float(top)},6 {float(top)},6 6,0 6,0 0))"


@pytest.mark.parametrize(
    ("gap", "scale", "parts"),
    [("1", "1", (2, 1)), ("1", "1.0", (2, 1)), ("1", "1.5", (1, 1)), ("1/2", "2.00", (2, 1))],
)
def test_a_passage_of_a_copy_itself_is_known_at_its_exact_scale(
    window: Browser, tmp_path: Path, gap: str, scale: str, parts: tuple[int, int]
) -> None:
    copies = [{"shape": "room", "scale": 1, "place": ["1/2", 0]}]
    page = ScenePage(
        window, tmp_path, {"robot": UNIT, "shapes": {"room": room(gap)}, "copies": copies}
    )
    page.run("window.minkref.change(0, arguments[0], ['1/2', '0.25'])", scale)
    page.click("fit")
    for rule, count in zip(("forbidden", "allowed"), parts, strict=True):
        page.click(f"contact-{rule}")
        for wait in (page.drawn, page.at_rest):
            wait()
            assert len(page.run("return window.minkref.free.names")) == count, rule
    factor = Fraction(scale)
    at = (float(factor * Fraction(11, 2)), float(2 * factor + Fraction(1, 4)))
    state = page.run("return window.minkref.situation(...arguments)", *at)
    assert state == "touching"


def _shot(name: str) -> Path:
    SHOTS.mkdir(parents=True, exist_ok=True)
    return SHOTS / f"scene-{name}.png"


def test_a_copy_is_dragged_to_short_exact_decimals(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    start = page.pixel(0.5, 0.5)
    before = page.copies
    step = abs(page.pixel(1, 0)[0] - page.pixel(0, 0)[0])
    page.drag(start, [start[0] + 5, start[1]], [start[0] + 2 * step, start[1] - step])
    after = page.copies
    assert after[1:] == before[1:]
    assert [float(axis) for axis in after[0]["place"]] == pytest.approx([2, 1], abs=1 / step)
    assert all(len(axis) < 8 for axis in after[0]["place"])
    assert [page.value("copy-x"), page.value("copy-y")] == after[0]["place"]
    assert page.text("copy-name") == "Copy 0: box"
    assert page.run("return window.minkref.isChanged")
    page.click("as-read")
    assert page.copies == before
    assert not page.run("return window.minkref.isChanged")


def test_a_copy_is_scaled_by_handle_wheel_slider_and_field(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    page.drag(page.pixel(0.5, 0.5))  # chooses it
    page.drag(page.pixel(1, 1), page.pixel(1.2, 1.3), page.pixel(1.5, 1.5))
    handled = page.copies[0]["scale"]
    assert float(handled) == pytest.approx(1.5, abs=0.02)
    page.drag(page.pixel(1.5, 1.5), page.pixel(9, 9))
    assert page.copies[0]["scale"] == "4"  # twice the greatest of this shape
    page.turn(page.pixel(0.5, 0.5), 200, shift=True)
    assert float(page.copies[0]["scale"]) == pytest.approx(4 * math.exp(-0.1), rel=1e-3)
    assert page.copies[0]["place"] == ["0", "0"]
    page.run(
        "const slider = document.getElementById('copy-slider'); slider.value = arguments[0];"
        "slider.dispatchEvent(new Event('input'))",
        0,
    )
    page.drawn()
    assert page.copies[0]["scale"] == page.value("copy-scale") == "1/2"
    for text, bad in (("7/5", False), ("1.25", False), ("0.4", True), ("x", True), ("1/0", True)):
        assert page.enter("copy-scale", text) is bad, text
    assert page.copies[0]["scale"] == "1.25"
    for text, bad in (("-1/3", False), ("-2.5e0", False), ("", True), ("1,5", True)):
        assert page.enter("copy-x", text) is bad, text
    assert page.copies[0]["place"] == ["-2.5e0", "0"]
    assert window.messages() == []


def test_the_copied_scene_is_read_exactly(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    page.drag(page.pixel(4.5, 1), page.pixel(4.8, 1.4), page.pixel(5.1, 2.2))
    page.enter("copy-scale", "7/5")
    page.click("duplicate")
    page.run(
        "window.taken = null; Object.defineProperty(navigator, 'clipboard', {value:"
        "{writeText: async (text) => { window.taken = text; }}})"
    )
    page.click("copy-file")
    text = page.run("return window.taken")
    assert json.loads(text) == page.run("return window.minkref.file")
    assert "minkref scene -" in page.text("copied")
    read, copies = read_scene_file(text), page.copies
    assert len(read.copies) == len(copies) == 4
    for row, copy in zip(read.copies, copies, strict=True):
        assert row == (copy["shape"], *(str(Fraction(n)) for n in (copy["scale"], *copy["place"])))
    assert read.robot.set == minkref.PolygonSet(UNIT)
    page.click("remove")
    assert len(page.copies) == 3


def test_without_a_clipboard_the_text_is_shown(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    page.run(
        "Object.defineProperty(navigator, 'clipboard', {value:"
        "{writeText: async () => { throw new Error('no'); }}})"
    )
    page.click("copy-file")
    assert json.loads(page.value("file"))["schema"] == "scene-v1"


def test_the_robot_tells_what_it_meets_and_can_be_pinned(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    states = {(2.5, 3): "free", (1, 0.5): "touching", (0.25, 0.25): "blocked"}
    for at, state in states.items():
        page.point(*at)
        assert page.run("return window.minkref.robot") == state
    assert "not free, meets copy 0 (box)" in page.text("robot")
    page.drag(page.pixel(2.5, 3))
    assert "pinned at (2.5, 3): free, in the outside" in page.text("robot")
    page.run("window.minkref.change(0, '1', ['2', '3'])")
    page.drawn()
    assert "meets copy 0 (box)" in page.text("robot")
    page.run("dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}))")
    page.point(2.5, 1)
    assert "pinned" not in page.text("robot")


def test_the_background_moves_the_view_and_the_wheel_zooms(window: Browser, tmp_path: Path) -> None:
    page = ScenePage(window, tmp_path, FIVE_BOXES)
    before, copies = page.pixel(0, 0), page.copies
    start = page.pixel(2.5, 3.5)
    page.drag(start, [start[0] + 40, start[1] - 30])
    assert page.pixel(0, 0) == pytest.approx([before[0] + 40, before[1] - 30])
    at = page.pixel(1, 1)
    page.turn(at, -300, shift=False)
    assert page.pixel(1, 1) == pytest.approx(at, abs=1)  # wheels have whole pixels
    assert page.pixel(2, 1)[0] > at[0]
    page.click("fit")
    assert page.pixel(0, 0) == pytest.approx(before, abs=1)
    assert page.copies == copies


TINY = "POLYGON((0 0,1e-200 0,0 1e-200,0 0))"
UNUSUAL = [  # robot, shape, copies
    (UNIT, UNIT, []),
    ("POINT(0 0)", UNIT, [("1", "0", "0")]),
    (UNIT, "POLYGON EMPTY", [("1", "0", "0")]),
    (UNIT, "POINT(0 0)", [("1e-9", "1e9", "0")] * 2),
    (TINY, TINY, [("2", "1e-200", "0")]),
]


@pytest.mark.parametrize(("robot", "shape", "copies"), UNUSUAL)
def test_unusual_scenes_have_a_page(
    window: Browser, tmp_path: Path, robot: str, shape: str, copies: list[tuple[str, str, str]]
) -> None:
    listed = [{"shape": "one", "scale": scale, "place": place} for scale, *place in copies]
    scene = {"robot": robot, "shapes": {"one": shape}, "copies": listed}
    page = ScenePage(window, tmp_path, scene)
    page.run("document.querySelector('#events tbody tr').click()")
    page.click("contact-allowed")
    start = page.run(
        "const canvas = document.getElementById('picture');"
        "return [canvas.clientWidth / 2, canvas.clientHeight / 2]"
    )
    page.drag(start, [start[0] + 10, start[1] + 10], [start[0] + 20, start[1] + 30])
    page.at_rest()
    if page.copies:
        read_scene_file(json.dumps(page.run("return window.minkref.file")))
    assert window.messages() == []
