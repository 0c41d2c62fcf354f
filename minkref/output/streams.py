"""The command's standard streams: a failed write raises one kind of exception, whoever writes."""

from __future__ import annotations

import errno
import io
import os
import sys

STANDARD = ((0, os.O_RDONLY), (1, os.O_RDONLY), (2, os.O_WRONLY))


class OutputLost(Exception):
    """Standard output takes nothing more."""

    def __init__(self, error: OSError) -> None:
        super().__init__(error.strerror or str(error))
        self.reader_has_gone = error.errno == errno.EPIPE


class _Output(io.FileIO):
    def write(self, data: object) -> int:
        try:
            return super().write(data)  # type: ignore[arg-type]
        except OSError as error:
            raise OutputLost(error) from error


class _Errors(io.FileIO):
    """Drops text that standard error cannot take: nowhere is left to say so."""

    def write(self, data: object) -> int:
        try:
            return super().write(data)  # type: ignore[arg-type]
        except OSError:
            return memoryview(data).nbytes  # type: ignore[arg-type]


def guard() -> None:
    """Replace sys.stdout and sys.stderr. A closed stream gets a descriptor that can never hold a
    file of ours by accident; writing to it fails. Names with any letters can be written."""
    for descriptor, mode in STANDARD:
        if not is_open(descriptor):
            _point(descriptor, mode)
    sys.stdout = _text(_Output(1, "w", closefd=False), sys.stdout)
    sys.stderr = _text(_Errors(2, "w", closefd=False), sys.stderr)


def give_up_output() -> None:
    """Discard any text still to be written."""
    _point(1, os.O_WRONLY)
    sys.stdout.flush()


def is_open(descriptor: int) -> bool:
    try:
        os.fstat(descriptor)
    except OSError:
        return False
    return True


def _point(descriptor: int, mode: int) -> None:
    nowhere = os.open(os.devnull, mode)
    if nowhere != descriptor:
        os.dup2(nowhere, descriptor)
        os.close(nowhere)
    else:
        os.set_inheritable(descriptor, True)


def _text(raw: io.FileIO, before: object) -> io.TextIOWrapper:
    return io.TextIOWrapper(
        io.BufferedWriter(raw),
        encoding=getattr(before, "encoding", None) or "utf-8",
        errors="backslashreplace",
        line_buffering=raw.isatty() or raw.fileno() == 2,
    )
