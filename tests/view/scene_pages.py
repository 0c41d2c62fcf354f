"""Pages of scenes in the browser: opened, driven by the pointer, and held against exact sums."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
from minkref.reports.evidence.framework.browser import Browser
from page_decoder import page_of

Point = tuple[Fraction, Fraction]
DRAWN = "return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
FINE = """const done = arguments[0];
    const wait = () => window.minkref.free.isFine ? done() : setTimeout(wait, 20);
    wait();"""
SEND = """const [type, [x, y], buttons] = arguments, canvas = document.getElementById("picture");
    const box = canvas.getBoundingClientRect();
    canvas.setPointerCapture = () => {};
    canvas.dispatchEvent(new PointerEvent(type,
      {clientX: box.left + x, clientY: box.top + y, buttons, bubbles: true}));"""
TURN = """const [[x, y], deltaY, shiftKey] = arguments, canvas = document.getElementById("picture");
    const box = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new WheelEvent("wheel", {clientX: box.left + x, clientY: box.top + y,
      deltaY, shiftKey, cancelable: true}));"""


class ScenePage:
    """A scene's page, open in the browser."""

    def __init__(self, window: Browser, folder: Path, scene: dict[str, Any]) -> None:
        file = folder / "scene.json"
        file.write_text(json.dumps({"schema": "scene-v1", **scene}), encoding="utf-8")
        self.window = window
        window.prefer("light")
        window.open(page_of(folder, str(file)))
        self.drawn()

    def run(self, script: str, *arguments: Any) -> Any:
        return self.window.run(script, *arguments)

    def drawn(self) -> None:
        self.run(DRAWN)

    def at_rest(self) -> None:
        """Waits for fine cells."""
        self.drawn()
        self.window.execute_async_script(FINE)
        self.drawn()

    def text(self, name: str) -> str:
        found: str = self.run("return document.getElementById(arguments[0]).textContent", name)
        return found

    def value(self, name: str) -> str:
        found: str = self.run("return document.getElementById(arguments[0]).value", name)
        return found

    def enter(self, name: str, text: str) -> bool:
        """Types a text into a field; tells whether it is marked as bad."""
        bad: bool = self.run(
            "const field = document.getElementById(arguments[0]); field.value = arguments[1];"
            "field.dispatchEvent(new Event('change')); return field.classList.contains('bad')",
            name,
            text,
        )
        self.drawn()
        return bad

    def click(self, name: str) -> None:
        self.run("document.getElementById(arguments[0]).click()", name)
        self.drawn()

    def pixel(self, x: float, y: float) -> list[float]:
        found: list[float] = self.run("return window.minkref.pixelOf(...arguments)", x, y)
        return found

    def point(self, x: float, y: float) -> None:
        self.run(SEND, "pointermove", self.pixel(x, y), 0)
        self.drawn()

    def drag(self, start: list[float], *steps: list[float]) -> None:
        """From one pixel over others; lets go at the last."""
        self.run(SEND, "pointerdown", start, 1)
        for step in steps:
            self.run(SEND, "pointermove", step, 1)
            self.drawn()
        self.run(SEND, "pointerup", steps[-1] if steps else start, 0)
        self.drawn()

    def turn(self, at: list[float], delta: float, shift: bool) -> None:
        self.run(TURN, at, delta, shift)
        self.drawn()

    def name_at(self, place: Point) -> int:
        """The number of the free part there, -1 for none."""
        found: int = self.run("return window.minkref.nameAt(...arguments)", *map(float, place))
        return found

    @property
    def copies(self) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = self.run("return window.minkref.copies")
        return found


def placed_sums(scene: dict[str, Any], copies: list[dict[str, Any]]) -> list[minkref.PolygonSet]:
    """The exact sum of each copy with the turned robot; `copies` as the page tells them."""
    shapes = [minkref.PolygonSet(shape) for shape in scene["shapes"].values()]
    turned = minkref.PolygonSet(scene["robot"]).scaled("-1")
    return [
        minkref.minkowski_sum(shapes[copy["shape"]], turned, copy["scale"]).region.translated(
            *(str(Fraction(axis)) for axis in copy["place"])
        )
        for copy in copies
    ]


def side_of(region: minkref.PolygonSet, place: Point) -> str:
    """`free` outside of a set, `blocked` inside, `touching` on its boundary; exact."""
    x, y = place
    inside = False
    for ring in (ring for polygon in region.rings() for ring in polygon):
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
            turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
            if turn == 0 and min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by):
                return "touching"
            if (ay <= y) != (by <= y) and (turn > 0) == (by > ay):
                inside = not inside
    return "blocked" if inside else "free"


def part_of(union: minkref.PolygonSet, place: Point) -> int:
    """The number of the exact free part of a place outside of the union: that of the smallest ring
    around it, 0 for the outside."""
    around = [
        (box[2] - box[0], number)
        for number, ring in enumerate(
            (ring for polygon in union.rings() for ring in polygon), start=1
        )
        if side_of(minkref.PolygonSet(list(ring)), place) == "blocked"
        and (box := minkref.PolygonSet(list(ring)).bounding_box())
    ]
    return min(around)[1] if around else 0
