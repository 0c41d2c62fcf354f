"""Texts of plane sets for files, for each format."""

from __future__ import annotations

from minkref import _core
from minkref.errors import refusing
from minkref.output.output_target import Target

FORMS = ("wkt", "geojson", "poly", "json", "svg", "dxf")


def written_set(region: _core.PolygonSet, target: Target) -> tuple[str, bool]:
    """Return the text, and whether it holds the very set. Refuses what the format cannot hold."""
    if target.form == "dxf":
        from minkref.output.dxf import dxf_of_set

        return refusing(target.name, lambda: dxf_of_set(region, target.name))
    text = refusing(target.name, lambda: _core.write(region, target.form))
    return text, _core.writes_exactly(region, target.form)
