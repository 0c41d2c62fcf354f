"""Ledgers put together: the union of their chunks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from minkref.errors import Refusal
from minkref.fuzz.ledgers.counting import Chunks, plain_rows
from minkref.fuzz.ledgers.file import file_of
from minkref.fuzz.ledgers.part import store_part
from minkref.fuzz.ledgers.place import is_ledger, look, reading


@dataclass
class Merged:
    """`chunks` were written; `repeated` ones were there already; `differing` ones of these are
    other results, but for times, so that a target does not answer alike."""

    chunks: int = 0
    repeated: int = 0
    differing: list[str] = field(default_factory=list)


def merge_parts(sources: Sequence[Path], target: Path) -> Merged:
    """Writes all chunks of the sources to the target, a part each; the first one counts where
    several have the same. The target keeps its own. Memory: two files. Refuses damaged files;
    an interrupted merge goes on when it is asked for again."""
    done = Merged()
    for source in sources:
        if not is_ledger(source):
            mend = "name folders of campaigns: minkref campaign run FILE.toml"
            raise Refusal("there is no ledger in this folder", str(source), mend, "no-ledger")
    for source in sources:
        if source.resolve() == target.resolve():
            continue
        with reading(source):
            mine, known = Chunks(look(source)), Chunks(look(target))
            for chunk in mine:
                _add(chunk, mine, known, target, done)
    return done


def _add(chunk: str, mine: Chunks, known: Chunks, target: Path, done: Merged) -> None:
    if chunk not in known:
        store_part(target, chunk, file_of(mine.rows(chunk), {chunk: mine.told(chunk)}))
        done.chunks += 1
        return
    done.repeated += 1
    if plain_rows(mine.rows(chunk)) != plain_rows(known.rows(chunk)):
        done.differing.append(chunk)
