"""A library on trial: a folder here, whose `__init__.py` holds its LIBRARY."""

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
class Method:
    """One of the sums that a library has: the name and title of its adapter, and what tells it from
    the others on the command line."""

    name: str
    title: str
    argument: str = ""


@dataclass(frozen=True)
class Library:
    """`targets`: how the names of its targets begin. `place`: where it stands in lists.
    `has_program`: whether `program.py` beside it shows a finding with the library alone. The rest
    is alike for the adapters of all its methods."""

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

    @property
    def adapters(self) -> tuple[Adapter, ...]:
        return tuple(self._adapter(method) for method in self.methods)

    def _adapter(self, method: Method) -> Adapter:
        arguments = (method.argument,) if method.argument else ()
        of_all = (self.kind, self.program, self.source, self.licence)
        return Adapter(method.name, method.title, *of_all, arguments, self.home)
