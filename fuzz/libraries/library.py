"""A library on trial: a folder here, whose `__init__.py` holds its LIBRARY."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Adapter:
    """`kind` tells how to get the adapter: `python` (an environment of its own), `c++` (compiled),
    `node`, `java`, `rust` (other_languages.py), `debian` (a system package), `cgal` (built with the
    project), `own` (always there). `program`:
    its path from here, or an executable's name. `home` is the installation's folder, which adapters
    may share."""

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
class Method:
    """A sum from a library: its adapter's name and title, the argument that selects it on the
    command line, and its program if that is not the library's."""

    name: str
    title: str
    argument: str = ""
    program: str = ""


@dataclass(frozen=True)
class Library:
    """`targets`: the prefix of target names. `place`: the position in lists. `has_program`: whether
    `program.py` beside it shows a finding with the library alone. `read`: makes a method of a name
    that begins with the prefix and is not listed, or refuses the name; None if all names are
    listed. `in_all`: whether the group of all targets includes it. `shows_unions`:
    whether its program shows wrong unions, and no sums. All the library's adapters share
    the other members."""

    title: str
    targets: str
    place: int
    methods: tuple[Method, ...]
    kind: str
    program: str
    source: str
    licence: str
    home: str = ""
    has_program: bool = True
    read: Callable[[str], Method] | None = None
    in_all: bool = True
    shows_unions: bool = False

    @property
    def adapters(self) -> tuple[Adapter, ...]:
        return tuple(self.adapter(method) for method in self.methods)

    def adapter(self, method: Method) -> Adapter:
        arguments = (method.argument,) if method.argument else ()
        of_all = (self.kind, method.program or self.program, self.source, self.licence)
        return Adapter(method.name, method.title, *of_all, arguments, self.home)
