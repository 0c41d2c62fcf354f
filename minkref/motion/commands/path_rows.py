"""Ranges of scales and their bounds, as `path`, `fit` and `trap` give them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from minkref.exact import rounded

MOST_ROWS = 20  # that people see
BY_TRANSLATION = "translations only: a rotation may do what they cannot"


def range_documents(rows: Sequence[Any]) -> list[dict[str, Any]]:
    return [
        {"from": low, "to": high, "from_in": low_in, "to_in": high_in}
        for low, low_in, high, high_in in rows
    ]


def extreme_scales(rows: Sequence[Any]) -> dict[str, Any]:
    """The fields `largest` and `smallest`: null where no scale is valid; a scale of null is no
    end; `is_valid`: whether the scale itself is."""
    if not rows:
        return {"largest": None, "smallest": None}
    low, low_in, _, _ = rows[0]
    _, _, high, high_in = rows[-1]
    return {
        "largest": {"scale": high, "is_valid": high_in},
        "smallest": {"scale": low, "is_valid": low_in},
    }


def contact_document(row: Any) -> dict[str, Any]:
    return _contact(row, _feature)


def space_contact_document(row: Any) -> dict[str, Any]:
    return _contact(row, lambda feature: {feature[0]: list(feature[1])})


def _contact(row: Any, told: Callable[[Any], dict[str, list[int]]]) -> dict[str, Any]:
    scale, blocks, segment, t, point, part, obstacle, touching = row
    return {
        "scale": scale,
        "event": "blocks" if blocks else "frees",
        "at": {"segment": segment, "t": t, "point": list(point)},
        "part": told(part),
        "obstacle": told(obstacle),
        "touching": list(touching),
    }


def _feature(row: tuple[bool, int, int]) -> dict[str, list[int]]:
    is_edge, ring, index = row
    return {"edge" if is_edge else "vertex": [ring, index]}


def free_bound_document(row: Any) -> dict[str, Any]:
    scale, ends, event, at, contact = row
    told = None if contact is None else contact_document(contact)
    return {
        "scale": scale,
        "ends": ends,
        "event": event,
        "at": list(at),
        "contact": None if told is None else {key: told[key] for key in ("part", "obstacle")},
    }


def proof_documents(rows: Sequence[tuple[str, bool]]) -> list[dict[str, Any]]:
    return [{"scale": scale, "holds": holds} for scale, holds in rows]


def range_text(one: dict[str, Any]) -> str:
    if one["from"] == one["to"]:
        return f"{one['from']} alone"
    high = "infinity" if one["to"] is None else one["to"]
    return f"{'[' if one['from_in'] else '('}{one['from']}, {high}{']' if one['to_in'] else ')'}"


def ranges_text(ranges: Sequence[dict[str, Any]]) -> str:
    return ", ".join(range_text(one) for one in ranges) or "none"


def feature_text(feature: dict[str, list[int]], in_space: bool = False) -> str:
    """In the plane ring and index; in space the number of a vertex or face, the ends of an edge."""
    [(kind, numbers)] = feature.items()
    if in_space:
        return f"{kind} {'-'.join(map(str, numbers))}"
    ring, index = numbers
    return f"{kind} {index}" if ring == 0 else f"{kind} {index} in ring {ring}"


def number_text(text: str) -> str:
    """Short numbers exactly, long ones rounded."""
    return text if len(text) <= 12 else rounded(text)


def point_text(point: Sequence[str]) -> str:
    return f"({', '.join(number_text(word) for word in point)})"
