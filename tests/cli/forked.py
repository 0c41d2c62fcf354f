"""The program in a copy of this process: with streams, a folder and limits of its own, but with no
interpreter to start and nothing to load."""

from __future__ import annotations

import os
import sys
import tempfile
import traceback
from collections.abc import Callable
from contextlib import ExitStack
from importlib import import_module
from pathlib import Path
from subprocess import CompletedProcess
from typing import IO, Any, NoReturn

from minkref.cli.cli import main


def forked(
    folder: Path, *words: str | Path, given: bytes = b"", before: Callable[[], Any] = int
) -> CompletedProcess[str]:
    """The copy's exit code and output. `given`: its standard input. `before` runs inside the copy,
    whose streams are 0, 1 and 2."""
    arguments = ["minkref", *map(str, words)]
    with ExitStack() as files:
        streams = [files.enter_context(tempfile.TemporaryFile()) for _ in range(4)]
        streams[0].write(given)
        streams[0].seek(0)
        child = os.fork()
        if child == 0:
            _become(arguments, folder, streams, before)
        _, status = os.waitpid(child, 0)
        for stream in streams:
            stream.seek(0)
        said, warned, loaded = (stream.read().decode() for stream in streams[1:])
    for name in loaded.split():  # once, and not in each copy again
        if name not in sys.modules:
            import_module(name)
    return CompletedProcess(arguments, os.waitstatus_to_exitcode(status), said, warned)


def _become(
    arguments: list[str], folder: Path, streams: list[IO[bytes]], before: Callable[[], Any]
) -> NoReturn:
    code = 99
    known = set(sys.modules)
    try:
        for number, stream in enumerate(streams[:3]):
            os.dup2(stream.fileno(), number)
        os.chdir(folder)
        sys.argv[:] = arguments
        sys.stdin, sys.stdout, sys.stderr = (
            open(number, mode, encoding="utf-8", errors="surrogateescape", closefd=False)
            for number, mode in enumerate("rww")
        )
        before()
        main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else code
    except BaseException:  # noqa: BLE001 a copy of the tests must not go on
        traceback.print_exc()
    finally:
        ours = [name for name in sys.modules if name.startswith("minkref.") and name not in known]
        try:
            os.write(streams[3].fileno(), " ".join(ours).encode())
            sys.stdout.flush()
            sys.stderr.flush()
        except OSError:
            code = 120  # as the interpreter does
        os._exit(code)
