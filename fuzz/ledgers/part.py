"""A part: the results of one chunk of cases, a row for each case and target.

A part is written once, under the name of its chunk, and never changed.
"""

from __future__ import annotations

import os
import re
import secrets
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.fuzz.ledgers.file import (
    ENDING,
    Chunk,
    columns,
    file_of,
    keep_names,
    parts_folder,
    pyarrow,
)
from minkref.fuzz.ledgers.row import rows_of
from minkref.fuzz.run.worker import CaseResult

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,119}")


def checked_name(chunk: str) -> str:
    """Refuses a name that is no name of a file, as every system has them."""
    if not NAME.fullmatch(chunk):
        mend = "write 1 to 120 letters, digits, dots, dashes and underscores"
        raise Refusal("this is no name of a chunk", repr(cut(chunk)), mend)
    return chunk


def campaign_of(chunk: str) -> str:
    """The name of the campaign, which a chunk's name begins with."""
    return chunk.partition("-")[0]


def part_of(
    chunk: str, results: Sequence[CaseResult], head: Mapping[str, Any], at: float | None = None
) -> bytes:
    """The part of a chunk, as the bytes of a file. `head`: of the campaign, with `versions` by
    target; `at`: seconds since 1970, now if None. The same results, in any order, give the same
    rows but for TIMES."""
    pa = pyarrow()
    checked_name(chunk)
    now = int(1000 * (time.time() if at is None else at))
    campaign, versions = campaign_of(chunk), head.get("versions", {})
    rows = [
        {"chunk": chunk, "campaign": campaign, "judged_at": now, **row}
        for result in sorted(results, key=lambda each: each.number)
        for row in rows_of(result, versions)
    ]
    known = Chunk(
        len(rows),
        sum(result.is_run for result in results),
        sum(result.absent is not None for result in results),
        sum(result.untaken is not None for result in results),
    )
    return file_of(pa.Table.from_pylist(rows, schema=columns()), {chunk: known})


def store_part(folder: Path, chunk: str, part: bytes) -> Path:
    """Writes a part below the campaign's folder: whole or not at all, and to last through a loss of
    power. A chunk that is there already is left as it is."""
    path = parts_folder(folder) / f"{checked_name(chunk)}{ENDING}"
    if path.exists():
        return path
    temporary = path.parent / f".{chunk[:60]}.{secrets.token_hex(8)}"
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            with temporary.open("xb") as stream:
                stream.write(part)
                stream.flush()
                os.fsync(stream.fileno())
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
        keep_names(path.parent)
    except OSError as error:
        what = f"the part cannot be written: {error.strerror}"
        mend = "free some space, or choose another place"
        raise Refusal(what, str(path), mend, "cannot-write") from error
    return path


def write_part(
    folder: Path, chunk: str, results: Sequence[CaseResult], head: Mapping[str, Any]
) -> Path:
    """Writes the results of a chunk: `part_of` and `store_part`."""
    return store_part(folder, chunk, part_of(chunk, results, head))
