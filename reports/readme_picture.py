"""Draws the picture of the README: `.venv/bin/python -m minkref.reports.readme_picture`."""

from __future__ import annotations

import sys
from pathlib import Path

from minkref.reports.conformance.showcase import show

STYLE = (
    "<style>.first{fill:#d9a441;stroke:#7a5a17;stroke-width:.4}"
    ".second{fill:#7aa6c2;stroke:#2f5d7c;stroke-width:.4}"
    ".convolution{fill:none;stroke:#b03a2e;stroke-width:.35}"
    ".sum{fill:#cfe3d4;stroke:#1e6b3a;stroke-width:.6}"
    "text{font:13px sans-serif;fill:#333}</style>"
)
PANE, HEIGHT = 340, 508
#: of disc, cells, convolution and sum the disc is left out: it is a speck beside the rest
PANES = (1, 2, 3)


def main() -> None:
    """Writes the picture to the path given, docs/picture.svg by default."""
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else Path("docs/picture.svg")
    pictures = [show("disc5", "cells1815").pictures[i] for i in PANES]
    parts = [
        f'<g transform="translate({i * PANE} 24)">{svg}</g>'
        f'<text x="{i * PANE + 8}" y="16">{caption}</text>'
        for i, (caption, svg) in enumerate(pictures)
    ]
    box = f"0 0 {PANE * len(parts)} {HEIGHT}"
    target.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{STYLE}'
        f'<rect width="100%" height="100%" fill="white"/>{"".join(parts)}</svg>\n'
    )


if __name__ == "__main__":
    main()
