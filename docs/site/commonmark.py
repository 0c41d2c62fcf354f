"""Pages written for CommonMark, as a code host shows them, for Python-Markdown, which the site is
made with: that wants four columns where a list is nested and a blank line before it."""

from __future__ import annotations

from collections.abc import Iterator

from markdown_it import MarkdownIt

STEP = 4


def for_python_markdown(text: str) -> str:
    """The same blocks. Linear in the length but for the parser."""
    lines = text.split("\n")
    offsets: list[list[int]] = [[] for _ in lines]  # the columns of the items around each line
    first: dict[int, int] = {}  # lines on which an item begins, and how deep it is
    blank_before: set[int] = set()
    depth = 0
    for token in MarkdownIt("commonmark").enable("table").parse(text):
        if token.type in ("bullet_list_open", "ordered_list_open") and token.map:
            if depth == 0:
                blank_before.add(token.map[0])
        elif token.type == "list_item_open" and token.map:
            depth += 1
            begin, end = token.map
            column = _content_column(lines[begin], offsets[begin])
            for line in range(begin, end):
                offsets[line].append(column)
            first.setdefault(begin, depth)
        elif token.type == "list_item_close":
            depth -= 1
    return "\n".join(_indented(lines, offsets, first, blank_before))


def _content_column(line: str, around: list[int]) -> int:
    """Where the content of the item that begins on the line stands."""
    begin = around[-1] if around else 0
    marker = line[begin:].lstrip()
    word = marker.split(" ", 1)[0]
    spaces = len(marker[len(word) :]) - len(marker[len(word) :].lstrip())
    at = len(line) - len(marker) + len(word)
    return at + (spaces if 1 <= spaces <= 4 else 1)


def _indented(
    lines: list[str], offsets: list[list[int]], first: dict[int, int], blank_before: set[int]
) -> Iterator[str]:
    for number, line in enumerate(lines):
        around = offsets[number]
        if number in blank_before and number and lines[number - 1].strip():
            yield ""
        if not around or not line.strip():
            yield line
        elif number in first:
            outside = around[first[number] - 2] if first[number] > 1 else 0
            yield " " * STEP * (first[number] - 1) + line[outside:].lstrip()
        else:
            column = min(around[-1], len(line) - len(line.lstrip()))
            yield " " * STEP * len(around) + line[column:]
