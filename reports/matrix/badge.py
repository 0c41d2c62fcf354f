"""A badge: a title, and how many of the judged answers are right, as a small SVG."""

from __future__ import annotations

from html import escape

GREEN, AMBER, RED = "#2a6e30", "#9c6412", "#c9362b"
LETTER, SPACE = 6.6, 12  # widths
AMBER_FROM = 0.9


def badge(title: str, right: int, judged: int) -> str:
    """Green if all are right, amber if nine of ten are."""
    told = f"{right:,} of {judged:,} right"
    colour = GREEN if right == judged else AMBER if right >= AMBER_FROM * judged else RED
    first, second = (round(LETTER * len(text)) + SPACE for text in (title, told))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{first + second}" height="20" role="img" '
        f'aria-label="{escape(title)}: {told}" font-family="monospace" font-size="11" fill="#fff">'
        f'<rect width="{first}" height="20" fill="#444"/>'
        f'<rect x="{first}" width="{second}" height="20" fill="{colour}"/>'
        f'<text x="6" y="14">{escape(title)}</text>'
        f'<text x="{first + 6}" y="14">{told}</text></svg>\n'
    )
