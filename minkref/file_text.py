"""Files of others as texts: whole, bounded in length, UTF-8."""

from __future__ import annotations

from pathlib import Path

from minkref.errors import Refusal

LONGEST = 64 << 20  # bytes; that of formats/limits.hpp


def text_of_file(path: Path, name: str, mend: str, longest: int = LONGEST) -> str:
    """The text of a file that messages call `name`. Refuses what cannot be read, is longer than
    `longest` bytes, of which no more than one more is read, or is not UTF-8. O(longest)."""
    return decoded(bytes_of_file(path, name, mend, longest), name, longest)


def bytes_of_file(path: Path, name: str, mend: str, longest: int = LONGEST) -> bytes:
    """As `text_of_file`, but one byte more than `longest` is no refusal yet."""
    try:
        with path.open("rb") as stream:
            return stream.read(longest + 1)
    except (OSError, ValueError) as error:
        what = getattr(error, "strerror", None) or str(error)
        code = "no-such-file" if isinstance(error, FileNotFoundError) else "cannot-read"
        raise Refusal(f"the file cannot be read: {what}", name, mend, code) from error


def decoded(data: bytes, name: str, longest: int = LONGEST) -> str:
    """The text of a file or of standard input, of which one byte more than `longest` was read at
    most. Refuses what is longer, or not UTF-8."""
    if len(data) > longest:
        what = f"the text is longer than {longest:,} bytes"
        raise Refusal(what, name, "split the input", "file-too-large")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        what = f"the text is not UTF-8: {error.reason} at byte {error.start}"
        raise Refusal(what, name, "save it as UTF-8", "not-utf8") from error
