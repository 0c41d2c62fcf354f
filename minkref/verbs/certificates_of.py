"""The certificates that `minkref check` is given: files, and all that a folder holds."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from minkref.errors import Refusal

ENDINGS = (".cert.json", ".cert.json.gz")
Found = tuple[Path, str]  # and why it is passed over, if it is


def certificates_of(given: Path) -> list[Found]:
    """The file itself, or the certificates in a folder and its folders, in order. Entries that may
    be certificates and are not followed are among them, each with the reason: links, what is no
    file, names in capitals, folders that cannot be read. Raises Refusal if there is nothing."""
    if not given.is_dir():
        return [(given, "")]
    found = sorted(_inside(given))
    if not found:
        mend = f"name files, or a folder that holds *{' or *'.join(ENDINGS)}"
        raise Refusal("there is no certificate in this folder", str(given), mend)
    return found


def _inside(folder: Path) -> Iterator[Found]:
    try:
        entries = list(os.scandir(folder))
    except OSError as error:
        yield folder, f"passed over: it cannot be read: {error.strerror}"
        return
    for entry in entries:
        path = Path(entry.path)
        if entry.is_symlink() and entry.is_dir():
            yield path, "passed over: a link to a folder is not followed; name the folder"
        elif entry.is_dir():
            yield from _inside(path)
        elif entry.name.lower().endswith(ENDINGS):
            yield path, _why_not(entry)


def _why_not(entry: os.DirEntry[str]) -> str:
    if entry.is_symlink():
        return "passed over: a link is not followed; name the file"
    if not entry.is_file():
        return "passed over: it is no file"
    if not entry.name.endswith(ENDINGS):
        return "passed over: its ending is in capitals; name the file"
    return ""
