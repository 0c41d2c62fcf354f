"""`minkref closing`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import MorphologyRequest, only_in_plane

EXAMPLES = """Examples:

minkref closing glyph1204 g1 --scale 30

minkref closing P.wkt Q.wkt -o closed.svg

minkref closing P.wkt Q.wkt --scale 7/5 --json"""

TOLD = """\
The closing of P, scaled by S about the origin, by Q: the sum of the scaled P and Q, eroded
    by Q. Exact, in canonical form, with its remnants."""

command = command_of(
    "closing",
    TOLD,
    only_in_plane("closing", "minkref.plane.commands.erode:run_closing", MorphologyRequest),
)
