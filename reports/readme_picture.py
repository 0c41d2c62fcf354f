"""Draws the README's picture: `.venv/bin/python -m minkref.reports.readme_picture`."""

from __future__ import annotations

import sys
from pathlib import Path

from minkref.reports.conformance.showcase import show
from minkref.reports.side_by_side import side_by_side

STYLE = (
    ".first{fill:#d9a441;stroke:#7a5a17;stroke-width:.4}"
    ".second{fill:#7aa6c2;stroke:#2f5d7c;stroke-width:.4}"
    ".convolution{fill:none;stroke:#b03a2e;stroke-width:.35}"
    ".sum{fill:#cfe3d4;stroke:#1e6b3a;stroke-width:.6}"
    "text{font:13px sans-serif;fill:#333}"
)
PANE, HEIGHT = 340, 484
#: cells, convolution and sum; the disc is left out, a speck beside the rest
PANES = (1, 2, 3)


def main() -> None:
    """Writes the picture to the path given, docs/picture.svg by default."""
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else Path("docs/picture.svg")
    pictures = show("disc5", "cells1815").pictures
    panes = [([pictures[i][0]], pictures[i][1]) for i in PANES]
    target.write_text(side_by_side(panes, STYLE, PANE, HEIGHT))


if __name__ == "__main__":
    main()
