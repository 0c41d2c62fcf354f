"""The gallery: for some pairs of the shipped models the page of `minkref view` and a picture, made
by the commands that are shown."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path

PLACE = Path("gallery")
Vector = tuple[float, ...]


@dataclass(frozen=True)
class Exhibit:
    name: str
    operands: str
    view: str  # what `minkref view` is told beside the operands
    scale: str  # of the picture
    text: str

    @property
    def in_space(self) -> bool:
        return "," in self.scale


EXHIBITS = (
    Exhibit(
        "letters",
        "g1 g2",
        "--from 1/4 --to 4",
        "1/2",
        "Two letters. Holes split off from the outside, one of them splits again, and all die.",
    ),
    Exhibit(
        "figure",
        "disc1 g4",
        "--from 1/4 --to 16",
        "6",
        "A walking figure, offset by a disc that grows.",
    ),
    Exhibit(
        "right-angles",
        "g3 g1",
        "--from 1/4 --to 4",
        "1",
        "A post and bars with right angles only, and the letter S.",
    ),
    Exhibit(
        "bird",
        "disc1 glyph275",
        "--from 1/2 --to 8",
        "2",
        "A bird on two feet. Two holes split off from the outside and die.",
    ),
    Exhibit(
        "dog",
        "dog145 disc5",
        "--from 1/4 --to 2",
        "1",
        "Here the dog is scaled, and the disc stays.",
    ),
    Exhibit(
        "cells",
        "disc1 cells1815",
        "--from 1/2 --to 8",
        "7/5",
        "A net of nerve cells with eighteen holes, each with its life.",
    ),
    Exhibit(
        "sphere-and-rod",
        "gs3 rod",
        "--scale 2,1/3,5",
        "2,1/3,5",
        "In space: a geodesic sphere, scaled by a factor for each axis, and a slender prism.",
    ),
)


def make(root: Path, pages: Path) -> str:
    """Writes pictures and pages below `pages`; the text of the gallery."""
    folder = pages / PLACE
    folder.mkdir(parents=True)
    text = (
        "# Gallery\n\nEach picture opens the page that `minkref view` writes: one HTML file with a "
        "slider over the scale, which needs nothing else. All of it is made, from models that come "
        "with minkref, when this site is built.\n\n"
        '<div class="gallery" markdown="1">\n\n'
    )
    for exhibit in EXHIBITS:
        command = f"minkref view {exhibit.operands} {exhibit.view} -o {exhibit.name}.html"
        _run(root, folder, command)
        picture = folder / f"{exhibit.name}.svg"
        shape = f"minkref sum {exhibit.operands} --scale {exhibit.scale}"
        if exhibit.in_space:
            solid = json.loads(_run(root, folder, f"{shape} --json"))["result"]
            picture.write_text(_drawn(solid["vertices"], solid["faces"]), encoding="utf-8")
        else:
            _run(root, folder, f"{shape} --only-sum -o {picture.name}")
        alternative = (
            f"The sum of {' and '.join(exhibit.operands.split())} at the scale {exhibit.scale}"
        )
        text += (
            f'<figure markdown="span">\n'
            f"[![{alternative}]({picture.name})]({exhibit.name}.html)\n"
            f'<figcaption markdown="span">{exhibit.text} `{command}`</figcaption>\n</figure>\n\n'
        )
    return text + "</div>\n"


def _run(root: Path, folder: Path, command: str) -> str:
    words = command.split()
    words[0] = str(root / ".venv/bin/minkref")
    done = subprocess.run(words, cwd=folder, check=True, stdout=subprocess.PIPE, text=True)
    return done.stdout


def _drawn(vertices: list[list[str]], faces: list[list[int]]) -> str:
    """A convex solid in parallel projection: the facets that face the eye, lit by their normals."""
    points = [tuple(_number(one) for one in vertex) for vertex in vertices]
    right, up, eye = (0.8, -0.6, 0.0), (-0.3, -0.4, 0.866), (0.52, 0.693, 0.5)
    seen = [(_dot(p, right), -_dot(p, up)) for p in points]
    shapes, drawn = [], []
    for face in faces:
        light = _dot(_normal([points[k] for k in face]), eye)
        if light > 0:
            corners = [seen[k] for k in face]
            drawn += corners
            shade = f"hsl(145 30% {35 + 50 * light:.0f}%)"
            shapes.append((shade, corners))
    left, top = (min(p[axis] for p in drawn) for axis in (0, 1))
    unit = 1000 / max(max(p[axis] for p in drawn) - low for axis, low in ((0, left), (1, top)))
    width, height = (
        (max(p[axis] for p in drawn) - low) * unit for axis, low in ((0, left), (1, top))
    )
    polygons = "".join(
        f'<polygon fill="{shade}" points="'
        + " ".join(f"{(x - left) * unit:.1f},{(y - top) * unit:.1f}" for x, y in corners)
        + '"/>'
        for shade, corners in shapes
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" '
        f'viewBox="-10 -10 {width + 20:.0f} {height + 20:.0f}">'
        f'<g stroke="#1e6b3a" stroke-width="1" stroke-linejoin="round">{polygons}</g></svg>\n'
    )


def _number(text: str) -> float:
    top, _, bottom = text.partition("/")
    return int(top) / int(bottom or 1)


def _dot(a: Vector, b: Vector) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _normal(corners: list[Vector]) -> Vector:
    """The normal, of length one, by the area vector."""
    total = [0.0, 0.0, 0.0]
    for (a, b, c), (d, e, f) in zip(corners, [*corners[1:], corners[0]], strict=True):
        total = [total[0] + b * f - c * e, total[1] + c * d - a * f, total[2] + a * e - b * d]
    length = _dot(tuple(total), tuple(total)) ** 0.5
    return tuple(one / length for one in total)
