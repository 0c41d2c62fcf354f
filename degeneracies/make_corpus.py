"""Makes the corpus that ships with the project: `python -m minkref.degeneracies.make_corpus`."""

from __future__ import annotations

import argparse
import multiprocessing
from pathlib import Path

from minkref.degeneracies.catalogue import (
    ALL_FAMILIES,
    DISC_FAMILIES,
    FAMILIES,
    PATH_FAMILIES,
    SOLID_FAMILIES,
    SPACE_FAMILIES,
)
from minkref.degeneracies.disc.case_faults import CORPUS as CORPUS_WITH_DISC
from minkref.degeneracies.files import made_path, made_with_disc, write_found, write_member
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.motion.case_faults import CORPUS as CORPUS_OF_PATHS

SEED = 1
COUNT = 11  # members per family in the plane
COUNT_IN_SPACE = 3  # per family of convex bodies
COUNT_OF_SOLIDS = 2  # per family of polyhedra of any shape
COUNT_WITH_DISC = 3  # per family with a polygon set and a disc
COUNT_OF_PATHS = 3  # per family of paths and traps
CORPUS = Path(__file__).parent / "corpus"


def make(folder: Path) -> None:
    """Makes members of all families, and the cases found by verification."""
    tasks = [(family, index, folder) for family in FAMILIES for index in range(COUNT)]
    tasks += [
        (family, index, folder) for family in SPACE_FAMILIES for index in range(COUNT_IN_SPACE)
    ]
    tasks += [
        (family, index, folder) for family in SOLID_FAMILIES for index in range(COUNT_OF_SOLIDS)
    ]
    with multiprocessing.Pool() as pool:
        pool.starmap(_make, tasks, chunksize=4)
    for found in FOUND:
        write_found(found, folder)


def _make(family: str, index: int, folder: Path) -> None:
    write_member(ALL_FAMILIES[family], SEED, index, folder)


def make_with_disc(folder: Path) -> None:
    """Makes members of the families with a polygon set and a disc, in a folder of their own."""
    tasks = [
        (family, index, folder) for family in DISC_FAMILIES for index in range(COUNT_WITH_DISC)
    ]
    with multiprocessing.Pool() as pool:
        pool.starmap(_make_with_disc, tasks, chunksize=4)


def _make_with_disc(family: str, index: int, folder: Path) -> None:
    made_with_disc(DISC_FAMILIES[family], SEED, index).write(folder)


def make_paths(folder: Path) -> None:
    """Makes members of the families of paths and traps, in a folder of their own."""
    for family in PATH_FAMILIES.values():
        for index in range(COUNT_OF_PATHS):
            made_path(family, SEED, index).write(folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Writes the corpus anew.")
    parser.add_argument("folder", nargs="?", type=Path, default=CORPUS, help="default: its own")
    parser.add_argument("--disc", action="store_true", help="those with a disc, into their folder")
    parser.add_argument("--paths", action="store_true", help="paths and traps, into their folder")
    arguments = parser.parse_args()
    if arguments.paths:
        make_paths(CORPUS_OF_PATHS if arguments.folder == CORPUS else arguments.folder)
    elif arguments.disc:
        make_with_disc(CORPUS_WITH_DISC if arguments.folder == CORPUS else arguments.folder)
    else:
        make(arguments.folder)
