"""Results of a command: one JSON document on standard output, or a file written all at once."""

from __future__ import annotations

import errno
import json
import os
import re
import resource
import secrets
import stat
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, BinaryIO

from minkref.errors import Refusal
from minkref.output.signals import ending_in_order
from minkref.output.streams import OutputLost, is_open
from minkref.version import version

_DESCRIPTOR = re.compile(r"/dev/(stdout|stderr)|(?:/dev|/proc/self)/fd/([0-9]{1,9})", re.ASCII)
TEMPORARY = ".minkref-"  # prefix of files still being written
_SURROGATE = re.compile("[\ud800-\udfff]")


def peak_bytes() -> int:
    """Return the largest resident size of this process or of any ended child."""
    unit = 1 if sys.platform == "darwin" else 1024
    children = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * unit
    try:  # getrusage begins at the size of the process that started this one
        status = Path("/proc/self/status").read_text()
        own = int(status.partition("VmHWM:")[2].split()[0]) * 1024
    except (OSError, IndexError, ValueError):
        own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit
    return max(own, children)


class Stopwatch:
    """Seconds since the command began."""

    def __init__(self) -> None:
        self._start = time.perf_counter()

    def seconds(self) -> float:
        return round(time.perf_counter() - self._start, 6)


def document(command: str, watch: Stopwatch, **fields: Any) -> dict[str, Any]:
    """Make a result of `command` with the fields common to all documents."""
    return {
        "version": version(),
        "command": command,
        "seconds": watch.seconds(),
        "peak_bytes": peak_bytes(),
        **fields,
    }


def lasting(value: Any) -> Any:
    """Return the document for a file, with null for times and memory, so that two runs write the
    same bytes."""
    if isinstance(value, dict):
        return {name: None if _is_cost(name) else lasting(value[name]) for name in value}
    return [lasting(each) for each in value] if isinstance(value, list) else value


def _is_cost(name: str) -> bool:
    return name in ("seconds", "peak_bytes") or name.endswith("_seconds")


def as_text(value: dict[str, Any]) -> str:
    """Write a document as JSON text. Names of files outside UTF-8 keep their bytes as lone
    surrogates, which JSON can only escape."""
    unicode = (sys.stdout.encoding or "").lower().replace("-", "") == "utf8"
    text = json.dumps(value, ensure_ascii=not unicode, allow_nan=False, indent=2) + "\n"
    return _SURROGATE.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def listing(value: dict[str, Any], name: str, items: Iterable[Any]) -> Iterator[str]:
    """Yield a document's JSON text piece by piece, with a last field `name`, a list too long for
    memory: one item per line."""
    empty = "[]\n}\n"
    yield as_text({**value, name: []}).removesuffix(empty)
    first = True
    for item in items:
        yield ("[\n" if first else ",\n") + json.dumps(item)
        first = False
    yield empty if first else "\n]\n}\n"


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Make an empty file beside `path` for writing; replaces `path` once all is written, or removes
    the new file, even if a signal ends the process. Replaces a symbolic link's target, not the
    link. Writes to a pipe or device itself."""
    if is_stream(path):
        try:
            yield path
        except OSError as error:
            raise _cannot_write(path, error) from error
        return
    path = _followed(path)
    # Named before being made: a signal at any moment finds the name to remove.
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


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Make a folder for files that nobody keeps. Refuses without room for files."""
    try:
        with tempfile.TemporaryDirectory(prefix="minkref-") as folder:
            yield Path(folder)
    except OSError as error:
        raise Refusal(
            f"a temporary file cannot be written: {error.strerror}",
            "the folder of temporary files",
            "free some space, or set TMPDIR to another folder",
            "cannot-write",
        ) from error


@contextmanager
def writing(path: Path) -> Iterator[BinaryIO]:
    """Open a stream for writing, like `replacing`; an open descriptor (/dev/stdout, /dev/fd/N)
    continues at its position, even in a file."""
    number = descriptor_of(path)
    if number is None:
        with replacing(path) as temporary, temporary.open("wb") as stream:
            yield stream
        return
    sys.stdout.flush()
    try:
        with open(number, "wb", closefd=False) as stream:
            yield stream
    except OSError as error:
        raise _cannot_write(path, error) from error


def write_together(files: Mapping[Path, str | bytes]) -> None:
    """Write all files, or none if any cannot be written. Open descriptors, pipes and devices come
    last."""
    with ExitStack() as stack:
        streams = []
        for path, text in files.items():
            data = text if isinstance(text, bytes) else text.encode(errors="backslashreplace")
            if is_stream(path):
                streams.append((path, data))
            else:
                stack.enter_context(replacing(path)).write_bytes(data)
        for path, data in streams:
            with writing(path) as stream:
                stream.write(data)


def write_atomically(path: Path, text: str | Iterable[str]) -> None:
    """Write all of `text`, whole or piece by piece, or nothing."""
    with writing(path) as stream:
        for piece in [text] if isinstance(text, str) else text:
            stream.write(piece.encode(errors="backslashreplace"))


def check_writable(path: Path) -> None:
    """Refuse an output path that cannot be written, before any work."""
    number = descriptor_of(path)
    if number is not None and not is_open(number):
        what = f"descriptor {number} is not open"
        raise Refusal(what, str(path), f"open it: minkref ... {number}>FILE", "cannot-write")
    if is_stream(path):
        return
    path = _followed(path)
    if path.is_dir():
        raise Refusal("this is a folder", str(path), "name a file", "cannot-write")
    if path.is_symlink():
        raise Refusal(
            "this symbolic link points back to itself", str(path), "name a file", "cannot-write"
        )
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


def refuse_overwriting(path: Path, operands: Iterable[Path]) -> None:
    """Refuse an output path that names an operand's file."""
    for file in operands:
        try:
            same = os.path.samefile(path, file)
        except OSError:  # a file does not exist
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


def descriptor_of(path: Path) -> int | None:
    """Find the number in /dev/stdout, /dev/stderr, /dev/fd/N and /proc/self/fd/N."""
    found = _DESCRIPTOR.fullmatch(str(path))
    if found is None:
        return None
    return int(found[2]) if found[2] else {"stdout": 1, "stderr": 2}[found[1]]


def is_stream(path: Path) -> bool:
    """Tell whether a path is an open descriptor, a pipe or a device, written to directly."""
    if descriptor_of(path) is not None:
        return True
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return stat.S_ISFIFO(mode) or stat.S_ISCHR(mode)


def _cannot_write(path: Path, error: OSError) -> Exception:
    if error.errno == errno.EPIPE:
        return OutputLost(error)
    return Refusal(
        f"the file cannot be written: {error.strerror}",
        str(path),
        "choose another place or free some space",
        "cannot-write",
    )
