"""`minkref opening`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import MorphologyRequest, only_in_plane

EXAMPLES = """Examples:

minkref opening glyph1204 g1 --scale 30

minkref opening P.wkt tool.wkt -o reached.svg

minkref opening P.wkt tool.wkt -o reached.wkt --json"""

TOLD = """\
The opening of P, scaled by S about the origin, by Q: all copies of Q within the scaled P
    together, that is, the erosion by Q plus Q. Copies that fit exactly count. Exact, in canonical
    form."""

command = command_of(
    "opening",
    TOLD,
    only_in_plane("opening", "minkref.plane.commands.erode:run_opening", MorphologyRequest),
)
