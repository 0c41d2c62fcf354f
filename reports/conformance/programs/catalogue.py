"""Which program shows a finding, by the name of its target."""

from __future__ import annotations

from collections.abc import Callable

from minkref.fuzz.cgal.executables import METHOD_GROUPS, method_of_target
from minkref.fuzz.run.runner import Finding
from minkref.reports.conformance.programs.boost_polygon import boost_polygon_sum
from minkref.reports.conformance.programs.cgal import cgal_sum
from minkref.reports.conformance.programs.cgal_space import cgal_space_sum
from minkref.reports.conformance.programs.clipper2 import clipper2_sum
from minkref.reports.conformance.programs.manifold import manifold_sum
from minkref.reports.conformance.programs.openscad import openscad_sum
from minkref.reports.conformance.programs.program import Program
from minkref.reports.conformance.programs.sfcgal import sfcgal_sum

Maker = Callable[[Finding, str], Program | None]

_MAKERS: dict[str, Maker] = {
    "clipper2": clipper2_sum,
    "clipper2-region": clipper2_sum,
    "clipper2-double": clipper2_sum,
    "boost-polygon": boost_polygon_sum,
    "manifold3d": manifold_sum,
    "pysfcgal": sfcgal_sum,
    "pysfcgal-space": sfcgal_sum,
    "openscad": openscad_sum,
    "cgal-nef": cgal_space_sum,
    "cgal-hull": cgal_space_sum,
}
_LIBRARIES = {
    "clipper2": "Clipper2",
    "boost-polygon": "Boost.Polygon",
    "manifold3d": "Manifold",
    "pysfcgal": "SFCGAL",
    "openscad": "OpenSCAD",
    "cgal-": "CGAL",
    "minkref": "minkref",
}


def program(finding: Finding, name: str) -> Program | None:
    """The program, its file called `name`; None where there is none (`why_none`)."""
    maker = _maker(finding.outcome.target)
    return maker(finding, name) if maker else None


def why_none(finding: Finding) -> str:
    """A sentence for a finding that has no program."""
    if _maker(finding.outcome.target):
        return "No program: the library is not called with such operands."
    if finding.outcome.target.startswith("minkref"):
        return "No program: this is minkref itself; the line above shows it."
    return "No program: the adapter or function is itself the program that shows it."


def library(target: str) -> str:
    """The name of the accused library; that of the target where it is none that we know."""
    return next((name for start, name in _LIBRARIES.items() if target.startswith(start)), target)


def _maker(target: str) -> Maker | None:
    if target in _MAKERS:
        return _MAKERS[target]
    if target.startswith("cgal-") and method_of_target(target)[0] in METHOD_GROUPS:
        return cgal_sum
    return None
