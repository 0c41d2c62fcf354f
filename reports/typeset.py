"""Markdown with formulas between dollars, as HTML with MathML: it needs no script and no font of
another machine."""

from __future__ import annotations

from functools import cache
from typing import Any

from latex2mathml.converter import convert
from markdown_it import MarkdownIt
from markupsafe import Markup
from mdit_py_plugins.dollarmath import dollarmath_plugin


@cache
def _markdown() -> MarkdownIt:
    def formula(content: str, options: dict[str, Any]) -> str:
        display = "block" if options.get("display_mode") else "inline"
        return convert(content, display=display)

    return MarkdownIt("commonmark").use(dollarmath_plugin, renderer=formula)


def typeset_line(text: str) -> Markup:
    """The text typeset without a paragraph around it."""
    return Markup(_markdown().renderInline(text))
