"""`minkref difference FILE FILE...`"""

from __future__ import annotations

from minkref.cli.verb import Verb, command_anywhere
from minkref.verbs.set_request import SetRequest

EXAMPLES = """Examples:

minkref difference plate.wkt holes.geojson -o rest.wkt

minkref difference glyph275 "POLYGON ((0 0, 99 0, 99 99, 0 99, 0 0))" --plot

minkref difference a.wkt b.wkt c.wkt --json"""

TOLD = """\
The first set in the plane without all others: the closure of the rest. Exact, in canonical
form."""

command = command_anywhere(TOLD, Verb(SetRequest, "minkref.plane.commands.combine:run_difference"))
