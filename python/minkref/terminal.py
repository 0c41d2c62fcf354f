"""Standard output for people: tables as wide as the terminal, or as they need to be in a pipe."""

from __future__ import annotations

from rich.console import Console

PIPE_WIDTH = 200


def console() -> Console:
    plain = Console(highlight=False)
    return plain if plain.is_terminal else Console(highlight=False, width=PIPE_WIDTH)


def lines(rows: list[tuple[str, str]]) -> str:
    """Names and values in two columns, never cut off."""
    width = max(len(name) for name, _ in rows)
    return "".join(f"{name:<{width}}  {value}".rstrip() + "\n" for name, value in rows)
