"""`minkref intersection FILE...`"""

from __future__ import annotations

from minkref.cli.verb import Verb, command_anywhere
from minkref.verbs.set_request import SetRequest

EXAMPLES = """Examples:

minkref intersection a.wkt b.geojson -o common.wkt

minkref intersection glyph275 "POLYGON ((0 0, 99 0, 99 99, 0 99, 0 0))" --plot

minkref intersection a.wkt b.wkt c.wkt --json"""

TOLD = """\
The intersection of sets in the plane: the closure of what their interiors share. Exact, in
canonical form."""

command = command_anywhere(
    TOLD, Verb(SetRequest, "minkref.plane.commands.combine:run_intersection")
)
