"""A page's code blocks, each with the remarks from comments before the block.

A comment `<!-- KEY: VALUE -->` right before a block:

- `not run: why` keeps the block from running, and says why;
- `first: command` runs a command first, which prepares the block's input;
- `file: NAME` writes the block to a file;
- `replaces: FUNCTION in FILE` replaces a function of an earlier file by the block;
- `finds: why` lets the commands end with 1, which reports something wrong;
- `prints: ` makes the block the expected output of the block before.

Several comments may precede a block.
"""

from __future__ import annotations

import json
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

KEYS = ("not run", "first", "file", "replaces", "finds", "prints")
COMMENT = re.compile(rf"<!-- ({'|'.join(KEYS)}):(.*?)-->", re.DOTALL)
SHELL = re.compile(r"^(minkref|\.venv/bin/\S+|make|cmake|python3?|pip) ", re.MULTILINE)


@dataclass(frozen=True)
class Block:
    page: Path  # of the repository
    line: int
    kind: str  # console, shell, text, or the language that the page names
    text: str
    said: tuple[tuple[str, str], ...]

    @property
    def place(self) -> str:
        return f"{self.page}:{self.line}"

    def all_of(self, key: str) -> list[str]:
        return [value for one, value in self.said if one == key]

    def told(self, key: str) -> str | None:
        values = self.all_of(key)
        return values[0] if values else None


def pages(root: Path) -> list[Path]:
    """Pages for people: README.md, and the pages of docs/ and of the rooms."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
        cwd=root,
        check=True,
        capture_output=True,
        text=True,
    )
    found = {Path(line) for line in listed.stdout.splitlines()}
    return sorted(page for page in found if (root / page).is_file())


def parsed(root: Path, page: Path) -> list[Token]:
    text = (root / page).read_text(encoding="utf-8")
    return MarkdownIt("commonmark").enable("table").parse(text)


def blocks(root: Path, page: Path) -> list[Block]:
    """In their order."""
    found: list[Block] = []
    said: list[tuple[str, str]] = []
    for token in parsed(root, page):
        if token.type == "html_block":
            said += [
                (key, " ".join(value.split())) for key, value in COMMENT.findall(token.content)
            ]
        elif token.type in ("fence", "code_block"):
            assert token.map is not None
            kind = _kind(token.info.strip(), token.content)
            found.append(Block(page, token.map[0] + 1, kind, token.content, tuple(said)))
            said = []
        elif token.content or token.type.startswith("heading"):
            said = []
    return found


def _kind(info: str, text: str) -> str:
    if info:
        return "cpp" if info == "c++" else info
    if text.startswith("$ "):
        return "console"
    if SHELL.search(text):
        return "shell"
    return "json" if text.lstrip().startswith("{") else "text"


def json_values(text: str) -> list[object]:
    """The values of a JSON document, or of several in a row. Raises ValueError."""
    decoder, values = json.JSONDecoder(), []
    text = text.strip()
    while text:
        value, end = decoder.raw_decode(text)
        values.append(value)
        text = text[end:].lstrip()
    return values
