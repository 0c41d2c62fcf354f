"""Polyhedra as OFF files, and commands about their sums."""

from __future__ import annotations

import random
from pathlib import Path

Order = tuple[str, str, list[str], str]
Points = list[tuple[int, int, int]]

TETRA = ([(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 1)], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
OCTA = (
    [(2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)],
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
)


def prism(ring: list[tuple[int, int]], height: int) -> tuple[Points, list[list[int]]]:
    """The ring, counter-clockwise, from z = 0 up."""
    n = len(ring)
    points = [(x, y, 0) for x, y in ring] + [(x, y, height) for x, y in ring]
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return points, [list(range(n))[::-1], list(range(n, 2 * n)), *sides]


SHAPES = {
    "tetra": TETRA,
    "octa": OCTA,
    "cube": prism([(0, 0), (1, 0), (1, 1), (0, 1)], 1),
    "ell": prism([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)], 1),
    "whole": prism([(0, 0), (3, 0), (3, 1), (1, 2), (0, 2)], 1),
    "foot": prism([(0, 0), (3, 0), (3, 1), (0, 1)], 1),
    "bay": prism([(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (1, 1), (1, 3), (0, 3)], 2),
}


def write(folder: Path) -> None:
    for name, (points, faces) in SHAPES.items():
        lines = ["OFF", f"{len(points)} {len(faces)} 0"]
        lines += [" ".join(map(str, point)) for point in points]
        lines += [" ".join(map(str, [len(face), *face])) for face in faces]
        file = folder / f"{name}.off"
        if not file.exists():
            file.write_text("\n".join([*lines, ""]), encoding="utf-8")


def orders(dice: random.Random) -> list[Order]:
    """Sums of convex solids and others, and points."""
    scale = dice.choice(["1", "2", "1/2", "2,1/3,1"])
    made = [
        ("convex", "convex", ["cube", "tetra", "--scale", scale]),
        ("smooth", "convex", ["octa", dice.choice(["tetra", "cube"]), "--scale", scale]),
        ("solid", "solid", ["ell", "cube", "--scale", scale]),
        ("wide", "solid", ["bay", dice.choice(["cube", "tetra"]), "--scale", "1"]),
        ("whole", "solid-part", ["whole", "ell", "--scale", scale]),
        ("within", "solid-point", ["bay", "cube", "--scale", "1", "--point", "1/2,1/2,1/2"]),
        ("beside", "solid-outside", ["bay", "cube", "--scale", "1/8", "--point", "5/2,3/2,1/2"]),
        ("distant", "solid-outside", ["ell", "cube", "--scale", scale, "--point", "40,3,-20"]),
    ]
    return [
        (name, kind, ["certify", *(_file(word) for word in words), "--no-check"], "-o")
        for name, kind, words in made
    ]


def _file(word: str) -> str:
    return f"FOLDER/{word}.off" if word in SHAPES else word
