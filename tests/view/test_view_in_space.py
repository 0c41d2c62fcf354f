"""`minkref view` of convex polyhedra: what the page holds against `minkref sum`, refusals, and the
page in headless Chromium."""

from __future__ import annotations

import contextlib
import io
import json
import re
import sys
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.cli.cli import run
from minkref.exact import digest
from minkref.reports.evidence.framework import browser as framework
from minkref.schemas import result_schema, schema
from minkref.space.operand import read_space_operand
from minkref.space.page import view_page
from thoroughness import THOROUGH, some

View = Callable[..., tuple[Path, dict[str, Any]]]

SCALES = ["1", "1/2", "2,1/3,5", "1,4,1", "7/10,9/10,11/10"]
CUBE = (
    [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)],
    [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)],
)
OCTAHEDRON = (
    [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
    [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)],
)


def write_off(path: Path, solid: Any, factor: str = "1") -> str:
    points, faces = solid
    rows = ["OFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(str(Fraction(factor) * axis) for axis in point) for point in points]
    rows += [" ".join(map(str, (len(face), *face))) for face in faces]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return str(path)


@pytest.fixture
def cube(tmp_path: Path) -> str:
    return write_off(tmp_path / "cube.off", CUBE)


@pytest.fixture
def octahedron(tmp_path: Path) -> str:
    return write_off(tmp_path / "octahedron.off", OCTAHEDRON)


@pytest.fixture
def scales(tmp_path: Path) -> Path:
    path = tmp_path / "scales.txt"
    path.write_text("\n".join(SCALES) + "\n", encoding="utf-8")
    return path


@pytest.fixture
def view(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> View:
    """The page and the document of the command."""

    def call(*arguments: str | Path) -> tuple[Path, dict[str, Any]]:
        page = tmp_path / "page.html"
        assert run(["view", *map(str, arguments), "-o", str(page), "--json"]) == 0
        value: dict[str, Any] = json.loads(capsys.readouterr().out)
        return page, value

    return call


def data_of(page: Path) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """The operands and the frames in a page."""
    text = page.read_text(encoding="utf-8")
    parts = [
        re.search(rf'<script id="{name}" type="application/json">(.*?)</script>', text, re.S)
        for name in ("operands", "data")
    ]
    assert parts[0] and parts[1]
    return json.loads(parts[0][1]), json.loads(parts[1][1])


def split(scale: str) -> tuple[str, str, str]:
    parts = scale.split(",")
    return (parts * 3)[0], (parts * 3)[1], (parts * 3)[2]


def true_sum(P: str, Q: str, scale: str) -> _core.ConvexSum:
    """Found from scratch."""
    first, second = read_space_operand(P).body, read_space_operand(Q).body
    assert first is not None and second is not None
    return _core.convex_sum(first, second, split(scale), "brute-force")


def true_kinds(answer: _core.ConvexSum) -> dict[str, int]:
    names = {1: "v", 2: "e"}
    told = {"fe": "facet+edge", "ef": "edge+facet", "ff": "facet+facet"}
    told |= {kind: kind for kind in ("fv", "vf", "ee")}
    found = Counter(
        told[names.get(len(P), "f") + names.get(len(Q), "f")] for P, Q in answer.facet_parents
    )
    return {kind: found[kind] for kind in told.values()}


@pytest.mark.parametrize("names", [("gs3", "rod"), ("ti", "gs3")])
def test_each_frame_is_the_sum_found_from_scratch(
    view: View, scales: Path, names: tuple[str, str]
) -> None:
    page, value = view(*names, "--scales", scales)
    operands, frames = data_of(page)
    assert [frame["scale"] for frame in frames] == [list(split(scale)) for scale in SCALES]
    for frame, row, scale in zip(frames, value["frames"], SCALES, strict=True):
        true = true_sum(*names, scale)
        assert row == {name: frame[name] for name in row}
        assert frame["digest"] == digest(true.surface.canonical_json())
        assert Fraction(frame["volume"]) * 6 == Fraction(true.surface.sextuple_volume())
        assert frame["rings"] == true.surface.rings()
        assert frame["pairs"] == [number for pair in true.vertex_parents for number in pair]
        assert frame["kinds"] == true_kinds(true)
        assert sum(frame["kinds"].values()) == frame["facets"] == len(frame["rings"])
        assert drawn_off(operands, frame, true) < 1e-12


def drawn_off(operands: Any, frame: Any, true: _core.ConvexSum) -> float:
    """The largest distance of a drawn vertex from its place, relative to the sum's size."""
    pairs = zip(frame["pairs"][::2], frame["pairs"][1::2], strict=True)
    far = 0.0
    for (p, q), point in zip(pairs, true.surface.points(), strict=True):
        for axis in range(3):
            part = frame["P"][axis] * operands["P"]["near"][p][axis]
            part += frame["Q"][axis] * operands["Q"]["near"][q][axis]
            place = Fraction(point[axis]) - Fraction(frame["centre"][axis])
            far = max(far, abs(part - float(place / Fraction(frame["size"]))))
    return far


def test_parallel_cubes_have_sums_of_facets(view: View, cube: str) -> None:
    page, value = view(cube, cube, "--scale", "1,1/2,0.25")
    frame = value["frames"][0]
    assert {kind for kind, count in frame["kinds"].items() if count} == {"facet+facet"}
    assert (frame["kinds"]["facet+facet"], frame["vertices"], frame["edges"]) == (6, 8, 12)
    assert frame["volume"] == str(Fraction(2) * Fraction(3, 2) * Fraction(5, 4))
    assert frame["scale"] == ["1", "1/2", "1/4"]
    assert len(data_of(page)[1]) == 1


def test_cube_and_octahedron_have_all_three_kinds(view: View, cube: str, octahedron: str) -> None:
    _, value = view(cube, octahedron)
    kinds = value["frames"][0]["kinds"]
    assert kinds == {
        "fv": 6, "vf": 8, "ee": 12, "facet+edge": 0, "edge+facet": 0, "facet+facet": 0,
    }  # fmt: skip
    assert value["frames"][0]["scale"] == ["1", "1", "1"]


def test_the_update_is_told_frame_by_frame(view: View, scales: Path) -> None:
    _, value = view("gs3", "rod", "--scales", scales)
    P, Q = read_space_operand("gs3").body, read_space_operand("rod").body
    assert P is not None and Q is not None
    moving = _core.DynamicConvexSum(P, Q, split(SCALES[0]))
    for frame, scale in zip(value["frames"], SCALES, strict=True):
        did = moving.update(split(scale))
        assert all(frame[name] == did[name] for name in view_page.STEPS)
    assert not any(value["frames"][0][name] for name in view_page.STEPS)
    assert value["frames"][2]["fv_errors"] > 0


def test_documents_follow_the_published_schema(view: View, scales: Path) -> None:
    for options in ([], ["--scales", str(scales)]):
        page, value = view("gs3", "rod", *options)
        jsonschema.validate(value, result_schema("view_in_space"))
        jsonschema.validate(value, schema("view"))
        assert value["bytes"] == page.stat().st_size
        assert value["viewer"].startswith("plotly.js ")


def test_the_page_needs_nothing_else(view: View, cube: str) -> None:
    page, _ = view(cube, cube)
    text = page.read_text(encoding="utf-8")
    assert "default-src 'none'" in text
    assert "unsafe-eval" not in text
    library = view_page.viewer()
    assert library in text
    ours = text.replace(library, "")
    assert not re.search(r"<link|<img|<iframe|src=|@import|fetch\(|https?://", ours)


def test_names_of_files_are_texts(view: View, tmp_path: Path) -> None:
    name = write_off(tmp_path / "<b onclick=x>&.off", CUBE)
    text = view(name, name)[0].read_text(encoding="utf-8")
    assert "<b onclick" not in text
    assert "&lt;b onclick=x&gt;&amp;.off" in text


def test_coordinates_of_any_size_are_drawn(view: View, tmp_path: Path, octahedron: str) -> None:
    far = write_off(tmp_path / "far.off", CUBE, "1e400")
    page, value = view(far, octahedron, "--scale", "1e-400,1,1")
    frame = data_of(page)[1][0]
    assert frame["size"] is None
    assert frame["P"] == [0.0, 1.0, 1.0]
    assert value["frames"][0]["volume_approximate"] is None


REFUSALS = [
    (["--from", "1"], "give both"),
    (["--to", "2"], "give both"),
    (["--from", "2", "--to", "1"], "window is empty"),
    (["--route", "index"], "does not have this option in space"),
    (["--scale", "1,2"], "2 factors"),
    (["--scale", "0"], "scale is zero"),
    (["--scale", "1,-2,3"], "negative"),
    (["--scale", "1", "--scales", "here.txt"], "given twice"),
    (["--scales", "absent.txt"], "cannot be read"),
    (["-o", "page.svg"], "ending"),
]


@pytest.mark.parametrize(("options", "word"), REFUSALS)
def test_a_bad_option_is_refused_with_a_mend(
    options: list[str],
    word: str,
    cube: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["view", cube, cube, *options]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert word in captured.err and "fix:" in captured.err
    assert list(tmp_path.glob("*.html")) == []


@pytest.mark.parametrize("options", [["--scale", "2"], ["--scales", "scales.txt"]])
def test_options_of_space_are_refused_in_the_plane(
    options: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["view", "g1", "g2", *options]) == 2
    assert "does not have this option in the plane" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_point_is_refused(tmp_path: Path, cube: str, capsys: Any) -> None:
    point = tmp_path / "point.off"
    point.write_text("OFF\n1 0 0\n1 2 3\n", encoding="utf-8")
    page = tmp_path / "page.html"
    assert run(["view", cube, str(point), "-o", str(page)]) == 2
    assert "no volume" in capsys.readouterr().err
    assert not page.exists()


def test_more_frames_than_a_page_takes_are_refused(
    scales: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    page = tmp_path / "page.html"
    monkeypatch.setattr(view_page, "MOST_BYTES", 100_000)
    assert run(["view", "gs3", "rod", "--scales", str(scales), "-o", str(page)]) == 2
    told = capsys.readouterr().err
    assert "2 of the 5 frames fill" in told
    assert "at most 2 scales" in told
    monkeypatch.setattr(view_page, "MOST_BYTES", 1_000)
    assert run(["view", "gs3", "rod", "-o", str(page)]) == 2
    assert "one frame has more than" in capsys.readouterr().err
    assert not page.exists()


def test_without_the_viewer_it_is_said_what_to_install(
    cube: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    page = tmp_path / "page.html"
    monkeypatch.setitem(sys.modules, "plotly.offline", None)
    assert run(["view", cube, cube, "-o", str(page)]) == 2
    assert "pip install 'minkref[view]'" in capsys.readouterr().err
    assert not page.exists()


def test_people_are_told_what_is_in_the_page(
    scales: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.html"
    assert run(["view", "gs3", "rod", "--scales", str(scales), "-o", str(page)]) == 0
    told = capsys.readouterr().out
    for word in ("gs3 + rod", "5 scales", "fv-errors", "descent steps", str(page)):
        assert word in told


# The page, with a browser.

in_browser = pytest.mark.skipif(
    framework.absent() is not None, reason=f"no browser: {framework.absent()}"
)
SHOTS = Path(__file__).resolve().parents[2] / "build" / "view"
TEXT = "return document.getElementById(arguments[0]).textContent"
BOX = """const box = document.getElementById(arguments[0]).getBoundingClientRect();
    return [box.left, box.top, box.right, box.bottom].map((side) => side * devicePixelRatio)"""
SETTLED = "return new Promise((done) => setTimeout(done, 300))"
NOTES = ("GL Driver Message", "willReadFrequently", "software WebGL")  # of Chromium, about speed


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With a cube, an octahedron and scales."""
    made = tmp_path_factory.mktemp("solids")
    write_off(made / "cube.off", CUBE)
    write_off(made / "octahedron.off", OCTAHEDRON)
    (made / "scales.txt").write_text("\n".join(SCALES) + "\n", encoding="utf-8")
    return made


def made_once(folder: Path, name: str, *words: str) -> tuple[Path, dict[str, Any]]:
    """The page for solids from the folder or for models, and the command's document."""
    page, kept = folder / f"{name}.html", folder / f"{name}.json"
    if not kept.exists():
        said = io.StringIO()
        with contextlib.chdir(folder), contextlib.redirect_stdout(said):
            assert run(["view", *words, "-o", str(page), "--json"]) == 0
        kept.write_text(said.getvalue(), encoding="utf-8")
    return page, json.loads(kept.read_text(encoding="utf-8"))


WALK = ("walk", "octahedron.off", "rod", "--scales", "scales.txt")
CUBES = ("cubes", "cube.off", "octahedron.off")


def opened(window: framework.Browser, page: Path) -> None:
    """Opens the page unless it is open already: loading costs most."""
    if window.current_url == page.resolve().as_uri():
        return
    window.open(page)
    window.run("return window.minkref.ready.then(() => true)")
    window.run(SETTLED)


def slide(window: framework.Browser, frame: int) -> None:
    """As the arrow keys and the pointer do."""
    window.run(
        "const slider = document.getElementById('slider'); slider.value = arguments[0];"
        "slider.dispatchEvent(new Event('input'));"
        "return window.minkref.show(window.minkref.index).then(() => true)",
        frame,
    )


def coloured(window: framework.Browser, plot: str, shot: Path) -> dict[str, float]:
    """Shares of a picture's pixels that are blue, orange, red, and different from the ground."""
    from matplotlib.image import imread

    SHOTS.mkdir(parents=True, exist_ok=True)
    window.save_screenshot(shot)
    left, top, right, bottom = (round(side) for side in window.run(BOX, plot))
    pixels = imread(shot)[top:bottom, left:right, :3]
    red, green, blue = pixels[..., 0], pixels[..., 1], pixels[..., 2]
    return {
        "blue": float((blue > red + 0.15).mean()),
        "orange": float((red > blue + 0.15).mean()),
        "red": float(((red > green + 0.45) & (red > blue + 0.3)).mean()),
        "drawn": float((abs(pixels - pixels[2, 2]).max(axis=-1) > 0.1).mean()),
    }


def waited(window: framework.Browser, holds: Callable[[], bool]) -> None:
    for _ in range(40):
        if holds():
            return
        window.run(SETTLED)
    assert holds()


def said(window: framework.Browser) -> list[str]:
    """Messages on the console, but for those about how fast software draws."""
    return [line for line in window.messages() if not any(note in line for note in NOTES)]


@in_browser
def test_pointing_at_a_facet_tells_its_parents(page_kept: framework.Browser, folder: Path) -> None:
    window = page_kept
    opened(window, made_once(folder, *CUBES)[0])
    told = window.run(
        """const plot = document.getElementById('plot-sum'), box = plot.getBoundingClientRect();
        const under = plot.querySelector('canvas'), tip = document.getElementById('tip');
        return new Promise((done) => {
          let steps = 0;
          const move = () => {
            const at = { clientX: box.left + box.width / 2 + (steps % 3), bubbles: true,
                         clientY: box.top + box.height / 2, view: window };
            under.dispatchEvent(new PointerEvent('pointermove', at));
            under.dispatchEvent(new MouseEvent('mousemove', at));
            if (tip.textContent || ++steps > 100) done(tip.textContent);
            else setTimeout(move, 100);
          };
          move();
        })"""
    )
    assert re.fullmatch(r"facet \d+: (fv|vf|ee), \d corners\n.* of P \+ .* of Q", told), told
    assert said(window) == []


@in_browser
def test_the_three_solids_are_drawn(page_kept: framework.Browser, folder: Path) -> None:
    window = page_kept
    opened(window, made_once(folder, *CUBES)[0])
    sum_, P, Q = (
        coloured(window, f"plot-{name}", SHOTS / "cube-octahedron.png")
        for name in ("sum", "P", "Q")
    )
    assert sum_["drawn"] > 0.15 and sum_["blue"] > 0.02 and sum_["orange"] > 0.02
    assert P["blue"] > 0.05 and P["orange"] < 0.01
    assert Q["orange"] > 0.05 and Q["blue"] < 0.01
    window.run("document.getElementById('show-fv').click()")
    window.run(SETTLED)
    assert coloured(window, "plot-sum", SHOTS / "without-fv.png")["blue"] < sum_["blue"] / 2
    window.run(  # typed, a facet is turned to the front
        "const field = document.getElementById('facet'); field.value = 0;"
        "field.dispatchEvent(new Event('change'))"
    )
    waited(window, lambda: coloured(window, "plot-sum", SHOTS / "chosen.png")["red"] > 0.001)
    assert said(window) == []


@in_browser
def test_the_slider_changes_caption_picture_and_facts(
    page_kept: framework.Browser, folder: Path
) -> None:
    window = page_kept
    page, value = made_once(folder, *WALK)
    opened(window, page)
    seen = set()
    slid = some(enumerate(value["frames"]), 3)
    for number, frame in slid:
        slide(window, number)
        caption = window.run(TEXT, "caption")
        assert f"{frame['vertices']:,} vertices" in caption
        assert f"{frame['kinds']['fv']} fv" in caption
        assert frame["digest"][:12] in caption
        assert frame["digest"] in window.run(TEXT, "facts")
        assert window.run(TEXT, "number") == f"frame {number + 1} of 5"
        step = window.run(TEXT, "step")
        assert (f"{frame['fv_errors']} fv-errors" if number else "from scratch") in step
        seen.add(caption)
        window.run(SETTLED)
        assert coloured(window, "plot-sum", SHOTS / "walk.png")["drawn"] > 0.02
    assert len(seen) == len(slid)
    window.prefer("dark")
    window.run(SETTLED)
    assert coloured(window, "plot-sum", SHOTS / "walk-dark.png")["drawn"] > 0.02
    assert said(window) == []


@in_browser
def test_exact_coordinates_and_parents_are_those_of_the_sum(
    page_kept: framework.Browser, folder: Path
) -> None:
    window = page_kept
    names = str(folder / "octahedron.off"), "rod"
    page, _ = made_once(folder, *WALK)
    opened(window, page)
    points = window.run(
        """const { frames, exactPoint } = window.minkref;
        const text = ([n, d]) => (d === 1n ? `${n}` : `${n}/${d}`);
        return frames.map((frame) =>
          [...Array(frame.vertices).keys()].map((v) => exactPoint(frame, v).map(text)))"""
    )
    for got, scale in zip(points, SCALES, strict=True):
        assert [tuple(point) for point in got] == true_sum(*names, scale).surface.written_points()
    slide(window, 2)
    true = true_sum(*names, SCALES[2])
    operands = data_of(page)[0]
    words = {1: "vertex", 2: "edge"}
    last = len(true.facet_parents) - 1
    for facet in (0, last // 2, last):
        window.run("return window.minkref.choose('facet', arguments[0]).then(() => true)", facet)
        told = window.run(TEXT, "chosen")
        for name, face in zip("PQ", true.facet_parents[facet], strict=True):
            ordered = [sorted(ring) for ring in operands[name]["faces"]]
            number = (
                "–".join(map(str, sorted(face))) if len(face) < 3 else ordered.index(sorted(face))
            )
            assert f"{words.get(len(face), 'facet')} {number} of {name}" in told
    window.run("return window.minkref.choose('vertex', 5).then(() => true)")
    p, q = true.vertex_parents[5]
    assert f"vertex 5 = vertex {p} of P + vertex {q} of Q" in window.run(TEXT, "chosen")
    assert said(window) == []


@in_browser
def test_the_page_is_not_wider_than_the_window(page_kept: framework.Browser, folder: Path) -> None:
    """Makes the window narrow and wide; a thorough run opens the page at each width."""
    window = page_kept
    opened(window, made_once(folder, *WALK)[0])
    for width in (400, 1280):
        window.viewport(width, 1000)
        if THOROUGH:
            window.get("about:blank")
            opened(window, made_once(folder, *WALK)[0])
        window.run(SETTLED)
        needed, there = window.run(
            "const { scrollWidth, clientWidth } = document.documentElement;"
            "return [scrollWidth, clientWidth]"
        )
        window.save_screenshot(SHOTS / f"walk-{width}.png")
        assert needed <= there == width
