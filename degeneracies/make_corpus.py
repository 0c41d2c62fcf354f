"""Makes the corpus that ships with the project: `python -m minkref.degeneracies.make_corpus`."""

from __future__ import annotations

import argparse
import multiprocessing
from pathlib import Path

from minkref.degeneracies.catalogue import GROUP_OF, OUTLINES, made_member
from minkref.degeneracies.files import made_case
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.outline import CORPUS

SEED = 1


def make(folder: Path, corpus: Path = CORPUS) -> None:
    """Makes members of all families with cases in `corpus`; for the large one also the cases found
    by verification."""
    tasks = [
        (family, index, folder)
        for outline in OUTLINES
        if outline.corpus == corpus
        for family in outline.families
        for index in range(outline.count)
    ]
    with multiprocessing.Pool() as pool:
        pool.starmap(_make, tasks, chunksize=4)
    if corpus == CORPUS:
        for found in FOUND:
            made_case(found.case, 0).write(folder)


def _make(family: str, index: int, folder: Path) -> None:
    made_member(GROUP_OF[family].families[family], SEED, index).write(folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Writes the corpus anew.")
    parser.add_argument("folder", nargs="?", type=Path, help="default: its own")
    parser.set_defaults(corpus=CORPUS)
    for outline in OUTLINES:
        if outline.corpus != CORPUS:
            parser.add_argument(
                f"--{outline.word}",
                dest="corpus",
                action="store_const",
                const=outline.corpus,
                help=f"what `minkref generate {outline.word}` makes, into their folder",
            )
    arguments = parser.parse_args()
    make(arguments.folder or arguments.corpus, arguments.corpus)
