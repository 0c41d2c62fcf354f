"""Pictures beside each other as one stand-alone SVG document."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from minkref.output.terminal import escaped

LINE = 16  # of a caption


def side_by_side(
    panes: Sequence[tuple[Sequence[str], str]], style: str, width: int, height: int
) -> str:
    """`panes`: caption lines, placed above, and SVG elements, each at most `width` wide and
    `height` high. `style`: CSS for the elements' classes."""
    head = LINE // 2 + LINE * max(len(caption) for caption, _ in panes)
    parts = []
    for pane, (caption, svg) in enumerate(panes):
        parts.append(f'<g transform="translate({pane * width} {head})">{svg}</g>')
        parts += [
            f'<text x="{pane * width + LINE // 2}" y="{LINE * (line + 1)}">'
            f"{escape(escaped(text))}</text>"
            for line, text in enumerate(caption)
        ]
    box = f"0 0 {width * len(panes)} {head + height}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}"><style>{style}</style>'
        f'<rect width="100%" height="100%" fill="white"/>{"".join(parts)}</svg>\n'
    )
