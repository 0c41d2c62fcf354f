"""Finds links to missing files and missing headings of the repository."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path
from urllib.parse import unquote, urlsplit

from markdown_it.token import Token
from minkref.reports.documentation.blocks import parsed

IDENTIFIER = re.compile(r"""<a (?:id|name)=["']([^"']+)["']""")


def broken_links(root: Path, pages: list[Path]) -> list[str]:
    """Lines `page:line: what is wrong`."""
    return [line for page in pages for line in _broken_in(root, page)]


def _broken_in(root: Path, page: Path) -> Iterator[str]:
    for line, link in _links(parsed(root, page)):
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            continue
        path = page if not parts.path else Path(unquote(parts.path))
        full = root / page if not parts.path else (root / page).parent / path
        where = f"{page}:{line}"
        if not full.resolve().is_relative_to(root.resolve()):
            yield f"{where}: {link} leads out of the repository"
        elif not full.exists():
            yield f"{where}: {link} does not exist"
        elif parts.fragment and full.suffix == ".md":
            if unquote(parts.fragment) not in anchors(full.resolve()):
                yield f"{where}: {link} names no heading"


def _links(tokens: list[Token], line: int = 1) -> Iterator[tuple[int, str]]:
    for token in tokens:
        line = token.map[0] + 1 if token.map else line
        for name in ("href", "src"):
            value = token.attrGet(name)
            if isinstance(value, str):
                yield line, value
        if token.children:
            yield from _links(token.children, line)


@cache
def anchors(page: Path) -> set[str]:
    """Anchors of headings, made like a code host's, and anchors from `<a id="...">`."""
    text = page.read_text(encoding="utf-8")
    found = set(IDENTIFIER.findall(text))
    tokens = parsed(page.parent, Path(page.name))
    seen: dict[str, int] = {}
    for token, inline in pairwise(tokens):
        if token.type != "heading_open":
            continue
        words = "".join(
            child.content
            for child in inline.children or []
            if child.type in ("text", "code_inline")
        )
        slug = re.sub(r"[^\w\- ]", "", words.strip().lower()).replace(" ", "-")
        again = seen.get(slug, 0)
        seen[slug] = again + 1
        found.add(f"{slug}-{again}" if again else slug)
    return found
