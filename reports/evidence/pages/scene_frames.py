"""A scene's page with 100 copies: frames per second while dragging or scaling a copy."""

from __future__ import annotations

import json
import math
import os
import random
import tempfile
import time
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.output.documents import write_atomically
from minkref.reports.evidence.framework.browser import PACKAGES, Browser, absent, browser
from minkref.reports.evidence.framework.operands import operand
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.scene.copies_text import CopyRow
from minkref.scene.page.picture import picture
from minkref.scene.page.write_page import page

MINUTES = Minutes(0.3, 0.6, 1.5)
ALONE = True

SEED = 2012
COPIES = 100
SHAPES = ("g1", "g2", "g3", "glyph1204")  # the last has 1,204 vertices
SCALES = ("1/3", "1/2", "3/4", "1")
APART = 120  # between places, about as large as the shapes: many sums overlap
ROBOT = "POLYGON ((0 0, 6 0, 6 2, 2 2, 2 6, 0 6, 0 0))"
FRAMES = Counts(60, 240, 900)  # of each drag
DRAGGED = 3  # copies, the last of them the largest shape
WANTED = 59  # frames a second; a screen shows 60
CLOSE = 1e-9  # sizes of the scene
DRIVE = """
const [copy, frames, isHandle, done] = arguments, canvas = document.getElementById("picture");
const box = canvas.getBoundingClientRect(), { minkref } = window;
canvas.setPointerCapture = () => {};
const send = (type, [x, y], buttons) => canvas.dispatchEvent(new PointerEvent(type,
  { clientX: box.left + x, clientY: box.top + y, buttons, bubbles: true }));
const press = minkref.holdOf(copy, isHandle), spent = minkref.drawn.milliseconds, times = [];
send("pointerdown", press, 1);
const step = (now) => {
  times.push(now);
  if (times.length > frames) {
    send("pointerup", press, 0);
    done({ times, milliseconds: minkref.drawn.milliseconds - spent });
    return;
  }
  const turn = times.length / 20, reach = isHandle ? 15 : 90;
  const [x, y] = [reach * Math.sin(turn), reach * (1 - Math.cos(turn))];
  send("pointermove", [press[0] + x, press[1] + y], 1);
  requestAnimationFrame(step);
};
requestAnimationFrame(step);"""
IDLE = """
const done = arguments[0], times = [];
const step = (now) => {
  times.push(now);
  if (times.length > 60) done(times); else requestAnimationFrame(step);
};
requestAnimationFrame(step);"""


def run(findings: Findings, size: Size) -> None:
    began = time.perf_counter()
    robot, copies = operand(ROBOT).set, drawn_copies()
    shapes = {name: operand(name).set for name in SHAPES}
    data = picture(robot, shapes, copies, 2, lambda done, total: None)
    text = page("scene", "robot", data)
    findings.figures |= {
        "copies": len(copies),
        "seconds to make": round(time.perf_counter() - began, 1),
        "bytes": len(text.encode("utf-8")),
        "boundary events": sum(len(each["about"]) for each in data["sums"]),
    }
    reason = absent()
    if reason is not None:
        findings.note(f"install {' and '.join(PACKAGES)}, then run this part with --again")
        findings.target("frames in Chromium", False, "looked at", reason)
        return
    findings.note("frames of headless Chromium, which draws without a graphics card")
    with tempfile.TemporaryDirectory() as folder, browser() as window:
        path = Path(folder, "scene.html")
        write_atomically(path, text)
        _look(findings, window, path, size.of(FRAMES))
        _compare(findings, window, robot, list(shapes.values()))


def drawn_copies() -> list[CopyRow]:
    """Copies on a lattice of places, each moved a little."""
    dice = random.Random(SEED)
    across = math.isqrt(COPIES)
    return [
        CopyRow(
            number % len(SHAPES),
            dice.choice(SCALES),
            str(APART * (number % across) + dice.randint(-10, 10)),
            str(APART * (number // across) + dice.randint(-10, 10)),
        )
        for number in range(COPIES)
    ]


def _look(findings: Findings, window: Browser, path: Path, frames: int) -> None:
    began = time.perf_counter()
    window.open(path)
    driver = window.service.process.pid
    idle = rate(_asked(window, IDLE))
    findings.figures |= {
        "seconds to open": round(time.perf_counter() - began, 1),
        "frames a second of the page at rest": round(idle, 1),
    }
    for what, is_handle in (("dragged", False), ("scaled", True)):
        rates, scripts, slow = [], [], 0
        before = processor_seconds(driver)
        for copy in range(COPIES // 2, COPIES // 2 + DRAGGED):
            ran = _asked(window, DRIVE, copy, frames, is_handle)
            rates.append(rate(ran["times"]))
            scripts.append(ran["milliseconds"] / frames)
            slow += sum(b - a > 25 for a, b in zip(ran["times"], ran["times"][1:], strict=False))
        findings.figures |= {
            f"milliseconds of scripts a frame, {what}": round(max(scripts), 1),
            f"milliseconds of processors a frame, {what}": round(
                1000 * (processor_seconds(driver) - before) / (frames * DRAGGED), 1
            ),
            f"frames left out, {what}": f"{slow} of {frames * DRAGGED}",
        }
        least = min(rates)
        findings.target(
            f"frames a second, a copy {what}", least >= WANTED, f"at least {WANTED}", f"{least:.1f}"
        )
    findings.none("errors of the page", window.messages())


def _asked(window: Browser, script: str, *arguments: Any) -> Any:
    """Run a script; return the value passed to its callback."""
    return window.execute_async_script(script, *arguments)


def processor_seconds(ancestor: int) -> float:
    """Sum the processor time of a living process and all its living descendants."""
    ticks, parents = {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue
        process = int(folder.name)
        parents[process], ticks[process] = int(fields[1]), int(fields[11]) + int(fields[12])
    total, left = 0, [ancestor]
    while left:
        one = left.pop()
        total += ticks.get(one, 0)
        left += [process for process, parent in parents.items() if parent == one]
    return total / os.sysconf("SC_CLK_TCK")


def rate(times: list[float]) -> float:
    """Frames per second from frame times in milliseconds."""
    return 1000 * (len(times) - 1) / (times[-1] - times[0])


def _compare(
    findings: Findings, window: Browser, robot: _core.PolygonSet, shapes: list[_core.PolygonSet]
) -> None:
    """Compare dragged and scaled copies with exact placed sums."""
    copies: list[dict[str, Any]] = window.run("return window.minkref.copies")
    drawn: list[list[list[float]]] = window.run("return window.minkref.sums()")
    turned = robot.scaled("-1")
    changed = range(COPIES // 2, COPIES // 2 + DRAGGED)
    right = 0
    for number in changed:
        copy = copies[number]
        scale, x, y = (str(Fraction(text)) for text in (copy["scale"], *copy["place"]))
        wanted = _core.minkowski_sum(shapes[copy["shape"]], turned, scale).region.translated(x, y)
        right += same_set(drawn[number], wanted)
    findings.equal("changed copies whose sums are the exact ones", len(changed), right)


def same_set(rings: list[list[float]], wanted: _core.PolygonSet) -> bool:
    """Whether drawn rings bound the exact set, up to roundings: the areas on one side only are
    small. At an event the page may keep straight vertices, and slits that have just closed."""
    polygons = [{"outer": _exact(ring), "holes": []} for ring in rings]
    drawn = _core.PolygonSet.from_json(json.dumps({"polygons": polygons}))
    reach = CLOSE * (APART * math.isqrt(COPIES)) ** 2
    apart = [_core.combined("difference", pair)[0] for pair in ([drawn, wanted], [wanted, drawn])]
    return all(Fraction(each.area()) < reach for each in apart)


def _exact(ring: list[float]) -> list[tuple[str, str]]:
    return [
        (str(Fraction(x)), str(Fraction(y))) for x, y in zip(ring[::2], ring[1::2], strict=True)
    ]
