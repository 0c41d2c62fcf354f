"""Standard output for people: tables as wide as the terminal, or as wide as needed for a pipe."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

PIPE_WIDTH = 200


def console() -> Console:
    """Make a console that shows texts unchanged: brackets are no markup."""
    from rich.console import Console

    plain = Console(highlight=False, markup=False, emoji=False)
    if plain.is_terminal:
        return plain
    return Console(highlight=False, markup=False, emoji=False, width=PIPE_WIDTH)


def lines(rows: list[tuple[str, str]]) -> str:
    """Write names and values as two columns, never cut off."""
    width = max(len(name) for name, _ in rows)
    return "".join(f"{name:<{width}}  {escaped(value)}".rstrip() + "\n" for name, value in rows)


def escaped(text: str) -> str:
    """Write a text on one line: escapes terminal controls, and bytes that are no text."""
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii")
        for letter in text
    )


def counted(number: int, noun: str) -> str:
    """Write `1 scale`, `1,200 scales`."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"
