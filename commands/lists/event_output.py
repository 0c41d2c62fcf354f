"""Where lists of millions of events go: a JSON document, JSON lines or Parquet."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from typing import Any

from minkref.commands.lists.event_lists import EventList, PairEventList, json_pieces
from minkref.commands.lists.event_table import write_parquet
from minkref.documents import as_text
from minkref.output_target import Target

FORMATS = ("json", "jsonl", "parquet")
_EMPTY = "[]\n}\n"


def write_events(target: Target, head: dict[str, Any], found: EventList, count: int) -> None:
    """The first `count` events: `json`, a document with the fields of `head` and the list `events`,
    an event a line; `jsonl`, an event a line and nothing else; `parquet`, a table. A file is
    written whole or not at all. One pass, in bounded memory."""
    if target.form == "parquet":
        assert isinstance(found, PairEventList)  # others are refused before they are found
        write_parquet(found.found, target.path, count)
        return
    lines = target.form == "jsonl"
    pieces = json_pieces(found, count, "\n") if lines else document_pieces(head, found, count)
    with target.stream() as stream:
        stream.writelines(pieces)


def document_pieces(head: dict[str, Any], found: EventList, count: int) -> Iterator[bytes]:
    """The JSON text of a document whose last field, `events`, is too long to be held in memory."""
    yield as_text({**head, "events": []}).removesuffix(_EMPTY).encode(errors="backslashreplace")
    last = b""
    for piece in json_pieces(found, count, ",\n"):
        yield last or b"[\n"
        last = piece
    yield last.removesuffix(b",\n") + b"\n]\n}\n" if last else _EMPTY.encode()


def print_pieces(pieces: Iterable[bytes]) -> None:
    """To standard output."""
    sys.stdout.flush()
    sys.stdout.buffer.writelines(pieces)
    sys.stdout.buffer.flush()
