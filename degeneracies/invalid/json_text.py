"""JSON texts with errors on demand: repeated members, invalid tokens, marks."""

from __future__ import annotations

import json
from collections.abc import Sequence

MARK = "\x01"  # precedes the damage; removed from the text


class Raw(str):
    """A token to write unchanged."""

    __slots__ = ()


class Object(list[tuple[str, object]]):
    """Members in their order. `mark`: the mark stands before its beginning."""

    mark = False

    def put(self, name: str, value: object) -> None:
        self[:] = [(known, value if known == name else old) for known, old in self]

    def drop(self, name: str) -> None:
        self[:] = [(known, old) for known, old in self if known != name]


class Marked:
    def __init__(self, value: object) -> None:
        self.value = value


def json_text(value: object, tall: bool, indent: str = "\n") -> str:
    """Writes one line, or starts a line for each value that holds others."""
    if isinstance(value, Marked):
        return MARK + json_text(value.value, tall, indent)
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, Object):
        inner = indent + " "
        parts = [f"{json.dumps(name)}: {json_text(part, tall, inner)}" for name, part in value]
        return (MARK if value.mark else "") + between("{}", parts, tall, indent)
    if isinstance(value, Sequence) and not isinstance(value, str):
        inner = indent + " "
        parts = [json_text(part, tall, inner) for part in value]
        return between("[]", parts, tall and not all(map(is_token, value)), indent)
    return json.dumps(value)


def is_token(value: object) -> bool:
    return not isinstance(value, Marked) and (
        isinstance(value, str) or not isinstance(value, Sequence)
    )


def between(ends: str, parts: list[str], tall: bool, indent: str) -> str:
    if not parts:
        return ends
    if tall:
        inner = indent + " "
        return ends[0] + inner + f",{inner}".join(parts) + indent + ends[1]
    return ends[0] + ", ".join(parts) + ends[1]
