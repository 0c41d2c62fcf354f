"""Draws the pictures of docs/paths.md: `.venv/bin/python -m minkref.reports.path_pictures`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

Place = tuple[float, float]

BOLT = [(-4, -30), (4, -30), (4, 0), (9, 0), (9, 6), (-9, 6), (-9, 0), (-4, 0)]
BRACKET = [
    [(-24, -8), (-4.2, -8), (-4.2, 0), (-24, 0)],
    [(4.3, -8), (24, -8), (24, 10), (9.6, 10), (9.6, 0), (4.3, 0)],
]
BOLT_WAY = [(-3, 45), (-3, 34), (0, 31.6), (0, 0)]
CUTTER = [(5, 2), (2, 5), (-2, 5), (-5, 2), (-5, -2), (-2, -5), (2, -5), (5, -2)]
POCKET = [
    (0, 0), (30, 0), (30, 9), (36, 12), (36, 0), (70, 0), (70, 30), (36, 30), (36, 22), (30, 19),
    (30, 30), (0, 30),
]  # fmt: skip
STYLE = (
    ".solid{fill:#7aa6c2;stroke:#2f5d7c;stroke-width:.3}"
    ".free{fill:#f4efe4;stroke:#2f5d7c;stroke-width:.3}"
    ".part{fill:#d9a441;fill-opacity:.8;stroke:#7a5a17;stroke-width:.3}"
    ".ghost{fill:none;stroke:#7a5a17;stroke-width:.3;stroke-dasharray:1 .6}"
    ".way{fill:none;stroke:#b03a2e;stroke-width:.4}"
    ".contact{fill:#b03a2e}"
)


def main() -> None:
    """Writes both pictures into the folder given, docs by default."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path("docs")
    bolt = "".join(
        [
            *(_polygon("solid", ring) for ring in BRACKET),
            _polygon("ghost", _placed(BOLT, 1.05, (-3, 34))),
            _polygon("part", _placed(BOLT, 1.05, (0, 31.5))),
            _line(BOLT_WAY),
            _dot((-4.2, 0)),
        ]
    )
    cutter = "".join(
        [
            _polygon("free", POCKET),
            _polygon("ghost", _placed(CUTTER, 3, (51, 15))),
            *(_polygon("part", _placed(CUTTER, 5 / 6, at)) for at in ((15, 15), (33, 15.5))),
            _line([(15, 15), (33, 15.5), (53, 15)]),
        ]
    )
    pictures = {
        "paths-bolt.svg": (bolt, (-26, -10, 52, 60), "A bolt above a slot between two brackets"),
        "paths-cutter.svg": (cutter, (-2, -2, 74, 34), "A cutter in a pocket with a narrow neck"),
    }
    for name, (drawn, box, label) in pictures.items():
        (folder / name).write_text(_picture(drawn, box, label), encoding="utf-8")


def _picture(drawn: str, box: tuple[int, int, int, int], label: str) -> str:
    """`box`: left, bottom, width, height; y points upwards."""
    left, bottom, width, height = box
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left} {-bottom - height} {width} '
        f'{height}" width="{6 * width}" height="{6 * height}" role="img" aria-label="{label}">'
        f'<style>{STYLE}</style><rect x="{left}" y="{-bottom - height}" width="{width}" '
        f'height="{height}" fill="white"/><g transform="scale(1 -1)">{drawn}</g></svg>\n'
    )


def _placed(ring: Sequence[Place], scale: float, at: Place) -> list[Place]:
    return [(scale * x + at[0], scale * y + at[1]) for x, y in ring]


def _points(ring: Sequence[Place]) -> str:
    return " ".join(f"{x:.4g},{y:.4g}" for x, y in ring)


def _polygon(kind: str, ring: Sequence[Place]) -> str:
    return f'<polygon class="{kind}" points="{_points(ring)}"/>'


def _line(way: Sequence[Place]) -> str:
    return f'<polyline class="way" points="{_points(way)}"/>'


def _dot(at: Place) -> str:
    return f'<circle class="contact" cx="{at[0]:.4g}" cy="{at[1]:.4g}" r=".7"/>'


if __name__ == "__main__":
    main()
