"""Where a ledger's files are, and which of them count: its list of compacted files, and the parts
whose chunks are in none of them.

The list, `compacted/list.json`, is replaced at once, after the files that it names are written;
what it does not name does not count, and is swept away by the next compaction. Readers hold a
shared lock meanwhile, so that no file goes away under a query.
"""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.fuzz.ledgers.file import ENDING, FORMAT, keep_names, parts_folder
from minkref.output.documents import writing

LIST = "list.json"
READERS = "readers.lock"


@dataclass(frozen=True)
class Compacted:
    """A compacted file: results, their counts, and all results on cases that any target got wrong.
    `chunks`: by name, rows, cases, absent and untaken cases. `sizes`: bytes by file."""

    name: str
    rows: int
    chunks: dict[str, list[int]]
    sizes: dict[str, int]

    def path(self, folder: Path, kind: str) -> Path:
        return compacted_folder(folder) / f"{self.name}.{kind}{ENDING}"


KINDS = ("results", "counts", "disputed")


@dataclass(frozen=True)
class Place:
    """A ledger as it was when it was looked at."""

    folder: Path
    compacted: tuple[Compacted, ...]
    present: tuple[str, ...]  # chunks with a part, compacted or not

    @cached_property
    def inside(self) -> frozenset[str]:
        """The chunks in compacted files."""
        return frozenset(chunk for each in self.compacted for chunk in each.chunks)

    @cached_property
    def loose(self) -> tuple[Path, ...]:
        """The parts that count by themselves, by name."""
        folder = parts_folder(self.folder)
        return tuple(folder / f"{c}{ENDING}" for c in self.present if c not in self.inside)

    def files(self, kind: str) -> list[Path]:
        return [each.path(self.folder, kind) for each in self.compacted]


def compacted_folder(folder: Path) -> Path:
    return folder / "ledger" / "compacted"


def is_ledger(folder: Path) -> bool:
    """Whether a campaign began there; it may have no results yet."""
    return any((folder / name).is_dir() for name in ("ledger", "campaigns"))


def look(folder: Path) -> Place:
    """The ledger below a campaign's folder, perhaps empty. Refuses a damaged list, and a compacted
    file that is missing or has another size than the list says."""
    # Parts first: one that is compacted meanwhile is then in both, and counts once.
    try:
        names = sorted(name for name in os.listdir(parts_folder(folder)) if _is_part(name))
    except FileNotFoundError:
        names = []
    compacted = _listed(folder)
    for each in compacted:
        for kind, size in each.sizes.items():
            _check_size(each.path(folder, kind), size)
    return Place(folder, compacted, tuple(name.removesuffix(ENDING) for name in names))


def chunks_in(folder: Path, campaign: str) -> frozenset[str]:
    """The chunks of a campaign that are in the ledger, compacted or not."""
    place = look(folder)
    start = f"{campaign}-"
    return frozenset(c for c in (*place.present, *place.inside) if c.startswith(start))


def write_list(folder: Path, compacted: list[Compacted]) -> None:
    """Makes these the compacted files that count."""
    value = {"format": FORMAT, "files": [vars(each) for each in compacted]}
    with writing(compacted_folder(folder) / LIST) as stream:
        stream.write(json.dumps(value, separators=(",", ":")).encode() + b"\n")
        stream.flush()
        os.fsync(stream.fileno())
    keep_names(compacted_folder(folder))  # before parts go


@contextmanager
def reading(folder: Path) -> Iterator[None]:
    """Keeps files from being swept away meanwhile. A ledger that cannot be written to has nobody
    who sweeps."""
    try:
        file = os.open(folder / "ledger" / READERS, os.O_RDONLY | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError:
        yield
        return
    try:
        fcntl.flock(file, fcntl.LOCK_SH)
        yield
    finally:
        os.close(file)


def sweep(folder: Path) -> bool:
    """Removes files that do not count: parts inside compacted files, and what an ended compaction
    left. Does nothing while somebody reads; tells whether it did it."""
    file = os.open(folder / "ledger" / READERS, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        place = look(folder)
        listed = {path.name for kind in KINDS for path in place.files(kind)}
        for path in compacted_folder(folder).glob(f"*{ENDING}"):
            if path.name not in listed:
                path.unlink(missing_ok=True)
        for chunk in place.present:
            if chunk in place.inside:
                (parts_folder(folder) / f"{chunk}{ENDING}").unlink(missing_ok=True)
    except BlockingIOError:
        return False
    finally:
        os.close(file)
    return True


def _is_part(name: str) -> bool:
    return name.endswith(ENDING) and not name.startswith(".")


def _listed(folder: Path) -> tuple[Compacted, ...]:
    path = compacted_folder(folder) / LIST
    try:
        value: Any = json.loads(path.read_text(encoding="utf-8"))
        if value["format"] != FORMAT:
            raise ValueError(f"it is a {value['format']!s:.20}, of another version of minkref")
        return tuple(Compacted(**each) for each in value["files"])
    except FileNotFoundError:
        return ()
    except (OSError, ValueError, KeyError, TypeError) as error:
        what = f"this is no list of a ledger's files: {error}"
        mend = "take the ledger from a copy: minkref campaign merge COPY -o DIR"
        raise Refusal(what, str(path), mend, "bad-ledger") from error


def _check_size(path: Path, size: int) -> None:
    mend = "take the ledger from a copy: minkref campaign merge COPY -o DIR"
    try:
        found = path.stat().st_size
    except OSError as error:
        what = f"a file of the ledger cannot be read: {error.strerror}"
        raise Refusal(what, str(path), mend, "bad-ledger") from error
    if found != size:
        what = f"a file of the ledger was changed: {found:,} bytes, {size:,} were written"
        raise Refusal(what, str(path), mend, "bad-ledger")
