"""What a command hands out: one JSON document on standard output, or a file written all at once."""

from __future__ import annotations

import json
import os
import re
import resource
import secrets
import stat
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.signals import ending_in_order
from minkref.version import version

TEMPORARY = ".minkref-"  # what names of files begin with that are being written
_SURROGATE = re.compile("[\ud800-\udfff]")


def peak_bytes() -> int:
    """The largest resident size of this process or of any child that ended."""
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    children = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    unit = 1 if sys.platform == "darwin" else 1024
    return max(own, children) * unit


class Stopwatch:
    """Seconds since the command began."""

    def __init__(self) -> None:
        self._start = time.perf_counter()

    def seconds(self) -> float:
        return round(time.perf_counter() - self._start, 6)


def document(command: str, watch: Stopwatch, **fields: Any) -> dict[str, Any]:
    """A result of `command` with the fields that every document has."""
    return {
        "version": version(),
        "command": command,
        "seconds": watch.seconds(),
        "peak_bytes": peak_bytes(),
        **fields,
    }


def as_text(value: dict[str, Any]) -> str:
    """JSON text of a document. File names that are not UTF-8 have their bytes as lone surrogates,
    which JSON can say in escapes only."""
    unicode = (sys.stdout.encoding or "").lower().replace("-", "") == "utf8"
    text = json.dumps(value, ensure_ascii=not unicode, allow_nan=False, indent=2) + "\n"
    return _SURROGATE.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def listing(value: dict[str, Any], name: str, items: Iterable[Any]) -> Iterator[str]:
    """The pieces of the JSON text of a document with a last field `name`, a list too long to be
    held in memory: one item a line."""
    empty = "[]\n}\n"
    yield as_text({**value, name: []}).removesuffix(empty)
    first = True
    for item in items:
        yield ("[\n" if first else ",\n") + json.dumps(item)
        first = False
    yield empty if first else "\n]\n}\n"


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A new empty file beside `path` to write to; it takes the place of `path` once all is written,
    or is removed, also where a signal ends the process. Where `path` is a symbolic link, the file
    that it points to is replaced. A pipe or device is written to itself."""
    path = _followed(path)
    if _is_stream(path):
        try:
            yield path
        except OSError as error:
            raise _cannot_write(path, error) from error
        return
    # Named before it is made: a signal at any moment finds it to be removed.
    temporary = path.parent / f"{TEMPORARY}{secrets.token_hex(8)}"
    with ending_in_order():
        try:
            try:
                temporary.touch(exist_ok=False)
            except OSError as error:
                raise Refusal(
                    f"no file can be made in {path.parent}: {error.strerror}",
                    str(path),
                    "choose another place",
                    "cannot-write",
                ) from error
            yield temporary
            os.replace(temporary, path)
        except OSError as error:
            raise _cannot_write(path, error) from error
        finally:
            temporary.unlink(missing_ok=True)


def write_atomically(path: Path, text: str | Iterable[str]) -> None:
    """Writes all of `text`, given whole or piece by piece, or nothing."""
    with (
        replacing(path) as temporary,
        temporary.open("w", encoding="utf-8", errors="backslashreplace") as stream,
    ):
        stream.writelines([text] if isinstance(text, str) else text)


def check_writable(path: Path) -> None:
    """Refuses an output path that cannot be written, before any work is done."""
    path = _followed(path)
    if path.is_dir():
        raise Refusal("this is a folder", str(path), "name a file", "cannot-write")
    if path.is_symlink():
        raise Refusal(
            "this symbolic link leads back to itself", str(path), "name a file", "cannot-write"
        )
    if _is_stream(path):
        return
    if not path.parent.is_dir():
        raise Refusal(
            "the folder of the output file does not exist",
            str(path),
            f"create {path.parent} first",
            "cannot-write",
        )
    if not os.access(path.parent, os.W_OK):
        raise Refusal(
            "the folder of the output file is not writable",
            str(path),
            "choose another place",
            "cannot-write",
        )


def check_spares(path: Path, operands: Iterable[Path]) -> None:
    """Refuses an output path that is the file of an operand."""
    for file in operands:
        try:
            same = os.path.samefile(path, file)
        except OSError:  # one of them does not exist
            continue
        if same:
            raise Refusal(
                "this is the file of an operand, which would be lost",
                str(path),
                "write to another file",
                "cannot-write",
            )


def _followed(path: Path) -> Path:
    return Path(os.path.realpath(path))


def _is_stream(path: Path) -> bool:
    """A pipe or a device, such as /dev/stdout."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return stat.S_ISFIFO(mode) or stat.S_ISCHR(mode)


def _cannot_write(path: Path, error: OSError) -> Refusal:
    return Refusal(
        f"the file cannot be written: {error.strerror}",
        str(path),
        "choose another place or free some space",
        "cannot-write",
    )
