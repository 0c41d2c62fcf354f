"""A reader for printed tables: rows by column names."""

from __future__ import annotations


def boxed(text: str) -> list[dict[str, str]]:
    """Rows of a boxed table; joins rows that span several lines."""
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
