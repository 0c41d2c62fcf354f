"""Where lists of millions of events go: a JSON document, JSON lines or Parquet."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

from minkref.cli.progress import progress
from minkref.output.documents import as_text, lasting
from minkref.output.output_target import Target
from minkref.plane.commands.event_table import write_parquet
from minkref.plane.commands.scale_index import cores
from minkref.plane.event_lists import EventList, PairEventList

CHUNK = 32768  # events at a time
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
    head = lasting(head)
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


def json_pieces(found: EventList, count: int, end: str) -> Iterator[bytes]:
    """The first `count` events as JSON texts, each followed by `end`, some thousand at a time and
    by all cores; progress on a terminal."""
    firsts = iter(range(0, min(count, len(found)), CHUNK))
    workers = cores()
    with progress(count) as line, ThreadPoolExecutor(workers) as pool:
        line.now("writing events")
        waiting: deque[Future[bytes]] = deque()

        def begin() -> None:
            first = next(firsts, None)
            if first is not None:
                last = min(first + CHUNK, count)
                waiting.append(pool.submit(found.json, first, last, end))

        for _ in range(2 * workers):
            begin()
        while waiting:
            yield waiting.popleft().result()
            begin()
            line.done(CHUNK)


def print_pieces(pieces: Iterable[bytes]) -> None:
    """To standard output."""
    sys.stdout.flush()
    sys.stdout.buffer.writelines(pieces)
    sys.stdout.buffer.flush()
