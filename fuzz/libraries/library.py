"""What a library on trial is: a folder here, whose `__init__.py` holds its LIBRARY."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Adapter:
    """`kind` is how it is had: `python` (an environment of its own), `c++` (compiled), `debian`
    (a package of the system), `cgal` (built with the project), `own` (always there). `program`: its
    path from here, or the name of an executable. `home` is the folder of what is installed, which
    adapters may share."""

    name: str
    title: str
    kind: str
    program: str
    source: str
    licence: str
    arguments: tuple[str, ...] = ()
    home: str = ""
    language: str = "C++"


@dataclass(frozen=True)
class Library:
    """`targets`: how the names of its targets begin. `place`: where it stands in lists.
    `has_program`: whether `program.py` beside it shows a finding with the library alone."""

    title: str
    targets: str
    place: int
    adapters: tuple[Adapter, ...]
    has_program: bool = True
