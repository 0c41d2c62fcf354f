"""`minkref view` with general polyhedra: the page's content against `minkref sum`, and the cut with
headless Chromium."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.cli.cli import run
from minkref.reports.evidence.framework import browser as framework
from minkref.schemas import schema
from thoroughness import some

View = Callable[..., tuple[Path, dict[str, Any]]]
SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
SCALES = ["1", "1/2", "2,1,3/2"]
FRAME = [[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]]
BOX = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def off(points: list[Any], faces: list[Any]) -> str:
    rows = ["OFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(map(str, point)) for point in points]
    rows += [" ".join(map(str, (len(face), *face))) for face in faces]
    return "\n".join(rows) + "\n"


def corners(low: int, high: int) -> list[Any]:
    return [(x, y, z) for x in (low, high) for y in (low, high) for z in (low, high)]


def angle() -> str:
    """A prism over an L."""
    ring = [(0, 0), (5, 0), (5, 1), (1, 1), (1, 4), (0, 4)]
    sides = [(k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k) for k in range(6)]
    points = [(x, y, z) for z in (0, 2) for x, y in ring]
    return off(points, [range(5, -1, -1), range(6, 12), *sides])


@pytest.fixture
def files(tmp_path: Path) -> dict[str, str]:
    hollow = [list(face) for face in BOX] + [[8 + v for v in face[::-1]] for face in BOX]
    texts = {
        "cube": off(corners(0, 1), list(BOX)),
        "hollow": off(corners(0, 3) + corners(1, 2), hollow),
        "flat": off([(0, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0), (1, 2, 0), (0, 2, 0)], [range(6)]),
        "point": "OFF\n1 0 0\n1 2 3\n",
        "angle": angle(),
        "tetrahedron": off(
            [(0, 0, 0), (2, 1, 0), (0, 2, 1), (1, 0, 3)],
            [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)],
        ),
    }
    paths = {name: tmp_path / f"{name}.off" for name in texts}
    for name, text in texts.items():
        paths[name].write_text(text, encoding="utf-8")
    return {name: str(path) for name, path in paths.items()}


@pytest.fixture
def scales(tmp_path: Path) -> Path:
    path = tmp_path / "scales.txt"
    path.write_text("\n".join(SCALES) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def call(capsys: pytest.CaptureFixture[str]) -> Callable[..., dict[str, Any]]:
    def called(*words: str | Path) -> dict[str, Any]:
        assert run([*map(str, words), "--json"]) == 0
        value: dict[str, Any] = json.loads(capsys.readouterr().out)
        return value

    return called


@pytest.fixture
def view(tmp_path: Path, call: Callable[..., dict[str, Any]]) -> View:
    def viewed(*words: str | Path) -> tuple[Path, dict[str, Any]]:
        page = tmp_path / "page.html"
        value = call("view", *words, "-o", page)
        jsonschema.validate(value, schema("view"))
        return page, value

    return viewed


def data_of(page: Path) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    text = page.read_text(encoding="utf-8")
    parts = [
        re.search(rf'<script id="{name}" type="application/json">(.*?)</script>', text, re.S)
        for name in ("operands", "data")
    ]
    assert parts[0] and parts[1]
    return json.loads(parts[0][1]), json.loads(parts[1][1])


def area(points: list[list[float]], ring: list[int]) -> list[float]:
    """Twice the vector area, by Newell."""
    total = [0.0, 0.0, 0.0]
    for k, v in enumerate(ring):
        a, b = points[v], points[ring[(k + 1) % len(ring)]]
        for i in range(3):
            j, n = (i + 1) % 3, (i + 2) % 3
            total[i] += (a[j] - b[j]) * (a[n] + b[n])
    return total


@pytest.mark.parametrize("names", [("hollow", "cube"), ("cube", "flat"), ("hollow", "hollow")])
def test_each_frame_is_the_sum(
    view: View, call: Any, files: dict[str, str], scales: Path, names: tuple[str, str]
) -> None:
    P, Q = (files[name] for name in names)
    page, value = view(P, Q, "--scales", scales)
    frames = data_of(page)[1]
    for frame, row, scale in zip(frames, value["frames"], SCALES, strict=True):
        true = call("sum", P, Q, "--scale", scale)
        facets = true["surface"]["facets"]
        for name in ("digest", "volume", "facets", "components", "cavities", "tunnels"):
            assert row[name] == frame[name] == true[name]
        assert frame["points"] == true["surface"]["vertices"]
        assert frame["outlines"] == [facet["rings"] for facet in facets]
        expected = [[[pair["P"], pair["Q"]] for pair in facet["parents"]] for facet in facets]
        assert frame["parents"] == expected
        assert sum(frame["kinds"].values()) == frame["facets"]
        assert row["fv_errors"] is None
        for point, near in zip(frame["points"], frame["near"], strict=True):
            for axis in range(3):
                place = frame["centre"][axis] + frame["size"] * near[axis]
                assert abs(place - Fraction(point[axis])) < 1e-12
        for rings, triangles in zip(frame["outlines"], frame["triangles"], strict=True):
            outline = [sum(x) for x in zip(*(area(frame["near"], r) for r in rings), strict=True)]
            filled = [
                sum(x) for x in zip(*(area(frame["near"], t) for t in triangles), strict=True)
            ]
            assert outline == pytest.approx(filled, abs=1e-9)


def test_faces_of_operands_that_are_not_convex_are_cut(view: View, files: dict[str, str]) -> None:
    operands = data_of(view(files["flat"], files["cube"])[0])[0]
    assert len(operands["P"]["triangles"][0]) == 4
    assert "triangles" not in operands["Q"]
    assert {point[2] for point in operands["P"]["near"]} == {0.0}


def test_what_has_no_volume_is_refused(
    files: dict[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.html"
    for names in (("hollow", "point"), ("flat", "flat")):
        assert run(["view", *(files[name] for name in names), "-o", str(page)]) == 2
        assert "volume" in capsys.readouterr().err
        assert not page.exists()


WINDOW = ("--from", "1/5", "--to", "2")


def test_a_window_has_an_axis_of_events(view: View, call: Any, files: dict[str, str]) -> None:
    P, Q = files["angle"], files["tetrahedron"]
    page, value = view(P, Q, *WINDOW)
    text = page.read_text(encoding="utf-8")
    part = re.search(r'<script id="events" type="application/json">(.*?)</script>', text, re.S)
    assert part
    axis = json.loads(part[1])
    true = call("events", P, Q, *WINDOW, "--kind", "arrangement")
    assert value["events"] == axis["counts"] == true["kinds"]
    assert sum(map(sum, axis["bins"])) == true["count"] > 0
    scales = [Fraction(event["s"]) for event in true["events"]]
    for frame, row in zip(axis["frames"], value["frames"], strict=True):
        s = Fraction(row["scale"][0])
        assert frame["at"] == scales.count(s)
        below = max((other for other in scales if other < s), default=None)
        above = min((other for other in scales if other > s), default=None)
        assert frame["below"] == (None if below is None else str(below))
        assert frame["above"] == (None if above is None else str(above))
    assert value["frames"][0]["scale"] == ["1/5"] * 3 and axis["frames"][-1]["share"] == 1
    _, still = view(P, Q)
    assert still["events"] is None


def test_events_are_those_of_one_factor(
    files: dict[str, str], scales: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ("view", files["angle"], files["cube"], "--scales", str(scales), *WINDOW)
    assert run([*words, "-o", str(tmp_path / "page.html")]) == 2
    assert "one factor" in capsys.readouterr().err


in_browser = pytest.mark.skipif(
    framework.absent() is not None, reason=f"no browser: {framework.absent()}"
)
TEXT = "return document.getElementById(arguments[0]).textContent"
SETTLED = "return new Promise((done) => setTimeout(done, 300))"
SET = """for (const [name, value] of Object.entries(arguments[0])) {
      const box = document.getElementById(name);
      if (box.type === 'checkbox') box.checked = value; else box.value = value;
      box.dispatchEvent(new Event('input'));
    }
    return window.minkref.show(window.minkref.index).then(() => true)"""
#: The area of the section that is drawn, in units of the size of the sum, and its height.
SECTION = """const data = document.getElementById('plot-sum').data;
    const { x, y, z, i, j, k } = data.find((trace) => trace.name === 'section');
    const p = (n) => [x[n], y[n], z[n]], minus = (a, b) => a.map((axis, n) => axis - b[n]);
    let sum = 0;
    i.forEach((_, n) => {
      const [a, b, c] = [i[n], j[n], k[n]].map(p), u = minus(b, a), v = minus(c, a);
      sum += Math.hypot(u[1]*v[2]-u[2]*v[1], u[2]*v[0]-u[0]*v[2], u[0]*v[1]-u[1]*v[0]) / 2;
    });
    return sum"""


@in_browser
def test_the_axis_follows_the_frame_and_a_cut_lays_the_cavity_open(
    window: framework.Browser, view: View, files: dict[str, str]
) -> None:
    """Uses a single page: loading costs most."""
    page, value = view(files["hollow"], files["cube"], *WINDOW)
    last = len(value["frames"]) - 1
    assert value["frames"][last]["cavities"] == 1
    window.open(page)
    window.run("return window.minkref.ready.then(() => true)")
    assert window.run("return document.querySelectorAll('#axis rect').length") > 0
    assert "from 1/5 to 2" in window.run(TEXT, "axis-text")
    shown = "return document.querySelector('#axis .shown').id"
    assert window.run(shown) == "tick-0"
    window.run("return window.minkref.show(arguments[0]).then(() => true)", last)
    assert window.run(shown) == f"tick-{last}"
    assert "at this scale" in window.run(TEXT, "axis-here")
    window.run(SETTLED)
    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(SHOTS / "events-axis.png")
    assert "1 component, 1 cavity, 0 tunnels" in window.run(TEXT, "caption")
    names = "return document.getElementById('plot-sum').data.map((trace) => trace.name)"
    assert "section" not in window.run(names)
    for axis, place, flip, expected in (
        (0, 500, False, 49 - 1), (2, 100, False, 49), (1, 480, True, 49 - 1),
    ):  # fmt: skip
        window.run(SET, {"cut-axis": axis, "cut": place, "cut-flip": flip})
        assert window.run(SECTION) * 49 == pytest.approx(expected, abs=1e-3)
        assert window.run(TEXT, "cut-at").startswith("at ")
    window.run(SETTLED)
    window.save_screenshot(SHOTS / "hollow-cut.png")
    window.run(SET, {"cut-axis": ""})
    assert "section" not in window.run(names)


@in_browser
def test_parents_are_told_and_marked(
    window: framework.Browser, view: View, call: Any, files: dict[str, str]
) -> None:
    page, _ = view(files["flat"], files["cube"])
    true = call("sum", files["flat"], files["cube"])
    window.open(page)
    window.run("return window.minkref.ready.then(() => true)")
    for number, facet in some(enumerate(true["surface"]["facets"]), 3):
        window.run("return window.minkref.choose('facet', arguments[0]).then(() => true)", number)
        told = window.run(TEXT, "chosen")
        assert f"facet {number}:" in told
        assert told.count(" of P + ") == len(facet["parents"])
        marks = "return document.getElementById(arguments[0]).data.at(-1).x.length"
        assert all(window.run(marks, f"plot-{name}") > 0 for name in ("sum", "P", "Q"))
    window.run("return window.minkref.choose('vertex', 0).then(() => true)")
    assert "(0, 0, 0)" in window.run(TEXT, "chosen")
    window.save_screenshot(SHOTS / "flat-cube.png")
