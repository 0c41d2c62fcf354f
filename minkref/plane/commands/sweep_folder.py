"""The folder that a sweep writes: a file for each scale, and an index of them.

A folder is known to be that of a sweep by its index, or, while the sweep is not done, by the file
`.minkref-sweep`.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path

from minkref import _core
from minkref.errors import Refusal, choice
from minkref.output.documents import TEMPORARY, check_writable, write_atomically
from minkref.output.output_target import refuse_stream
from minkref.output.terminal import escaped

INDEX = "index.json"
UNFINISHED = f"{TEMPORARY}sweep"
FORMATS = tuple(dict.fromkeys(("json", *_core.SET_FORMATS)))
SPACE_FORMATS = tuple(dict.fromkeys(("json", *_core.MESH_FORMATS)))
_OURS = re.compile(
    rf"sum-[0-9]{{4,}}\.({'|'.join({*FORMATS, *SPACE_FORMATS})})|{re.escape(INDEX)}"
    rf"|{re.escape(TEMPORARY)}.*",
    re.ASCII,
)


class SweepFolder:
    """Every file in it is whole: written beside, then renamed. Nothing is touched before the first
    file is written; then an earlier sweep in the folder is removed."""

    def __init__(self, path: Path, form: str) -> None:
        """Refuses a folder that cannot be written, or that holds anything but a sweep."""
        self.path = path
        self.form = form
        self._begun = self._made = False
        mend = "name a folder, or leave out -o: --json prints what is found at each scale"
        refuse_stream(path, "a sweep is a folder of files", mend)
        if path.exists() and not path.is_dir():
            raise Refusal("this is not a folder", str(path), "name a folder", "cannot-write")
        if not path.exists():
            check_writable(path)
            return
        check_writable(path / INDEX)
        names = self._names()
        known = _is_sweep(path)
        foreign = sorted(
            name
            for name in names
            if not known or not _OURS.fullmatch(name) or not (path / name).is_file()
        )
        if foreign:
            count = f" and {len(foreign) - 1:,} more" if len(foreign) > 1 else ""
            raise Refusal(
                f"the folder holds files of others: {escaped(foreign[0])}{count}",
                str(path),
                "name an empty folder, a new one, or one that holds nothing but an earlier sweep",
                "folder-not-empty",
            )

    def refuse_overwriting(self, operands: Iterable[Path]) -> None:
        """Refuses to replace an earlier sweep that holds an operand."""
        for file in operands:
            if (
                self.path.is_dir()
                and file.exists()
                and file.resolve().parent == self.path.resolve()
            ):
                raise Refusal(
                    f"the folder holds the operand {escaped(file.name)}, which would be lost",
                    str(self.path),
                    "name another folder",
                    "folder-not-empty",
                )

    def name(self, number: int) -> str:
        """The name of the file of a scale; scales are numbered from 1."""
        return f"sum-{number:04}.{self.form}"

    def write(self, name: str, text: str | Iterable[str]) -> None:
        """Where there is no room for it, nothing of the sweep is left."""
        try:
            self._begin()
            write_atomically(self.path / name, text)
        except Refusal:
            self._remove()
            raise
        if name == INDEX:
            (self.path / UNFINISHED).unlink(missing_ok=True)

    def _names(self) -> list[str]:
        try:
            return os.listdir(self.path)
        except OSError as error:
            what = f"the folder cannot be read: {error.strerror}"
            raise Refusal(what, str(self.path), "choose another place", "cannot-write") from error

    def _begin(self) -> None:
        if self._begun:
            return
        try:
            self._made = not self.path.exists()
            Path(os.path.realpath(self.path)).mkdir(exist_ok=True)
            (self.path / UNFINISHED).touch()
            self._remove_sums()
        except OSError as error:
            what = f"the folder cannot be written: {error.strerror}"
            raise Refusal(what, str(self.path), "choose another place", "cannot-write") from error
        self._begun = True

    def _remove_sums(self) -> None:
        for name in self._names():
            if _OURS.fullmatch(name) and name != UNFINISHED:
                (self.path / name).unlink()

    def _remove(self) -> None:
        """Removes all that this sweep has written, and the folder if it has made it."""
        if not self._begun:
            return
        with suppress(OSError, Refusal):
            self._remove_sums()
            (self.path / UNFINISHED).unlink(missing_ok=True)
            if self._made:
                Path(os.path.realpath(self.path)).rmdir()


def sweep_folder(
    output: Path | None, form: str | None, formats: Sequence[str], where: str = ""
) -> SweepFolder | None:
    """The folder of -o and --format. `where`: words before the list of formats in a refusal."""
    if form is not None and form not in formats:
        raise Refusal(f"there is no format {form!r}", "--format", where + choice(form, formats))
    if form is not None and output is None:
        raise Refusal(
            "there are no files without -o", f"--format {form}", "add -o DIR, or leave out --format"
        )
    return None if output is None else SweepFolder(output, form or formats[0])


def _is_sweep(path: Path) -> bool:
    """Whether a sweep has written to a folder."""
    if (path / UNFINISHED).is_file():
        return True
    try:
        index = json.loads((path / INDEX).read_bytes())
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(index, dict) and index.get("command") == "sweep" and "version" in index
