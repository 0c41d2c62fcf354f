"""Records the reads and starts of this process: every interpreter that an evidence step starts
imports this module first. Writes a file name per line, immediately, since processes may be killed;
records nothing where writing fails, as in a sandbox."""

from __future__ import annotations

import os
import sys
from typing import Any

FOLDER = os.environ.get("MINKREF_EVIDENCE_RECORD", "")
HERE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.join(os.path.abspath(os.path.join(HERE, *[os.pardir] * 4)), "")
LEFT_OUT = os.path.join(ROOT, ".venv", "lib")
WRITES = os.O_WRONLY | os.O_RDWR | os.O_CREAT
STARTS = ("subprocess.Popen", "os.posix_spawn", "os.exec")
seen: set[str | bytes] = set()


def record(name: str | bytes, folder: str | None) -> None:
    if name in seen:
        return
    seen.add(name)
    path = os.path.join(folder or os.getcwd(), os.fsdecode(name))
    if path.startswith(ROOT) and not path.startswith(LEFT_OUT):
        to = os.open(f"{FOLDER}/{os.getpid()}", os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o644)
        try:
            os.write(to, path.encode("utf-8", "surrogateescape") + b"\n")
        finally:
            os.close(to)


def hear(event: str, given: tuple[Any, ...]) -> None:
    if event == "open":
        if isinstance(given[0], (str, bytes)) and not given[2] & WRITES:
            quietly(given[0], None)
    elif event in STARTS:
        words = given[1] if isinstance(given[1], (list, tuple)) else [given[1]]
        for name in (given[0], *words):
            if isinstance(name, (str, bytes, os.PathLike)):
                quietly(os.fspath(name), given[2] if event == "subprocess.Popen" else None)


def quietly(name: str | bytes, folder: Any) -> None:
    try:
        record(name, folder and os.fsdecode(folder))
    except Exception:  # noqa: BLE001 whatever it is, it is none of the process's business
        pass


if FOLDER:
    sys.addaudithook(hear)
