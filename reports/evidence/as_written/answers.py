"""The command's answers, in this process: texts of standard output, documents, files.

`Answers` with another `change` act as a faulty command: the change alters the output on its way to
the judge.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from minkref.cli.cli import main
from minkref.reports.evidence.as_written.read_plane import load

Document = dict[str, Any]
Change = Callable[[str], str]
REFUSED = 2


class Refusal(Exception):
    """The command refused, and said why."""

    def __init__(self, code: str) -> None:
        super().__init__(code)
        self.code = code


class BrokenDown(Exception):
    """Raised for an exit code that is no refusal, or for malformed JSON."""


@contextmanager
def captured(number: int) -> Iterator[Any]:
    """Captures text that is written to a descriptor meanwhile, as a readable file."""
    sys.stdout.flush()
    sys.stderr.flush()
    kept = os.dup(number)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), number)
        try:
            yield file
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os.dup2(kept, number)
            os.close(kept)


def run(words: list[str]) -> tuple[int, str, str]:
    """Exit code, standard output and standard error of the command, run in this process."""
    before, code = sys.argv, 0
    sys.argv = ["minkref", *words]
    try:
        with captured(1) as out, captured(2) as err:
            try:
                main()
            except SystemExit as end:
                code = end.code if isinstance(end.code, int) else int(bool(end.code))
            sys.stdout.flush()
            sys.stderr.flush()
            texts = []
            for file in (out, err):
                file.seek(0)
                texts.append(file.read().decode())
    finally:
        sys.argv = before
    return code, texts[0], texts[1]


class Answers:
    """The command's answers, with files in a private folder."""

    def __init__(self, folder: Path, change: Change | None = None) -> None:
        self.folder, self.change = folder, change

    def _changed(self, text: str) -> str:
        return self.change(text) if self.change else text

    def document(self, *words: object) -> Document:
        """The document from --json, with numbers as texts."""
        code, out, err = run([*map(str, words), "--json"])
        _refuse(code, out, err)
        try:
            value: Document = load(self._changed(out))
        except ValueError as error:
            raise BrokenDown(f"no JSON: {error}") from error
        return value

    def table(self, *words: object) -> str:
        code, out, err = run([*map(str, words)])
        _refuse(code, out, err)
        return self._changed(out)

    def file(self, ending: str, *words: object) -> tuple[str, str]:
        """The text of a file written with -o, and the table beside the file."""
        path = self.folder / f"sum.{ending}"
        path.unlink(missing_ok=True)
        code, out, err = run([*map(str, words), "-o", str(path)])
        _refuse(code, out, err)
        return self.read(path), self._changed(out)

    def read(self, path: Path) -> str:
        return self._changed(path.read_bytes().decode())


def _refuse(code: int, out: str, err: str) -> None:
    if code == 0:
        return
    if code != REFUSED:
        raise BrokenDown(f"exit code {code}: {err.strip()[-200:]}")
    with suppress(ValueError, KeyError, TypeError):
        raise Refusal(str(json.loads(out)["error"]["code"]))
    raise Refusal((err.strip().splitlines() or [""])[0].rsplit(": ", 1)[-1][:120])
