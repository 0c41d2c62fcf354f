"""Rows of a long table, which are not held in memory."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from itertools import islice
from typing import Any

from minkref.errors import Refusal

IN_MEMORY = 1 << 22  # bytes

Row = dict[str, Any]


class RowSpool:
    """Rows are added, then read as often as is wanted, in order. Many of them are kept in a file
    without a name, which goes with the process, as JSON lines."""

    def __init__(self) -> None:
        self._file = tempfile.SpooledTemporaryFile(IN_MEMORY)
        self._count = 0

    def add(self, row: Row) -> None:
        """Refuses where the disk is full."""
        try:
            self._file.write(json.dumps(row).encode() + b"\n")
        except OSError as error:
            raise Refusal(
                f"there is no room for the rows of a long table: {error.strerror}",
                "the folder of temporary files",
                "free some space, or set TMPDIR to another folder",
                "cannot-write",
            ) from error
        self._count += 1

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Row]:
        self._file.seek(0)
        for line in self._file:
            yield json.loads(line)

    def first(self, count: int) -> list[Row]:
        return list(islice(self, count))
