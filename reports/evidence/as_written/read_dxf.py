"""A reader of DXF: closed polylines with their bulges, as texts."""

from __future__ import annotations

from collections.abc import Iterator

Corner = tuple[str, str, str]  # x, y and the bulge towards the next one


def pairs(text: str) -> Iterator[tuple[int, str]]:
    """Group codes and values, two lines each."""
    lines = text.splitlines()
    if len(lines) % 2:
        raise ValueError("a group has two lines")
    for k in range(0, len(lines), 2):
        yield int(lines[k]), lines[k + 1].strip()


def polylines(text: str) -> list[list[Corner]]:
    """The closed LWPOLYLINEs in the section ENTITIES; refuses other entities."""
    rings: list[list[Corner]] = []
    section, entity, closed = "", "", []
    for code, value in pairs(text):
        if code == 2 and section == "named":
            section = value
        elif code == 0:
            section = "named" if value == "SECTION" else "" if value == "ENDSEC" else section
            entity = value if section == "ENTITIES" else ""
            if entity == "LWPOLYLINE":
                rings.append([])
                closed.append(False)
            elif entity:
                raise ValueError(f"{entity} among the entities")
        elif entity == "LWPOLYLINE":
            if code == 70:
                closed[-1] = bool(int(value) & 1)
            elif code == 10:
                rings[-1].append((value, "", "0"))
            elif code == 20:
                x, _, bulge = rings[-1][-1]
                rings[-1][-1] = (x, value, bulge)
            elif code == 42:
                x, y, _ = rings[-1][-1]
                rings[-1][-1] = (x, y, value)
    if not all(closed):
        raise ValueError("an open polyline")
    return rings
