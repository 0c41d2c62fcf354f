"""A folder for a command's files."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from minkref.errors import Refusal
from minkref.output.documents import check_writable
from minkref.output.output_target import refuse_stream


def folder_to_write(name: str, inside: Iterable[str] = ()) -> Path:
    """Read the folder named by -o. Refuses a folder where no file can be made, there or inside the
    folders `inside`, before any work; makes no folder."""
    if not name:
        raise Refusal(
            "the name of the folder is empty", "-o ''", "name one; . is the current folder"
        )
    folder = Path(name)
    refuse_stream(folder, "this command writes many files, to a folder", "name a folder")
    for path in (folder, *(folder / each for each in inside)):
        try:
            _check_folder(path)
        except OSError as error:
            raise _cannot_make(path, error) from error
    return folder


def _check_folder(path: Path) -> None:
    """Checks the nearest existing ancestor of the folder: the folder will be created there."""
    for each in (path, *path.absolute().parents):
        if each.is_dir():
            check_writable(each / "ID.json")
            return
        if os.path.lexists(each):
            raise _no_folder(each)


def make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise _no_folder(folder) from error
    except OSError as error:
        raise _cannot_make(folder, error) from error


@contextmanager
def held_folder(folder: Path) -> Iterator[None]:
    """Make the folder and hold it against other runs until the end. Leaves no lock, however the
    process ends. A file system without folder locks (some over a network) gives no protection."""
    make_folder(folder)
    file = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(file)
        mend = "name another folder, or wait for the other run"
        what = "another run writes to this folder"
        raise Refusal(what, str(folder), mend, "cannot-write") from error
    except OSError:
        pass
    try:
        yield
    finally:
        os.close(file)


def _no_folder(path: Path) -> Refusal:
    mend = "name another folder, or take this out of the way"
    return Refusal("this is not a folder", str(path), mend, "cannot-write")


def _cannot_make(folder: Path, error: OSError) -> Refusal:
    what = f"the folder cannot be made: {error.strerror}"
    return Refusal(what, str(folder), "choose another place", "cannot-write")
