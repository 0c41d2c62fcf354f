"""JSON texts whose numbers stay texts and never pass through a double."""

from __future__ import annotations

import json

from .exact import InputError

DEEPEST = 128
MOST_WORDS = 100_000  # values of a JSON text; words, numbers and marks of another


class JsonNumber(str):
    """A JSON number's text, unlike a JSON string."""

    __slots__ = ()


def json_value(text: str) -> object:
    """Parse a JSON text. Refuses NaN and infinity, repeated members, deep nesting, too many
    values."""
    try:
        value: object = json.loads(
            text,
            parse_float=JsonNumber,
            parse_int=JsonNumber,
            parse_constant=no_number,
            object_pairs_hook=once,
        )
    except (json.JSONDecodeError, RecursionError) as error:
        raise InputError(f"no JSON text: {error}") from error
    level, depth, count = [value], 0, 0
    while level:
        depth, count = depth + 1, count + len(level)
        if depth > DEEPEST + 1:
            raise InputError(f"values are nested deeper than {DEEPEST}")
        if count > MOST_WORDS:
            raise InputError(f"there are more than {MOST_WORDS} values")
        level = [part for one in level for part in parts(one)]
    return value


def parts(value: object) -> list[object]:
    if isinstance(value, str) and not value.isascii():
        try:
            value.encode()
        except UnicodeEncodeError as error:
            raise InputError("a string holds half of a surrogate pair") from error
    if isinstance(value, dict):
        return [*value, *value.values()]
    return value if isinstance(value, list) else []


def once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    members: dict[str, object] = {}
    for name, value in pairs:
        if name in members:
            raise InputError(f"the member {name!r} is given twice")
        members[name] = value
    return members


def no_number(text: str) -> object:
    raise InputError(f"{text} is not a number")
