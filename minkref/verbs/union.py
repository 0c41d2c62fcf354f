"""`minkref union FILE...`"""

from __future__ import annotations

from minkref.cli.verb import Verb, command_anywhere
from minkref.verbs.set_request import UnionRequest

EXAMPLES = """Examples:

minkref union a.wkt b.geojson -o both.wkt

minkref union parcels.geojson -o repaired.geojson

minkref union g1 "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))" --plot

minkref union *.wkt --json

minkref union a.wkt b.wkt --certify both.cert.json"""

TOLD = """\
The union of sets in the plane, exact, in canonical form. A file whose polygons overlap or share
edges is no operand of `minkref sum`; its union is one."""

command = command_anywhere(TOLD, Verb(UnionRequest, "minkref.plane.commands.combine:run_union"))
