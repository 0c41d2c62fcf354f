"""Other people's files as texts: whole, with bounded length, in UTF-8."""

from __future__ import annotations

from pathlib import Path

from minkref.errors import Refusal

LONGEST = 64 << 20  # bytes; as in formats/limits.hpp


def text_of_file(path: Path, name: str, mend: str, longest: int = LONGEST) -> str:
    """Read a file as text; messages call the file `name`. Refuses an unreadable file, more than
    `longest` bytes (after reading one byte more), or text that is not UTF-8. O(longest)."""
    return decoded(bytes_of_file(path, name, mend, longest), name, longest)


def bytes_of_file(path: Path, name: str, mend: str, longest: int = LONGEST) -> bytes:
    """Read like `text_of_file`, but return one byte more than `longest` without refusing."""
    try:
        with path.open("rb") as stream:
            return stream.read(longest + 1)
    except (OSError, ValueError) as error:
        what = getattr(error, "strerror", None) or str(error)
        code = "no-such-file" if isinstance(error, FileNotFoundError) else "cannot-read"
        raise Refusal(f"the file cannot be read: {what}", name, mend, code) from error


def decoded(data: bytes, name: str, longest: int = LONGEST) -> str:
    """Decode a file or standard input, read up to one byte beyond `longest`. Refuses a longer text,
    or text that is not UTF-8."""
    if len(data) > longest:
        what = f"the text is longer than {longest:,} bytes"
        raise Refusal(what, name, "split the input", "file-too-large")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        what = f"the text is not UTF-8: {error.reason} at byte {error.start}"
        raise Refusal(what, name, "save it as UTF-8", "not-utf8") from error
