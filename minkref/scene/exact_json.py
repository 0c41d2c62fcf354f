"""JSON that people write, read exactly: numbers keep their text, no member counts twice."""

from __future__ import annotations

import json
from typing import Any

from minkref.errors import Refusal, nearest


class Numeral(str):
    """A JSON number as written."""


def exact_json(text: str, source: str) -> Any:
    """Read a JSON text; a number is a Numeral. Refuses a member that an object has twice, naming
    `source`. Linear."""

    def members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) < len(pairs):
            names = [name for name, _ in pairs]
            twice = next(name for name in names if names.count(name) > 1)
            what = f"an object has the member {shown(twice)} twice"
            raise Refusal(what, source, "give each member another name", "duplicate-member")
        return found

    try:
        return json.loads(
            text.removeprefix("\ufeff"),
            parse_float=Numeral,
            parse_int=Numeral,
            parse_constant=Numeral,
            object_pairs_hook=members,
        )
    except Refusal:
        raise
    except (ValueError, RecursionError) as error:
        what = f"this is not JSON: {error}"
        raise Refusal(what, source, "correct it", "syntax") from error


def shown(value: Any) -> str:
    """A value as JSON, cut short for messages."""
    text = value if isinstance(value, Numeral) else json.dumps(value)
    return text if len(text) <= 40 else f"{text[:37]}..."


def check_members(
    value: Any, where: str, needed: tuple[str, ...], others: tuple[str, ...] = ()
) -> dict[str, Any]:
    """Return the object; refuses anything else, missing members and unknown members."""
    known = (*needed, *others)
    if not isinstance(value, dict):
        what = f"this is not an object: {shown(value)}"
        raise Refusal(what, where, f"give an object with {', '.join(needed)}", "wrong-type")
    for name in value:
        if name not in known:
            mend = f"{nearest(name, known)}choose from {', '.join(known)}"
            raise Refusal(f"there is no member {shown(name)}", where, mend, "unknown-member")
    for name in needed:
        if name not in value:
            what = f"the member {name} is missing"
            raise Refusal(what, where, f"give {', '.join(needed)}", "missing-member")
    return value
