"""What the generator calls: formulas become MathML, which needs no script and no font."""

from __future__ import annotations

import html
import re
from typing import Any

from latex2mathml.converter import convert

FORMULA = re.compile(
    r'<(span|div) class="arithmatex">(?:\\\((.*?)\\\)|\\\[(.*?)\\\])</\1>', re.DOTALL
)


def on_page_content(text: str, **_: Any) -> str:
    return FORMULA.sub(_mathml, text)


def _mathml(found: re.Match[str]) -> str:
    inline, block = found[2], found[3]
    return convert(html.unescape(inline or block), display="inline" if inline else "block")
