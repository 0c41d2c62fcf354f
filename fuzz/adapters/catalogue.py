"""The adapters that come with the project: what each is, whether it is there, how it is got.

install(name)   gets what it needs into a folder of its own; does nothing where that is there
command(name)   the words that start it, None where it is not installed
absence(name)   None, or a sentence that says what is missing and how to get it
"""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path

from minkref.errors import Refusal, choice
from minkref.fuzz.adapters import installation
from minkref.fuzz.cgal.executables import BUILD_COMMAND, search_folders

HERE = Path(__file__).parent
INSTALL_COMMAND = "minkref adapter install"
CGAL_PROGRAM = "minkref-cgal-space"
OPENSCAD = "openscad"


@dataclass(frozen=True)
class Adapter:
    """`kind` is how it is had: `python` (an environment of its own), `c++` (compiled), `debian`
    (a package of the system), `cgal` (built with the project), `own` (always there). `home` is the
    folder of what is installed, which adapters may share."""

    name: str
    title: str
    kind: str
    program: str
    arguments: tuple[str, ...]
    home: str
    language: str
    source: str
    licence: str


def _clipper2(name: str, title: str, mode: str) -> Adapter:
    source = "Clipper2 2.0.1, from the source distribution of pyclipr 0.1.8 (PyPI)"
    program = "clipper2_adapter.cpp"
    return Adapter(name, title, "c++", program, (mode,), "clipper2", "C++", source, "BSL-1.0")


def _sfcgal(name: str, title: str, mode: str) -> Adapter:
    program, source = "pysfcgal_adapter.py", "pysfcgal 2.3.0 (PyPI)"
    licence = "GPL-3.0-or-later"
    return Adapter(name, title, "python", program, (mode,), "pysfcgal", "C++", source, licence)


def _own(name: str, title: str, arithmetic: str) -> Adapter:
    source, program = "this package", "minkref_adapter.py"
    return Adapter(name, title, "own", program, (arithmetic,), "", "C++", source, "Apache-2.0")


def _cgal(name: str, title: str, mode: str) -> Adapter:
    source, licence = "oracle/cgal, with the CGAL that the project finds", "GPL-3.0-or-later"
    return Adapter(name, title, "cgal", CGAL_PROGRAM, (mode,), "", "C++", source, licence)


_TABLE = (
    _clipper2("clipper2", "Clipper2, MinkowskiSum of two rings (their curves)", "boundary"),
    _clipper2("clipper2-region", "Clipper2, the region built on MinkowskiSum and Union", "region"),
    _clipper2("clipper2-double", "Clipper2, MinkowskiSum of doubles, two decimals", "double"),
    Adapter(
        name="boost-polygon",
        title="Boost.Polygon, the sum of its tutorial (convolve_two_polygon_sets)",
        kind="c++",
        program="boost_polygon_adapter.cpp",
        arguments=(),
        home="boost-polygon",
        language="C++",
        source="Boost of the system (Debian: libboost-dev)",
        licence="BSL-1.0",
    ),
    Adapter(
        name="manifold3d",
        title="Manifold, minkowski_sum in space",
        kind="python",
        program="manifold3d_adapter.py",
        arguments=(),
        home="manifold3d",
        language="C++",
        source="manifold3d 3.5.4 (PyPI)",
        licence="Apache-2.0",
    ),
    _sfcgal("pysfcgal", "SFCGAL, minkowski_sum in the plane", "plane"),
    _sfcgal("pysfcgal-space", "SFCGAL, minkowski_sum_3d", "space"),
    Adapter(
        name="openscad",
        title="OpenSCAD, minkowski() in the plane and in space",
        kind="debian",
        program="openscad_adapter.py",
        arguments=(),
        home="",
        language="C++",
        source="OpenSCAD of the system (Debian: openscad 2021.01)",
        licence="GPL-2.0-or-later",
    ),
    _cgal("cgal-nef", "CGAL, minkowski_sum_3 of Nef polyhedra", "nef"),
    _cgal("cgal-hull", "CGAL, convex_hull_3 of the sums of vertices (convex only)", "hull"),
    _own("minkref-double", "minkref in double arithmetic, without exactness", "double"),
    _own("minkref-mpfr53", "minkref in MPFR of 53 bits, without exactness", "mpfr:53"),
)
ADAPTERS = {adapter.name: adapter for adapter in _TABLE}


def default_folder() -> Path:
    """MINKREF_ADAPTERS, else build/adapters of the checkout, else below ~/.cache."""
    given = os.environ.get("MINKREF_ADAPTERS")
    if given:
        return Path(given)
    checkout = HERE.resolve().parents[1]
    if (checkout / "pyproject.toml").is_file():
        return checkout / "build" / "adapters"
    return Path.home() / ".cache" / "minkref" / "adapters"


def adapter_named(name: str) -> Adapter:
    if name not in ADAPTERS:
        raise Refusal(f"there is no adapter {name[:60]!r}", "adapter", choice(name, ADAPTERS))
    return ADAPTERS[name]


def install(name: str, folder: Path | None = None) -> None:
    """Gets what the adapter needs. Raises Refusal where that cannot be."""
    adapter = adapter_named(name)
    if adapter.kind == "debian":
        installation.install_package(OPENSCAD, OPENSCAD)
    elif adapter.kind == "cgal" and absence(name, folder) is not None:
        raise Refusal("it is built with the project", name, BUILD_COMMAND, "not-installed")
    elif adapter.kind in ("python", "c++"):
        installation.install_home(_home(adapter, folder), adapter.kind, adapter.program)


def command(name: str, folder: Path | None = None) -> list[str] | None:
    """The words that start the adapter, None where it is not installed or not up to date."""
    adapter = adapter_named(name)
    if absence(name, folder) is not None:
        return None
    program = str(HERE / adapter.program)
    if adapter.kind == "python":
        start = [str(installation.interpreter(_home(adapter, folder))), program]
    elif adapter.kind == "c++":
        start = [str(installation.binary(_home(adapter, folder)))]
    elif adapter.kind == "cgal":
        start = [str(_cgal_program())]
    else:
        start = [sys.executable, program]
    return [*start, *adapter.arguments]


def absence(name: str, folder: Path | None = None) -> str | None:
    """What is missing, and the command that gets it; None where the adapter can be started."""
    adapter = adapter_named(name)
    if adapter.kind == "debian":
        return installation.missing_package(OPENSCAD, OPENSCAD)
    if adapter.kind == "cgal":
        return None if _cgal_program() else f"{CGAL_PROGRAM} is not built: {BUILD_COMMAND}"
    if adapter.kind == "own":
        return None
    state = installation.state_of(_home(adapter, folder), adapter.kind, adapter.program)
    return f"{name} is {state}: {INSTALL_COMMAND} {name}" if state else None


def _home(adapter: Adapter, folder: Path | None) -> Path:
    return (folder or default_folder()).absolute() / adapter.home


def _cgal_program() -> Path | None:
    paths = (folder / CGAL_PROGRAM for folder in search_folders())
    return next((path for path in paths if path.is_file() and os.access(path, os.X_OK)), None)
