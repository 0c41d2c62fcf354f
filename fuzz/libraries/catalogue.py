"""The adapters that come with the project: what each is, whether it is there, how it is got.

install(name)   gets what it needs into a folder of its own; does nothing where that is there
command(name)   the words that start it, None where it is not installed
absence(name)   None, or a sentence that says what is missing and how to get it
"""

from __future__ import annotations

import os
import pkgutil
import re
import shutil
import sys
from dataclasses import replace
from importlib import import_module
from pathlib import Path

from minkref.errors import Refusal, choice
from minkref.fuzz.cgal.executables import BUILD_COMMAND, search_folders
from minkref.fuzz.isolation.own_folders import adapters_folder
from minkref.fuzz.libraries import installation, other_languages
from minkref.fuzz.libraries.library import Adapter, Library

HERE = Path(__file__).parent
INSTALL_COMMAND = "minkref adapter install"
VERSION = re.compile(r"[0-9][0-9A-Za-z.]{0,30}")
RUN = HERE.parent / "adapters" / "run_program.py"  # beside modules that Python programs import
OPENSCAD = "openscad"
ASKED_FOR = ("pyclipr", "coal")  # pip builds it, with sources that the build fetches; 450 MB


def _libraries() -> dict[str, Library]:
    """Maps folder names to libraries, in the order of their places."""
    folders = [each.name for each in pkgutil.iter_modules([str(HERE)]) if each.ispkg]
    found = {f: import_module(f"minkref.fuzz.libraries.{f}").LIBRARY for f in folders}
    return dict(sorted(found.items(), key=lambda item: item[1].place))


LIBRARIES = _libraries()
ADAPTERS = {adapter.name: adapter for library in LIBRARIES.values() for adapter in library.adapters}


def adapter_named(name: str) -> Adapter:
    """Refuses unknown names, and names with an unknown part."""
    if name in ADAPTERS:
        return ADAPTERS[name]
    other = _other_version(name)
    if other is not None:
        return other
    library = _reader_of(name)
    if library is None or library.read is None:
        raise Refusal(f"there is no adapter {name[:60]!r}", "adapter", choice(name, ADAPTERS))
    return library.adapter(library.read(name))


def is_named(name: str) -> bool:
    """Whether the name is listed, or a library reads names that begin so."""
    return name in ADAPTERS or _other_version(name) is not None or _reader_of(name) is not None


def in_all(name: str) -> bool:
    """Whether the group of all targets has the adapter."""
    return all(each.in_all for each in LIBRARIES.values() if adapter_named(name) in each.adapters)


def _other_version(name: str) -> Adapter | None:
    """The adapter of NAME@VERSION, if NAME is a package of Python: in a folder of its own."""
    base, _, number = name.partition("@")
    adapter = ADAPTERS.get(base)
    if adapter is None or adapter.kind != "python" or not VERSION.fullmatch(number):
        return None
    home, title = f"{adapter.home}@{number}", f"{adapter.title}, {adapter.home} {number}"
    return replace(adapter, name=name, home=home, title=title)


def _reader_of(name: str) -> Library | None:
    reading = (each for each in LIBRARIES.values() if each.read is not None)
    return next((each for each in reading if name.startswith(each.targets)), None)


def install(name: str, folder: Path | None = None) -> None:
    """Installs everything the adapter needs. Raises Refusal if impossible."""
    adapter = adapter_named(name)
    if adapter.kind == "debian":
        installation.install_package(OPENSCAD, OPENSCAD)
    elif adapter.kind == "cgal" and absence(name, folder) is not None:
        raise Refusal("it is built with the project", name, BUILD_COMMAND, "not-installed")
    elif adapter.home:
        installation.install_home(_home(adapter, folder), adapter.kind, adapter.program)


def in_everything(name: str) -> bool:
    """Whether `adapter install all` installs the adapter: toolchains such as Rust have to be asked
    for, and so has a package that is large or without a wheel, or a language whose tools are
    missing."""
    if adapter_named(name).home in ASKED_FOR:
        return False
    language = other_languages.LANGUAGES.get(adapter_named(name).kind)
    return language is None or not (language.asked or shutil.which(language.tool) is None)


def command(name: str, folder: Path | None = None) -> list[str] | None:
    """Returns the words that start the adapter, None if not installed or not up to date."""
    adapter = adapter_named(name)
    if absence(name, folder) is not None:
        return None
    program = [str(RUN), str(HERE / adapter.program)]
    if adapter.kind == "python":
        start = [str(installation.interpreter(_home(adapter, folder))), *program]
    elif adapter.kind == "c++":
        start = [str(installation.binary(_home(adapter, folder)))]
    elif adapter.kind in other_languages.LANGUAGES:
        start = other_languages.start(adapter.kind, _home(adapter, folder))
    elif adapter.kind == "cgal":
        start = [str(_cgal_program(adapter))]
    else:
        start = [sys.executable, *program]
    return [*start, *adapter.arguments]


def absence(name: str, folder: Path | None = None) -> str | None:
    """Names the missing part, and the command that gets it; None if the adapter can start."""
    adapter = adapter_named(name)
    if adapter.kind == "debian":
        return installation.missing_package(OPENSCAD, OPENSCAD)
    if adapter.kind == "cgal":
        built = _cgal_program(adapter)
        return None if built else f"{adapter.program} is not built: {BUILD_COMMAND}"
    if adapter.kind == "own":
        return None
    state = installation.state_of(_home(adapter, folder), adapter.kind, adapter.program)
    return f"{name} is {state}: {INSTALL_COMMAND} {name}" if state else None


def _home(adapter: Adapter, folder: Path | None) -> Path:
    return (folder or adapters_folder()).absolute() / adapter.home


def _cgal_program(adapter: Adapter) -> Path | None:
    paths = (folder / adapter.program for folder in search_folders())
    return next((path for path in paths if path.is_file() and os.access(path, os.X_OK)), None)
