"""`minkref nofit`: its options."""

from __future__ import annotations

from minkref.cli.verb import command_of
from minkref.verbs.erode_request import NoFitInSpace, NoFitRequest, without_disc

EXAMPLES = """Examples:

minkref nofit g1 g2

minkref nofit sheet.wkt part.wkt -o nofit.svg

minkref nofit "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 5, 5 5, 5 3, 3 3))" part.wkt --json

minkref nofit housing.off part.off --passages -o nofit.off"""

TOLD = """\
The no-fit polygon: all places of B, never turned, at which B meets A, scaled by S about the
    origin. Interiors overlap inside of it, the shapes touch on its boundary, and at the exact fits
    within it B touches A all around and overlaps nothing. A place is where B's origin comes to lie.
    Exact, in canonical form."""

command = command_of("nofit", TOLD, without_disc("nofit", NoFitRequest, NoFitInSpace))
