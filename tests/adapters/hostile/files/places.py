"""Paths without files, and files that change during reading."""

from __future__ import annotations

import os
import socket
import time
from collections.abc import Callable
from pathlib import Path

from hostile_file import FILE, JUDGED, PLANE, SPACE, SQUARE, Hostile, sparse
from made_files import CHECK, INDEX, LEDGER, index
from settings_files import BASELINE, CASE, CORPUS, SCALES, SETTINGS

READERS: dict[str, tuple[str, tuple[str, ...]]] = {
    "operand": ("it.wkt", PLANE),
    "mesh": ("it.off", SPACE),
    "index": ("it.index", INDEX),
    "certificate": ("it.cert.json", CHECK),
    "case": ("it.json", CASE),
    "settings": ("minkref.toml", SETTINGS),
    "baseline": ("known.json", BASELINE),
    "scales": ("scales.txt", SCALES),
    "ledger": ("run.ledger", LEDGER),
}


def link(target: str) -> Callable[[Path], None]:
    return lambda path: path.symlink_to(target)


def closed(path: Path) -> None:
    path.write_text(SQUARE)
    path.chmod(0)


def listening(path: Path) -> None:
    stream = socket.socket(socket.AF_UNIX)
    stream.bind(str(path))
    stream.close()


def pipe_that_speaks(path: Path) -> None:
    os.mkfifo(path)


def speak(path: Path) -> None:
    """An endless text into a pipe, until its reader has gone."""
    try:
        with path.open("wb", buffering=0) as stream:
            stream.write(b"POLYGON ((")
            while True:
                stream.write(b"0 0, 1 0, " * 10_000)
    except OSError:
        return


PLACES: dict[str, Callable[[Path], None]] = {
    "a folder": lambda path: path.mkdir(),
    "a link to itself": lambda path: path.symlink_to(path.name),
    "a link to nothing": link("nowhere"),
    "zeros without end": link("/dev/zero"),
    "a device that is empty": link("/dev/null"),
    "a device that is always full": link("/dev/full"),
    "the memory of the reader": link("/proc/self/mem"),
    "a socket": listening,
}


def of_places() -> list[Hostile]:
    found = [
        Hostile(f"{reader} is {title}", name, make, command, codes_of(reader, title))
        for title, make in PLACES.items()
        for reader, (name, command) in READERS.items()
    ]
    return [
        *found,
        Hostile("the folder of a corpus is a device", "corpus", link("/dev/zero"), CORPUS),
        Hostile("an operand is a file in a file", "it.wkt", SQUARE, ("sum", f"{FILE}/x.wkt", "g3")),
        Hostile("an operand is text of a million lines from a pipe", "it.wkt", pipe_that_speaks,
                PLANE, during=speak),
        Hostile("an operand is a sparse file of a terabyte", "it.wkt", sparse(1 << 40), PLANE),
        Hostile("an operand is a sparse file below the limit", "it.wkt", sparse(60 << 20), PLANE),
    ]  # fmt: skip


def codes_of(reader: str, title: str) -> tuple[int, ...]:
    """An empty ledger starts a new one; devices are written to."""
    if (reader, title) == ("settings", "a device that is empty"):
        return JUDGED
    if reader == "ledger" and title in ("a device that is empty", "a link to nothing"):
        return JUDGED
    return (2,)


def moments(change: Callable[[Path], None], count: int = 200) -> Callable[[Path], None]:
    """Repeats a change while a command reads the file."""

    def during(path: Path) -> None:
        for _ in range(count):
            try:
                change(path)
            except OSError:
                return
            time.sleep(0.005)

    return during


def truncated(path: Path) -> None:
    size = path.stat().st_size
    os.truncate(path, size // 2)
    time.sleep(0.002)
    os.truncate(path, size)


def overwritten(path: Path) -> None:
    with path.open("r+b") as stream:
        stream.seek(path.stat().st_size // 3)
        stream.write(os.urandom(4096))


def replaced(path: Path) -> None:
    other = path.with_name("other")
    other.write_text("OFF\n")
    other.replace(path)


LARGE = "POLYGON ((" + ", ".join(f"{k} {k * k}" for k in range(200_000)) + ", 0 0))"


def changing() -> list[Hostile]:
    """Files that change during reading: a command may read either content, but must not crash."""
    changes = {"truncated": truncated, "overwritten": overwritten, "replaced": replaced}
    whole = index(lambda data: None)
    found = []
    for title, change in changes.items():
        found += [
            Hostile(f"an index that is {title} while it is read", "it.index", whole,
                    ("view", "g1", "g2", "--index", FILE, "-o", "out.html"), JUDGED,
                    during=moments(change)),
            Hostile(f"an operand that is {title} while it is read", "it.wkt", LARGE, PLANE,
                    JUDGED, during=moments(change)),
            Hostile(f"a list of scales that is {title} while it is read", "scales.txt",
                    "".join(f"{k}\n" for k in range(1, 60)), SCALES, JUDGED,
                    during=moments(change)),
        ]  # fmt: skip
    return found


FILES = [*of_places(), *changing()]
