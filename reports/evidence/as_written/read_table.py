"""A reader of printed tables: rows by the names of their columns."""

from __future__ import annotations


def boxed(text: str) -> list[dict[str, str]]:
    """The rows of a table in a box of lines; a row over several lines is put together again."""
    names: list[str] = []
    rows: list[dict[str, str]] = []
    for line in text.splitlines():
        if line.startswith("┃"):
            names = [cell.strip() for cell in line.strip("┃").split("┃")]
        elif line.startswith("│"):
            cells = [cell.strip() for cell in line.strip("│").split("│")]
            if len(cells) != len(names):
                raise ValueError(f"{len(cells)} cells below {len(names)} names")
            row = dict(zip(names, cells, strict=True))
            if cells[0] or not rows:
                rows.append(row)
            else:
                for name, cell in row.items():
                    rows[-1][name] = f"{rows[-1][name]} {cell}".strip()
    return rows
